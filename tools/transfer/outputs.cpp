// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "transfer/outputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <vector>

#include "isomatch/error.h"
#include "isomatch/io/map_file.h"
#include "isomatch/io/mesh_io.h"
#include "results/files/outputs.h"
#include "results/files/written_files.h"

namespace isomatch::cli {
namespace {

namespace fs = std::filesystem;

results::InputFiles inputs_of(const TransferArguments& arguments) {
  results::InputFiles inputs = results::result_inputs(arguments.folder, arguments.places);
  for (const std::string& file :
       {arguments.values, arguments.labels, arguments.colors, arguments.landmarks, arguments.skin,
        arguments.texture, arguments.image})
    inputs.add(file);
  for (const std::string& frame : arguments.poses) inputs.add(frame);
  return inputs;
}

void check_frames(const TransferArguments& arguments, const results::InputFiles& inputs) {
  std::vector<std::string> names;
  for (const std::string& frame : arguments.poses) names.push_back(frame_name(frame));
  std::ranges::sort(names);
  if (const auto twice = std::ranges::adjacent_find(names); twice != names.end())
    throw BadFile(*twice, "two frames would be written to this name");
  results::check_folder_name(arguments.output);
  results::check_folder_output(arguments.output);
  names.emplace_back(results::kTransfer);
  results::check_replaceable(arguments.output, names, results::Listing::kOfTransfer, inputs);
}

/// Numbers may have any ending that promises nothing else.
void check_number_ending(const std::string& path, bool may_be_csv) {
  constexpr std::array kOthers{".html", ".jpeg", ".jpg", ".json", ".npy", ".npz", ".png", ".zip"};
  const std::string ending = results::lower_ending(path);
  if (is_mesh_file_name(path) || std::ranges::count(kOthers, ending) > 0 ||
      (ending == ".csv" && !may_be_csv))
    throw BadFile(path, fmt::format("numbers are written as text here; name it .txt{}",
                                    may_be_csv ? " or .csv" : ""));
}

void check_endings(const TransferArguments& arguments) {
  if (!arguments.values.empty() || !arguments.labels.empty())
    check_number_ending(arguments.output, true);
  if (!arguments.skin.empty()) check_number_ending(arguments.output, false);
  if (!arguments.colors.empty()) results::check_ending(arguments.output, {".ply"});
  if (!arguments.texture.empty()) results::check_ending(arguments.output, {".obj"});
  if (!arguments.landmarks.empty()) check_map_output(arguments.output);
}

}  // namespace

std::string frame_name(const std::string& frame) {
  return fs::path(frame).filename().replace_extension(".ply").string();
}

std::string material_output(const std::string& output) {
  return fs::path(output).replace_extension(".mtl").string();
}

void check_transfer(const TransferArguments& arguments) {
  const results::InputFiles inputs = inputs_of(arguments);
  if (!arguments.poses.empty()) return check_frames(arguments, inputs);
  check_endings(arguments);
  if (const std::string& image = arguments.image; !image.empty() && !fs::exists(image))
    throw BadFile(image, "is not there");
  results::check_output(arguments.output, inputs);
  if (!arguments.texture.empty())
    results::check_companion_output(material_output(arguments.output), arguments.output, inputs);
}

}  // namespace isomatch::cli
