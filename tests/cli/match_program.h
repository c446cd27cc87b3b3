// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "isomatch/io/map_file.h"
#include "isomatch/io/mesh_io.h"
#include "isomatch/mesh/synth.h"
#include "support/mesh_files.h"
#include "support/temporary_folder.h"
#include "support/transforms.h"

namespace isomatch::test {

/// A creature in two poses; to the target a small tetrahedron is added, with the lowest numbers.
class MatchProgram : public testing::Test {
 protected:
  static constexpr int kExtraVertices = 4;

  void SetUp() override {
    write_mesh(path("source.off"), source_);
    write_mesh(path("target.ply"), target_);
  }

  std::string path(const std::string& name) const { return folder_.path(name); }

  std::vector<std::string> arguments(const std::string& folder,
                                     const std::vector<std::string>& more = {}) const {
    std::vector<std::string> all{"match", path("source.off"), path("target.ply"), "-o",
                                 path(folder)};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

  std::string bytes(const std::string& name) const { return read_file(path(name)); }
  nlohmann::json json(const std::string& name) const { return nlohmann::json::parse(bytes(name)); }

  MapChecks counts() const {
    return {source_.num_vertices(), target_.num_vertices(), target_.num_faces()};
  }

  static SynthShape creature(int pose) {
    return synthesize({.vertices = 1000, .pose = pose, .seed = 3});
  }

  const Mesh source_ = creature(1).mesh;
  const Mesh target_ = combined(scaled(tetrahedron(), 0.01), creature(2).mesh);
  TemporaryFolder folder_;
};

}  // namespace isomatch::test
