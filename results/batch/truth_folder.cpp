// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/batch/truth_folder.h"

#include <filesystem>

#include "isomatch/error.h"
#include "isomatch/measure/metrics.h"

namespace isomatch::results {
namespace {

namespace fs = std::filesystem;

std::string truth_file(const std::string& folder, const std::string& shape) {
  return (fs::path(folder) / fs::path(shape).stem()).string() + ".vts";
}

}  // namespace

TruthFiles truth_files(const std::string& folder, const ListedPair& pair) {
  if (folder.empty()) return {};
  return {truth_file(folder, pair.source), truth_file(folder, pair.target)};
}

void check_truth(const std::string& folder, const std::vector<ListedPair>& pairs) {
  if (folder.empty()) return;
  for (const ListedPair& pair : pairs)
    for (const std::string& shape : {pair.source, pair.target}) {
      const std::string file = truth_file(folder, shape);
      std::error_code error;
      if (!fs::is_regular_file(file, error))
        throw BadFile(file, "is not there: --truth needs one for " + shape);
    }
}

std::optional<double> mean_point_error(const Shape& source, const Shape& target,
                                       const TruthVertices& truth, const SurfaceMap& map,
                                       const Context& context) {
  if (truth.target.empty()) return std::nullopt;
  const ErrorStatistics errors =
      point_errors(source, target, {truth.source, truth.target}, map, {}, context);
  if (errors.samples == 0) return std::nullopt;
  return errors.mean;
}

}  // namespace isomatch::results
