// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "match/tracked_options.h"

namespace isomatch::cli {

void add_tracked_options(CLI::App& command, const std::string& group, TrackedOptions& options) {
  command
      .add_flag("--whole", options.whole,
                "Nothing of the shapes is missing, whatever their boundaries: match everything")
      ->group(group);
  command
      .add_option("--scale", options.scale,
                  "What makes sizes alike: same units, the same area, or auto: the area of whole "
                  "shapes, the units of parts")
      ->check(CLI::IsMember({"auto", "same", "area"}))
      ->group(group)
      ->capture_default_str();
  command
      .add_flag("--allow-reflection", options.allow_reflection,
                "Try to match the mirror image of the source as well")
      ->group(group);
  command
      .add_flag("!--no-orientation", options.orientation,
                "Grow hypotheses by distances along the surface alone")
      ->group(group);
  command
      .add_flag("!--no-elastic-judging", options.elastic_judging,
                "Choose by distortion and orientation instead of elastic energy")
      ->group(group);
  command
      .add_flag("!--no-refinement", options.refinement, "Stop after a first, coarse registration")
      ->group(group);
}

void add_map_options(CLI::App& command, const std::string& group, TrackedOptions& options,
                     bool& target_to_source) {
  command.add_option("--alternatives", options.alternatives, "Maps to write besides the best one")
      ->type_name("N")
      ->check(CLI::NonNegativeNumber)
      ->group(group)
      ->capture_default_str();
  command.add_flag("--target-to-source", target_to_source, "Write the inverse map as well")
      ->group(group);
}

}  // namespace isomatch::cli
