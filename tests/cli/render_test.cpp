// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <gmock/gmock.h>
#include <turbojpeg.h>

#include <array>
#include <filesystem>
#include <memory>

#include "isomatch/io/model_io.h"
#include "match_program.h"
#include "program.h"

namespace isomatch::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;

class Render : public MatchProgram {
 protected:
  void match(const std::vector<std::string>& more = {}) const {
    const Outcome outcome = run(arguments("out", more));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  }

  Outcome render(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> all{"render",  path("out"), "-o", path("picture.png"),
                                 "--width", "300"};
    all.insert(all.end(), more.begin(), more.end());
    return run(all);
  }

  std::string refusal(const std::vector<std::string>& more = {}) const {
    const Outcome outcome = render(more);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(std::ranges::count(outcome.errors, '\n'), 1);
    EXPECT_FALSE(fs::exists(path("picture.png")));
    return outcome.errors;
  }
};

constexpr std::string_view kPngSignature = "\x89PNG\r\n\x1a\n";

TEST_F(Render, DrawsAResultOfEitherMethod) {
  for (const char* method : {"tracked", "paper"}) {
    match({"--method", method});
    const Outcome outcome = render();
    ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
    EXPECT_THAT(outcome.output, HasSubstr("written to " + path("picture.png")));
    EXPECT_THAT(bytes("picture.png"), StartsWith(std::string(kPngSignature)));
    EXPECT_GT(bytes("picture.png").size(), 5000U);
  }
}

TEST_F(Render, DrawsHowSureAMapIs) {
  match();
  ASSERT_EQ(render().exit_code, 0);
  const std::string map = bytes("picture.png");
  const Outcome outcome = render({"--color", "confidence"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_THAT(bytes("picture.png"), StartsWith(std::string(kPngSignature)));
  EXPECT_NE(bytes("picture.png"), map);
}

TEST_F(Render, ThePapersMethodDoesNotTellHowSureItIs) {
  match({"--method", "paper"});
  EXPECT_THAT(refusal({"--color", "confidence"}), HasSubstr("has no source_confidence.txt"));
}

TEST_F(Render, TheReportSaysHowToRepeatTheRun) {
  match();
  const nlohmann::json report = json("out/report.json");
  EXPECT_EQ(report["command"].size(), arguments("out").size() + 1);
  EXPECT_EQ(report["command"].back(), path("out"));
  EXPECT_EQ(report["working_folder"], fs::current_path().string());
}

TEST_F(Render, MeshesThatMovedAreAskedFor) {
  match();
  fs::rename(path("source.off"), path("elsewhere.off"));
  EXPECT_THAT(refusal(), HasSubstr("say where it is with --source"));
  EXPECT_EQ(render({"--source", path("elsewhere.off")}).exit_code, 0);
}

TEST_F(Render, AMeshThatWasNotMatchedIsRefused) {
  match();
  EXPECT_THAT(refusal({"--source", path("target.ply")}), HasSubstr("that was matched had"));
}

TEST_F(Render, AFolderWithoutAResultIsRefused) {
  EXPECT_THAT(refusal(), HasSubstr("is this the folder of a match?"));
  match();
  folder_.write("out/report.json", "{\"options\": ");
  EXPECT_THAT(refusal(), HasSubstr("is not the report of a match"));
}

class RenderTextures : public Render {
 protected:
  void SetUp() override {
    Render::SetUp();
    match();
    Model source{.mesh = source_};
    source.texture.coordinates = {{0, 0}, {1, 0}, {0, 1}};
    source.texture.corners.assign(source_.faces.size(), {0, 1, 2});
    source.texture.materials = {"fur"};
    source.texture.face_material.assign(source_.faces.size(), 0);
    write_model(path("source.obj"), source);
    const Outcome outcome = run({"transfer", path("out"), "--texture", path("source.obj"), "-o",
                                 path("target.obj"), "--quiet"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  }

  std::vector<std::string> textures() const {
    return {"--textures", path("source.obj"), path("target.obj")};
  }
};

TEST_F(RenderTextures, AreDrawnInsteadOfTheMap) {
  ASSERT_EQ(render().exit_code, 0);
  const std::string map = bytes("picture.png");
  const Outcome outcome = render(textures());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  const std::string checkerboard = bytes("picture.png");
  EXPECT_NE(checkerboard, map);

  // An image of its own for both: what was drawn before.
  fs::rename(path("picture.png"), path("my fur.png"));
  folder_.write("source.mtl", "newmtl fur\nmap_Kd -clamp on my fur.png\n");
  folder_.write("source.obj", "mtllib source.mtl\n" + bytes("source.obj"));
  ASSERT_EQ(render(textures()).exit_code, 0);
  EXPECT_NE(bytes("picture.png"), checkerboard);
}

TEST_F(RenderTextures, OfAnotherMeshAreRefused) {
  EXPECT_THAT(refusal({"--textures", path("target.obj"), path("source.obj")}),
              HasSubstr("does not begin with the vertices"));
}

TEST_F(RenderTextures, AFileThatIsNoImageIsNamed) {
  folder_.write("source.mtl", "newmtl fur\nmap_Kd fur.png\n");
  folder_.write("fur.png", "no picture");
  folder_.write("source.obj", "mtllib source.mtl\n" + bytes("source.obj"));
  EXPECT_THAT(refusal(textures()), HasSubstr("fur.png: is neither a PNG nor a JPEG image"));
}

/// A JPEG file: one red pixel.
std::string red_jpeg() {
  const std::array<unsigned char, 3> red{255, 0, 0};
  const std::unique_ptr<void, int (*)(tjhandle)> handle(tjInitCompress(), tjDestroy);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  EXPECT_EQ(tjCompress2(handle.get(), red.data(), 1, 0, 1, TJPF_RGB, &bytes, &size, TJSAMP_444, 90,
                        TJFLAG_PROGRESSIVE),
            0);
  std::string file(reinterpret_cast<char*>(bytes), size);
  tjFree(bytes);
  return file;
}

TEST_F(RenderTextures, JpegsAreDrawnWhateverTheirName) {
  ASSERT_EQ(render(textures()).exit_code, 0);
  const std::string checkerboard = bytes("picture.png");
  fs::create_directory(path("tex"));
  folder_.write("tex/my fur.png", red_jpeg());
  folder_.write("source.mtl", "newmtl fur\nmap_Kd tex\\my fur.png\n");
  folder_.write("source.obj", "mtllib source.mtl\n" + bytes("source.obj"));
  const Outcome outcome = render(textures());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_EQ(outcome.errors, "");
  EXPECT_NE(bytes("picture.png"), checkerboard);

  folder_.write("tex/my fur.png", red_jpeg().substr(0, 300));
  fs::remove(path("picture.png"));
  EXPECT_THAT(refusal(textures()), HasSubstr("my fur.png: is a damaged JPEG image"));
}

TEST_F(RenderTextures, WhatIsNotThereIsACheckerboard) {
  ASSERT_EQ(render(textures()).exit_code, 0);
  const std::string checkerboard = bytes("picture.png");
  const std::string source = bytes("source.obj");
  folder_.write("source.obj", "mtllib no such.mtl\n" + source);
  EXPECT_THAT(render(textures()).errors,
              HasSubstr("files of materials that are not there: no such.mtl\n"));
  EXPECT_EQ(bytes("picture.png"), checkerboard);

  folder_.write("source.mtl", "newmtl fur\nmap_Kd no fur.png\n");
  folder_.write("source.obj", "mtllib source.mtl\n" + source);
  EXPECT_THAT(render(textures()).errors, HasSubstr("images that are not there: no fur.png\n"));
  EXPECT_EQ(bytes("picture.png"), checkerboard);

  folder_.write("source.mtl", "newmtl Fur\nmap_Kd fur.png\n");
  EXPECT_THAT(render(textures()).errors,
              HasSubstr("materials that are in none of its files: fur\n"));
}

TEST_F(Render, BadOptionsAreRefused) {
  match();
  EXPECT_THAT(refusal({"--alternative", "7"}), HasSubstr("no alternative 7"));
  EXPECT_THAT(refusal({"--up", "w"}), HasSubstr("--up"));
  EXPECT_THAT(refusal({"--color", "rainbow"}), HasSubstr("--color"));
  EXPECT_THAT(refusal({"--width", "5"}), HasSubstr("--width"));
}

}  // namespace
}  // namespace isomatch::test
