// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "isomatch/error.h"
#include "isomatch/io/mesh_io.h"
#include "isomatch/io/model_io.h"
#include "support/gltf_files.h"
#include "support/mat_files.h"
#include "support/mesh_files.h"
#include "support/temporary_folder.h"

/// Damaged files of every kind: whatever is done to them, a reader throws `BadFile` or returns a
/// mesh that passes `validate`.
namespace isomatch {
namespace {

using test::bytes;

constexpr int kMutationsPerSample = 4000;

struct Sample {
  const char* name;
  const char* ending;
  std::string content;
};

std::string binary_ply(std::endian order) {
  std::string content = order == std::endian::little ? "ply\nformat binary_little_endian 1.0\n"
                                                     : "ply\nformat binary_big_endian 1.0\n";
  content +=
      "comment sample\nelement vertex 4\nproperty list uchar short ring\nproperty float x\n"
      "property double y\nproperty short z\nproperty uchar red\nelement other 2\n"
      "property int value\nelement face 2\nproperty list uchar uint vertex_indices\n"
      "property list int float texcoord\nelement tristrips 1\n"
      "property list int int vertex_indices\nend_header\n";
  for (std::int16_t v = 0; v < 4; ++v)
    content += bytes<std::uint8_t>(order, {2}) + bytes<std::int16_t>(order, {1, 2}) +
               bytes<float>(order, {1.5F}) + bytes<double>(order, {0.1 * v}) +
               bytes<std::int16_t>(order, {v}) + bytes<std::uint8_t>(order, {255});
  content += bytes<std::int32_t>(order, {7, 8});
  content += bytes<std::uint8_t>(order, {3}) + bytes<std::uint32_t>(order, {0, 1, 2}) +
             bytes<std::int32_t>(order, {1}) + bytes<float>(order, {0.5F});
  content += bytes<std::uint8_t>(order, {4}) + bytes<std::uint32_t>(order, {0, 1, 2, 3}) +
             bytes<std::int32_t>(order, {0});
  return content + bytes<std::int32_t>(order, {8, 0, 1, 2, 3, -1, 2, 1, 0});
}

std::string binary_stl() {
  std::string content = "solid sample";
  content.resize(80, ' ');
  content += bytes<std::uint32_t>(std::endian::little, {2});
  for (const float z : {1.0F, 2.0F})
    content += bytes<float>(std::endian::little, {0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, z}) +
               bytes<std::uint16_t>(std::endian::little, {0});
  return content;
}

/// With nodes, strips, sparse values and two parts.
test::GltfText gltf_sample() {
  return {.parts = R"({"attributes":{"POSITION":0},"indices":1,"mode":4},)"
                   R"({"attributes":{"POSITION":0,"COLOR_0":0},"mode":5})",
          .node = R"(,"scale":[1,-1,1],"translation":[1,2,3],"rotation":[0,0,0,1])",
          .more = R"(,"materials":[{"name":"fur"}],"extensionsUsed":["KHR_materials_unlit"])"};
}

std::string gltf_with_uri() {
  test::GltfText text = gltf_sample();
  text.uri = ",\"uri\":\"data:application/octet-stream;base64," +
             test::base64(test::tetrahedron_buffer()) + "\"";
  return text.json();
}

std::string compressed_mat() {
  const std::string plain = test::tetrahedron_mat(std::endian::little);
  return plain.substr(0, 128) + test::MatWriter(std::endian::little).compressed(plain.substr(128));
}

std::vector<Sample> samples() {
  const std::string facet =
      "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 -1.5e1 0\n"
      "endloop\nendfacet\n";
  return {{"off", "off",
           "OFF\n# sample\n5 3 0\n0 0 0\n1.5 0 0\n0 -2e0 0\n0 0 +1\n1 1 1 # last\n3 0 1 2 255 0 0\n"
           "4 0 1 2 3\n\n3 2 3 4\n"},
          {"one-line off", "off",
           "CNOFF 3 1 3\r\n0 0 0 1 0 0 7\r\n1 0 0 0 1 0 8\r\n0 1 0 0 0 1 9\r\n3 0 1 2"},
          {"obj", "obj",
           "# sample\nmtllib a.mtl\nv 0 0 0\nv 1 0 0 1.0\nv 0 1 0 0.1 0.2 0.3\nvt 0 0\nvn 0 0 1\n"
           "v 0 \\\n 0 1e0\ng a\nf 1 2 3\nf 1/1 2/1 3/1 4/1\nf -4//1 -3//1 \\\n-1//1\nf 1/1/1 "
           "2/1/1 4/1/1\n"},
          {"ascii ply", "ply",
           "ply\nformat ascii 1.0\ncomment sample\nelement vertex 4\nproperty float x\n"
           "property list uchar int ring\nproperty double z\nproperty int y\nelement face 2\n"
           "property list uchar int vertex_indices\nproperty uchar red\nelement edge 1\n"
           "property int a\nend_header\n0 0 0 0\n1.5 2 1 2 0 0\n0 0 0 1\n0 1 9 1e0 0\n3 0 1 2 255\n"
           "4 0 1 2 3 0\n7\n"},
          {"little ply", "ply", binary_ply(std::endian::little)},
          {"big ply", "ply", binary_ply(std::endian::big)},
          {"ascii stl", "stl", "solid sample\n" + facet + facet + "endsolid sample\n"},
          {"binary stl", "stl", binary_stl()},
          {"glb", "glb", test::glb(gltf_sample().json(), test::tetrahedron_buffer())},
          {"gltf", "gltf", gltf_with_uri()},
          {"little mat", "mat", test::tetrahedron_mat(std::endian::little)},
          {"big mat", "mat", test::tetrahedron_mat(std::endian::big)},
          {"compressed mat", "mat", compressed_mat()}};
}

/// Reads damaged files of one format.
class Victim {
 public:
  explicit Victim(const char* ending) : name_("mesh." + std::string(ending)) {}

  /// Whether the reader accepts `content`. The test fails if it does anything else than accept it
  /// as a valid mesh or refuse it with one line of explanation.
  bool accepts(const std::string& content) const {
    const std::string path = folder_.write(name_, content);
    try {
      validate(read_model(path));
      validate(read_mesh(path));
      return true;
    } catch (const BadFile& error) {
      const std::string message = error.what();
      EXPECT_TRUE(message.starts_with(path + ": ") && message.size() > path.size() + 10) << message;
      EXPECT_TRUE(std::ranges::all_of(message, [](char c) { return c >= ' ' && c <= '~'; }));
    } catch (const std::exception& error) {
      ADD_FAILURE() << error.what() << "\n" << content;
    }
    return false;
  }

 private:
  test::TemporaryFolder folder_;
  std::string name_;
};

class DamagedFile : public testing::TestWithParam<Sample> {};

TEST_P(DamagedFile, SampleIsFine) {
  EXPECT_TRUE(Victim(GetParam().ending).accepts(GetParam().content));
}

TEST_P(DamagedFile, CutAnywhereIsRefusedOrValid) {
  const Victim victim(GetParam().ending);
  const std::string& content = GetParam().content;
  int accepted = 0;
  for (std::size_t size = 0; size < content.size(); ++size)
    accepted += victim.accepts(content.substr(0, size));
  // Only what follows the last word that counts may be missing; the longest is " sample\n" in STL.
  // OBJ does not say how long it is.
  const bool tells_length = std::string_view(GetParam().ending) != "obj";
  EXPECT_LE(accepted, tells_length ? 8 : 1000);
}

/// Values that readers are known to stumble over.
const std::vector<std::string> kPoison = {"-1",
                                          "0",
                                          "nan",
                                          "-inf",
                                          "1e999",
                                          "1e-999",
                                          "4294967295",
                                          "2147483648",
                                          "99999999999999999999",
                                          "-9223372036854775808",
                                          "\n",
                                          "\r",
                                          "\\\n",
                                          "#",
                                          " ",
                                          std::string(1, '\0'),
                                          std::string(4, '\xff'),
                                          std::string(3, '\x7f')};

std::string mutate(std::string content, std::mt19937& random) {
  const auto below = [&](std::size_t n) { return random() % std::max<std::size_t>(n, 1); };
  const std::size_t changes = 1 + below(4);
  for (std::size_t change = 0; change < changes; ++change) {
    const std::size_t at = below(content.size());
    switch (below(6)) {
      case 0:
        if (!content.empty()) content[at] = static_cast<char>(random());
        break;
      case 1:
        if (!content.empty()) content[at] = static_cast<char>(content[at] ^ (1 << below(8)));
        break;
      case 2:
        content.erase(at, 1 + below(8));
        break;
      case 3:
        content.insert(at, content.substr(below(content.size()), 1 + below(40)));
        break;
      case 4:
        content.insert(at, kPoison[below(kPoison.size())]);
        break;
      default: {
        const std::string& poison = kPoison[below(kPoison.size())];
        content.replace(at, poison.size(), poison);
      }
    }
  }
  return content;
}

TEST_P(DamagedFile, MutatedIsRefusedOrValid) {
  const Victim victim(GetParam().ending);
  std::mt19937 random(11);
  int accepted = 0;
  for (int i = 0; i < kMutationsPerSample && !HasFailure(); ++i)
    accepted += victim.accepts(mutate(GetParam().content, random));
  // Mutations that a reader survives only because it refuses them all would test little.
  EXPECT_GT(accepted, kMutationsPerSample / 100);
  EXPECT_LT(accepted, kMutationsPerSample);
}

INSTANTIATE_TEST_SUITE_P(, DamagedFile, testing::ValuesIn(samples()), [](const auto& instance) {
  std::string name = instance.param.name;
  for (char& c : name)
    if (c == ' ' || c == '-') c = '_';
  return name;
});

}  // namespace
}  // namespace isomatch
