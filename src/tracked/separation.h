// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "isomatch/context.h"
#include "tracked/hypotheses/judging.h"
#include "tracked/options.h"
#include "tracked/shape/pyramid.h"
#include "tracked/tracks/refinement.h"

namespace isomatch::tracked {

/// The target, the source, and the source's mirror image if that may match as well.
using Pyramids = std::vector<std::shared_ptr<const Pyramid>>;

/// Hypotheses of all sources, least cost first.
Candidates all_judged(const Pyramids& pyramids, const Options& options, const Context& context);

/// Takes parts that touch apart, such as a hand that was fused to a hip.
class Separation {
 public:
  /// Gives the pyramid of the same number with another view.
  using Make = std::function<std::shared_ptr<const Pyramid>(std::size_t, const View&)>;

  /// Keeps a reference to the options.
  Separation(const Pyramids& pyramids, Make make, const Options& options, const Context& context);

  /// Whether any shape may have such parts.
  bool is_possible() const;
  /// Opens the handles for which hypotheses agree better: `candidates` are those of `pyramids`, and
  /// both are replaced. Does nothing where no shape may have such parts.
  void open_handles(Pyramids& pyramids, Candidates& candidates, const Context& context) const;
  /// The pyramids with cuts where a track tears the surfaces: those given if there are none.
  Pyramids cut_where_torn(const Pyramids& pyramids, const Track& track,
                          const std::vector<int>& nearest) const;

 private:
  std::shared_ptr<const Pyramid> with_cut(const Pyramids& pyramids, std::size_t k, Cut cut) const;

  Make make_;
  const Options& options_;
  /// Of each pyramid, see `possible_cuts`.
  std::vector<std::vector<Cut>> cuts_;
};

}  // namespace isomatch::tracked
