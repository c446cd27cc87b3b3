// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <typeindex>

#include "isomatch/shape/shape.h"
#include "shape/memo.h"
#include "shape/metric_surface.h"
#include "shape/surface.h"

namespace isomatch {

/// All that the library knows of a shape. Safe to share by threads.
class PreparedShape {
 public:
  PreparedShape(Mesh mesh, const GeodesicOptions& geodesics);

  const Mesh& mesh() const { return mesh_; }
  const MeshDiagnosis& diagnosis() const { return diagnosis_; }
  const std::shared_ptr<const Surface>& surface() const { return surface_; }

  /// What is made when it is first asked for. Throws `Cancelled`.
  std::shared_ptr<const GeodesicGraph> graph(const GeodesicOptions& options,
                                             const Context& context) const;
  /// With the geodesics that the shape was made for.
  MetricSurface metric(const Context& context) const;

  /// What a stage keeps with the shape: the same object each time, which must be safe to share by
  /// threads.
  template <class Kept>
  Kept& kept() const {
    const std::lock_guard lock(keeping_);
    std::shared_ptr<void>& place = kept_[typeid(Kept)];
    if (!place) place = std::make_shared<Kept>();
    return *static_cast<Kept*>(place.get());
  }

 private:
  Mesh mesh_;
  GeodesicOptions geodesics_;
  MeshDiagnosis diagnosis_;
  std::shared_ptr<const Surface> surface_;
  mutable Memo<GeodesicOptions, GeodesicGraph> graphs_;
  mutable Memo<bool, double> max_geodesic_;
  mutable std::mutex keeping_;
  mutable std::map<std::type_index, std::shared_ptr<void>> kept_;
};

}  // namespace isomatch
