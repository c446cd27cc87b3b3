// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "transfer/job.h"

#include <filesystem>
#include <utility>

#include "isomatch/carry/map_inversion.h"
#include "isomatch/error.h"
#include "isomatch/io/map_file.h"

namespace isomatch::cli {
namespace {

SurfaceMap load_inverse(const results::MatchResult& result, const results::ResultMap& map,
                        const Context& context) {
  const std::string path =
      result.path((std::filesystem::path(map.folder) / "target_to_source.bary.txt").string());
  if (std::filesystem::exists(path))
    return read_map(path, {.source_vertices = result.target.num_vertices(),
                           .target_faces = result.source.num_faces()})
        .points;
  return invert_map(result.source, result.target, map.points, {}, context);
}

}  // namespace

TransferJob load_transfer(const TransferArguments& arguments, const Context& context) {
  results::MatchResult result = results::load_result(arguments.folder, arguments.places);
  if (arguments.alternative >= result.maps.size())
    throw BadFile(arguments.folder, "has no alternative " + std::to_string(arguments.alternative));
  results::ResultMap& map = result.maps[arguments.alternative];
  SurfaceMap inverse = load_inverse(result, map, context);
  if (arguments.reverse)
    return {result.target_path, std::move(result.target), std::move(result.source),
            std::move(map.points), std::move(inverse)};
  return {result.source_path, std::move(result.source), std::move(result.target),
          std::move(inverse), std::move(map.points)};
}

}  // namespace isomatch::cli
