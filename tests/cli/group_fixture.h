// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "isomatch/io/map_file.h"
#include "isomatch/io/mesh_io.h"
#include "isomatch/maps/surface_map.h"
#include "isomatch/mesh/synth.h"
#include "isomatch/mesh/topology.h"
#include "program.h"
#include "support/shapes.h"
#include "support/temporary_folder.h"

namespace isomatch::test {

/// Four poses of a creature, a part of a fifth one and a bad file, matched once for all tests, and
/// small shapes, which tests match in a moment.
class Group : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    shared_ = std::make_unique<TemporaryFolder>();
    std::filesystem::create_directories(shared_->path("shapes"));
    for (const char* name : {"a", "b", "c", "d", "part"})
      write_mesh(shape(name), creature(name).mesh);
    std::filesystem::create_directories(shared_->path("small"));
    for (int number = 0; number < 3; ++number)
      write_mesh(small(std::string(1, static_cast<char>('a' + number))), lump(number));
    shared_->write("shapes/bad.off", "OFF\n3 1 0\n0 0 zero\n");
    whole_ = std::make_unique<Outcome>(
        run({"group", shared_->path("shapes"), "--template", "a", "-o", shared_->path("whole")}));
  }
  static void TearDownTestSuite() { shared_.reset(); }

  static SynthShape creature(const std::string& name) {
    if (name == "part") return synthesize({.vertices = 1000, .pose = 4, .seed = 3, .cut = 0.3});
    return synthesize({.vertices = 1000, .pose = name[0] - 'a', .seed = 3});
  }

  static std::string shape(const std::string& name) {
    return shared_->path("shapes/" + name + ".off");
  }
  static std::string small(const std::string& name) {
    return shared_->path("small/" + name + ".off");
  }
  static std::string whole(const std::string& name) { return shared_->path("whole/" + name); }
  std::string path(const std::string& name) const { return folder_.path(name); }

  static std::string from_template(const std::string& name) {
    return "maps/" + name + ".from_template.bary.txt";
  }
  static std::string mesh_file(const std::string& name) { return "meshes/" + name + ".ply"; }

  Outcome group(const std::string& folder, const std::vector<std::string>& shapes,
                const std::vector<std::string>& more = {}, const std::string& template_name = "a",
                const RunOptions& options = {}) const {
    std::vector<std::string> words{"group", "-o", path(folder)};
    if (shapes.size() > 1 || template_name != "a")
      words.insert(words.end(), {"--template", template_name});
    words.insert(words.end(), more.begin(), more.end());
    words.insert(words.end(), shapes.begin(), shapes.end());
    return run(words, options);
  }

  nlohmann::json report(const std::string& folder) const {
    return nlohmann::json::parse(
        read_file(folder == "whole" ? whole("report.json") : path(folder + "/report.json")));
  }

  static std::vector<std::string> lines(const std::string& file) {
    std::vector<std::string> lines;
    std::istringstream text(read_file(file));
    for (std::string line; std::getline(text, line);) lines.push_back(line);
    return lines;
  }

  /// Mean distance from the true places of what both shapes have, over sqrt(area).
  static double mean_error(const SynthShape& source, const SynthShape& target,
                           const SurfaceMap& map) {
    double sum = 0;
    int count = 0;
    for (std::size_t t = 0; t < source.ground_truth.size(); ++t) {
      const int from = source.ground_truth[t], onto = target.ground_truth[t];
      if (from < 0 || onto < 0 || map[from].face == kNoFace) continue;
      sum += (position(target.mesh, map[from]) - target.mesh.vertices[onto]).norm();
      ++count;
    }
    return sum / count / std::sqrt(surface_area(target.mesh));
  }

  inline static std::unique_ptr<TemporaryFolder> shared_;
  inline static std::unique_ptr<Outcome> whole_;
  TemporaryFolder folder_;
};

}  // namespace isomatch::test
