// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "paper/distortion.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "isomatch/error.h"
#include "isomatch/methods/paper.h"
#include "parallel.h"

namespace isomatch {

std::vector<std::span<const float>> FieldStore::fields(std::span<const int> sources,
                                                       const Context& context) {
  ++uses_;
  std::vector<std::pair<int, std::vector<float>*>> missing;
  for (int source : sources) {
    const auto [entry, is_new] = entries_.try_emplace(source);
    entry->second.last_use = uses_;
    if (is_new) missing.emplace_back(source, &entry->second.field);
  }
  const float scale = static_cast<float>(1 / shape_->max_geodesic());
  const auto measure = [&](GeodesicSearch& search, std::ptrdiff_t i) {
    std::vector<float>& field = *missing[i].second;
    field.resize(shape_->num_vertices());
    search.field(missing[i].first, field);
    for (float& distance : field) distance *= scale;
  };
  try {
    parallel_for(
        std::ssize(missing), context, [&] { return GeodesicSearch(shape_->graph()); }, measure);
  } catch (...) {
    for (const auto& [source, field] : missing) entries_.erase(source);
    throw;
  }
  forget_least_used();
  std::vector<std::span<const float>> result;
  for (int source : sources) result.push_back(entries_.find(source)->second.field);
  return result;
}

void FieldStore::forget_least_used() {
  if (static_cast<int>(entries_.size()) <= capacity_) return;
  std::vector<std::pair<long, int>> by_use;
  for (const auto& [source, entry] : entries_) by_use.emplace_back(entry.last_use, source);
  std::sort(by_use.begin(), by_use.end());
  const std::size_t surplus = entries_.size() - capacity_;
  for (std::size_t i = 0; i < surplus && by_use[i].first < uses_; ++i)
    entries_.erase(by_use[i].second);
}

LandmarkDistances::LandmarkDistances(FieldStore& store, std::span<const int> rows,
                                     std::span<const int> landmarks, const Context& context)
    : columns_(landmarks.size()), values_(rows.size() * landmarks.size()) {
  const std::vector<std::span<const float>> fields = store.fields(landmarks, context);
  parallel_for(std::ssize(rows), context, [&](std::ptrdiff_t r) {
    for (std::size_t e = 0; e < columns_; ++e) values_[r * columns_ + e] = fields[e][rows[r]];
  });
}

MatchDistortion::MatchDistortion(FieldStore& source, std::span<const int> source_rows,
                                 FieldStore& target, std::span<const int> target_rows,
                                 const Correspondence& list, const Context& context)
    : own_entry_(source_rows.size(), -1) {
  std::vector<int> source_landmarks, target_landmarks;
  for (std::size_t e = 0; e < list.size(); ++e) {
    int& entry = own_entry_[list[e].source];
    if (entry >= 0) throw InvalidInput("a source occurs twice in the list of matches");
    entry = static_cast<int>(e);
    source_landmarks.push_back(source_rows[list[e].source]);
    target_landmarks.push_back(target_rows[list[e].target]);
  }
  source_ = LandmarkDistances(source, source_rows, source_landmarks, context);
  target_ = LandmarkDistances(target, target_rows, target_landmarks, context);
}

double MatchDistortion::operator()(int source_row, int target_row) const {
  const std::span<const float> a = source_.row(source_row), b = target_.row(target_row);
  float sum = 0;
#pragma omp simd reduction(+ : sum)
  for (std::size_t e = 0; e < a.size(); ++e) sum += std::abs(a[e] - b[e]);
  const int own = own_entry_[source_row];
  if (own < 0) return a.empty() ? 0 : sum / static_cast<double>(a.size());
  if (a.size() == 1) return 0;
  return (sum - std::abs(a[own] - b[own])) / static_cast<double>(a.size() - 1);
}

std::vector<double> MatchDistortion::of(const Correspondence& matches) const {
  std::vector<double> values;
  values.reserve(matches.size());
  for (const Match& match : matches) values.push_back((*this)(match.source, match.target));
  return values;
}

MatchDistortion landmark_distortion(const SampledLevel& level,
                                    std::span<const int> target_of_source,
                                    FieldStore& source_fields, FieldStore& target_fields,
                                    const Context& context) {
  Correspondence list;
  for (int landmark : level.landmarks) list.push_back({landmark, target_of_source[landmark]});
  return {source_fields, level.source.sampling.bases,
          target_fields, level.target.sampling.bases,
          list,          context};
}

DistortionSummary summarize(std::span<const double> d_iso) {
  if (d_iso.empty()) return {};
  const double sum = std::accumulate(d_iso.begin(), d_iso.end(), 0.0);
  return {sum / static_cast<double>(d_iso.size()), *std::ranges::max_element(d_iso)};
}

}  // namespace isomatch
