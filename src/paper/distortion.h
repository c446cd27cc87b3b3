// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <span>
#include <unordered_map>
#include <vector>

#include "isomatch/context.h"
#include "isomatch/maps/correspondence.h"
#include "paper/sampling.h"
#include "shape/metric_surface.h"

namespace isomatch {

/// Geodesic distance fields over a shape, over its largest geodesic distance, so in [0, 1]. Keeps
/// the most recently used, since the lists of consecutive levels have most landmarks in common.
class FieldStore {
 public:
  /// Keeps a reference to `shape`. Memory 4 `capacity` N bytes.
  explicit FieldStore(const MetricSurface& shape, int capacity = 300)
      : shape_(&shape), capacity_(capacity) {}

  const MetricSurface& shape() const { return *shape_; }
  /// The fields of `sources` (vertices, repetition allowed), each of N values; those not stored are
  /// computed in parallel. Valid until the next call.
  std::vector<std::span<const float>> fields(std::span<const int> sources,
                                             const Context& context = {});

 private:
  struct Entry {
    std::vector<float> field;
    long last_use = 0;
  };

  void forget_least_used();

  const MetricSurface* shape_;
  int capacity_;
  long uses_ = 0;
  std::unordered_map<int, Entry> entries_;
};

/// Geodesic distances between some vertices (rows) and some landmarks (columns): one contiguous row
/// a vertex, so that the isometric distortion of a match is the mean L1 distance of two rows.
class LandmarkDistances {
 public:
  LandmarkDistances() = default;
  LandmarkDistances(FieldStore& store, std::span<const int> rows, std::span<const int> landmarks,
                    const Context& context = {});

  int num_landmarks() const { return static_cast<int>(columns_); }
  std::span<const float> row(int index) const {
    return {values_.data() + static_cast<std::size_t>(index) * columns_, columns_};
  }

 private:
  std::size_t columns_ = 0;
  std::vector<float> values_;
};

/// The isometric distortion d_iso of single matches against a list of matches (Equation 2).
///
/// Rows are numbered as the vertices given to the constructor. A match's own source is left out of
/// the list, so that alternatives for the source of a listed match compete on equal terms.
class MatchDistortion {
 public:
  /// Against an empty list: zero everywhere.
  MatchDistortion() = default;
  /// Measures matches between `source_rows` and `target_rows` (vertices) against `list`
  /// (indices into the rows). Throws `InvalidInput` if a source occurs twice in the list.
  MatchDistortion(FieldStore& source, std::span<const int> source_rows, FieldStore& target,
                  std::span<const int> target_rows, const Correspondence& list,
                  const Context& context = {});

  /// d_iso of the match between two rows, in [0, 1]; 0 against an empty list. O(E).
  double operator()(int source_row, int target_row) const;
  /// d_iso of each of `matches`, whose indices are rows.
  std::vector<double> of(const Correspondence& matches) const;
  /// E, the number of matches in the list.
  int list_size() const { return source_.num_landmarks(); }

 private:
  LandmarkDistances source_, target_;
  /// For each source row its place in the list or -1.
  std::vector<int> own_entry_;
};

/// d_iso between all bases of `level` against the matches of its landmarks.
MatchDistortion landmark_distortion(const SampledLevel& level,
                                    std::span<const int> target_of_source,
                                    FieldStore& source_fields, FieldStore& target_fields,
                                    const Context& context = {});

}  // namespace isomatch
