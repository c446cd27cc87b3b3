// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "isomatch/io/model_io.h"
#include "match_program.h"
#include "program.h"

namespace isomatch::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// Where commands write, and what of the user's must survive that.
class Outputs : public MatchProgram {
 protected:
  void SetUp() override {
    MatchProgram::SetUp();
    fs::create_directory(path("w"));
  }

  /// Every file by its name, with its content.
  std::map<std::string, std::string> snapshot() const {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder_.path("")))
      if (entry.is_regular_file()) files[entry.path()] = read_file(entry.path());
    return files;
  }

  /// Runs what must be refused in one line, and nothing be touched.
  std::string refusal(const std::vector<std::string>& arguments) const {
    const auto before = snapshot();
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.output;
    EXPECT_EQ(std::ranges::count(outcome.errors, '\n'), 1) << outcome.errors;
    EXPECT_TRUE(snapshot() == before);
    return outcome.errors;
  }

  std::string match_refusal(const std::string& source, const std::string& folder,
                            const std::vector<std::string>& more = {}) const {
    std::vector<std::string> all{"match", source, path("target.ply"), "-o", folder};
    all.insert(all.end(), more.begin(), more.end());
    return refusal(all);
  }

  void match_into(const std::string& folder, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> all = more;
    all.emplace_back("--no-refinement");
    const Outcome outcome = run(arguments(folder, all));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  }
};

TEST_F(Outputs, MatchDoesNotReplaceWhatItReads) {
  write_mesh(path("w/registered.ply"), source_);
  folder_.write("w/report.html", "the user's");
  const std::string given = path("w/registered.ply");
  EXPECT_THAT(match_refusal(given, path("w")), HasSubstr("is read here"));
  EXPECT_THAT(match_refusal(path("w/./../w/registered.ply"), path("w/")), HasSubstr("is read"));
  fs::create_symlink(given, path("link.ply"));
  fs::create_hard_link(given, path("hard.ply"));
  fs::create_directory_symlink(path("w"), path("v"));
  for (const char* link : {"link.ply", "hard.ply"})
    EXPECT_THAT(match_refusal(path(link), path("w")), HasSubstr("is read here")) << link;
  EXPECT_THAT(match_refusal(given, path("v"), {"--method", "tracked"}), HasSubstr("is read here"));
  fs::rename(given, path("w/a.ply"));
  fs::remove(path("hard.ply"));
  folder_.write("w/correspondence.txt", "0 4\n");
  EXPECT_THAT(
      match_refusal(path("source.off"), path("w"), {"--landmarks", path("w/correspondence.txt")}),
      HasSubstr("is read here"));
}

TEST_F(Outputs, MatchRefusesFilesThatItDidNotWrite) {
  for (const char* name : {"source_to_target.txt", "report.json", "unfinished.json"}) {
    folder_.write("w/" + std::string(name), "{\"files\": [\"report.json\"]}");
    EXPECT_THAT(match_refusal(path("source.off"), path("w")), HasSubstr("did not write")) << name;
    fs::remove(path("w/" + std::string(name)));
  }
  folder_.write("w/alternatives", "a file");
  EXPECT_THAT(match_refusal(path("source.off"), path("w"), {"--alternatives", "1"}),
              HasSubstr("is not a folder"));
}

TEST_F(Outputs, MatchAgainReplacesItsOwnFilesOnly) {
  folder_.write("w/levels.json", "the user's, of no use to this method");
  folder_.write("w/report.html", "the user's");
  folder_.write("victim.txt", "the user's");
  match_into("w", {"--target-to-source"});
  nlohmann::json report = json("w/report.json");
  report["files"].push_back("../victim.txt");
  report["files"].push_back(path("victim.txt"));
  folder_.write("w/report.json", report.dump());
  match_into("w");
  EXPECT_FALSE(fs::exists(path("w/target_to_source.txt")));
  EXPECT_FALSE(fs::exists(path("w/unfinished.json")));
  for (const char* name : {"w/levels.json", "w/report.html", "victim.txt"})
    EXPECT_THAT(bytes(name), testing::StartsWith("the user's")) << name;
  // What one run wrote may be what the next one reads.
  EXPECT_THAT(match_refusal(path("w/registered.ply"), path("w")), HasSubstr("is read here"));
}

TEST_F(Outputs, MatchAfterOneThatDiedWhileWriting) {
  folder_.write("w/registered.ply", "half of a result");
  folder_.write(
      "w/unfinished.json",
      R"({"isomatch": "0", "files": ["registered.ply", "alternatives/1/registered.ply"]})");
  match_into("w");
  EXPECT_FALSE(fs::exists(path("w/unfinished.json")));
}

TEST_F(Outputs, OfAResultNothingIsOverwritten) {
  match_into("out");
  folder_.write("values.txt",
                std::string("1\n") + std::string(2 * (source_.num_vertices() - 1), '2'));
  const std::string out = path("out");
  EXPECT_THAT(refusal({"convert", out, path("source.off")}), HasSubstr("is read here"));
  EXPECT_THAT(refusal({"convert", out, path("out/source_to_target.txt")}), HasSubstr("is read"));
  EXPECT_THAT(refusal({"convert", path("source.off"), path("./source.off")}), HasSubstr("is read"));
  fs::create_symlink(path("source.off"), path("link.off"));
  EXPECT_THAT(refusal({"convert", path("source.off"), path("link.off")}), HasSubstr("is read"));
  EXPECT_THAT(refusal({"transfer", out, "--values", path("values.txt"), "-o", path("values.txt")}),
              HasSubstr("is read here"));
  EXPECT_THAT(refusal({"transfer", out, "--values", path("values.txt"), "-o",
                       path("out/correspondence.txt")}),
              HasSubstr("is read here"));
  EXPECT_THAT(refusal({"transfer", out, "--colors", path("target.ply"), "-o", path("target.ply")}),
              HasSubstr("is read here"));
  EXPECT_THAT(refusal({"render", out, "-o", path("out/report.json")}), HasSubstr("named .png"));
}

TEST_F(Outputs, FramesAreNotReplacedByTheirCopies) {
  match_into("out");
  fs::create_directory(path("frames"));
  write_mesh(path("frames/x.ply"), source_);
  write_mesh(path("x.off"), source_);
  const auto carry = [&](const std::string& frame, const std::string& folder) {
    return std::vector<std::string>{"transfer",  path("out"), "--poses",
                                    path(frame), "-o",        path(folder)};
  };
  EXPECT_THAT(refusal(carry("frames/x.ply", "frames")), HasSubstr("is read here"));
  EXPECT_THAT(refusal(carry("x.off", "frames")), HasSubstr("did not write"));
  fs::copy_file(path("x.off"), path("registered.off"));
  EXPECT_THAT(refusal(carry("registered.off", "out")), HasSubstr("is read here"));
  for (const char* frame : {"frames/x.ply", "x.off", "registered.off"})
    EXPECT_EQ(run(carry(frame, "carried")).exit_code, 0) << frame;
  EXPECT_EQ(json("carried/transfer.json")["files"],
            (nlohmann::json{"registered.ply", "transfer.json", "x.ply"}));
}

TEST_F(Outputs, FramesStayWhenTheirFolderIsMatchedIntoAgain) {
  match_into("out");
  write_mesh(path("walk.off"), source_);
  ASSERT_EQ(
      run({"transfer", path("out"), "--poses", path("walk.off"), "-o", path("out")}).exit_code, 0);
  match_into("out");
  EXPECT_TRUE(fs::exists(path("out/walk.ply")));
  EXPECT_TRUE(fs::exists(path("out/transfer.json")));
}

TEST_F(Outputs, MaterialsBesideAnOutputAreNotReplaced) {
  match_into("out");
  Model textured{.mesh = source_};
  textured.texture.coordinates = {{0, 0}, {1, 0}, {0, 1}};
  textured.texture.corners.assign(source_.faces.size(), {0, 1, 2});
  textured.texture.materials = {"fur"};
  textured.texture.face_material.assign(source_.faces.size(), 0);
  write_model(path("skin.obj"), textured, {.material_libraries = {"fur.mtl"}});
  folder_.write("fur.mtl", "newmtl fur\nmap_Kd fur.png\n");
  folder_.write("fur.png", "not looked at");
  folder_.write("mine.mtl", "the user's");
  const auto carry = [&](const char* output) {
    return std::vector<std::string>{"transfer",       path("out"), "--texture",
                                    path("skin.obj"), "-o",        path(output)};
  };
  EXPECT_THAT(refusal(carry("fur.obj")), HasSubstr("fur.mtl: is read here"));
  EXPECT_THAT(refusal(carry("mine.obj")), HasSubstr("mine.mtl: is there already"));
  EXPECT_THAT(refusal(carry("mine.txt")), HasSubstr("named .obj"));
  for (int time = 0; time < 2; ++time) EXPECT_EQ(run(carry("new.obj")).exit_code, 0);
  EXPECT_THAT(refusal({"render", path("out"), "--textures", path("skin.obj"), path("new.obj"), "-o",
                       path("fur.png")}),
              HasSubstr("is read here"));
}

TEST_F(Outputs, TruthBesideAMeshIsNotReplaced) {
  folder_.write("made.vts", "the user's");
  const std::vector<std::string> make{"synth", "--vertices", "1000", "-o", path("made.off")};
  EXPECT_THAT(refusal(make), HasSubstr("made.vts: is there already"));
  fs::remove(path("made.vts"));
  for (int time = 0; time < 2; ++time) EXPECT_EQ(run(make).exit_code, 0);
}

TEST_F(Outputs, PagesOfTheUserAreNotReplaced) {
  if (!ISOMATCH_HAS_PAGE) GTEST_SKIP() << "built without the page";
  match_into("out");
  folder_.write("out/report.html", "the user's");
  EXPECT_THAT(refusal({"report", path("out")}), HasSubstr("did not write"));
  EXPECT_THAT(match_refusal(path("source.off"), path("out"), {"--report"}),
              HasSubstr("did not write"));
  EXPECT_THAT(refusal({"report", path("out"), "-o", path("source.off")}), HasSubstr("named .html"));
  fs::remove(path("out/report.html"));
  for (int time = 0; time < 2; ++time) EXPECT_EQ(run({"report", path("out")}).exit_code, 0);
  EXPECT_THAT(json("out/report.json")["files"].dump(), HasSubstr("report.html"));
  match_into("out");
  EXPECT_FALSE(fs::exists(path("out/report.html")));
}

TEST_F(Outputs, PlacesBelowAFileAreRefusedBeforeAnyWork) {
  match_into("out");
  const std::string below = path("source.off/below");
  const std::string out = path("out");
  // Files that are missing would be found later.
  EXPECT_THAT(refusal({"match", path("no.off"), path("no.off"), "-o", below}), HasSubstr("below"));
  fs::remove(path("out/source_to_target.txt"));
  EXPECT_THAT(refusal({"render", out, "-o", below + ".png"}), HasSubstr("below"));
  EXPECT_THAT(refusal({"convert", out, below + ".glb"}), HasSubstr("below"));
  EXPECT_THAT(refusal({"convert", path("no.off"), below + ".off"}), HasSubstr("below"));
  EXPECT_THAT(refusal({"transfer", out, "--values", path("no.txt"), "-o", below}),
              HasSubstr("below"));
  EXPECT_THAT(refusal({"transfer", out, "--poses", path("no.ply"), "-o", below}),
              HasSubstr("below"));
  EXPECT_THAT(refusal({"synth", "-o", below + ".off"}), HasSubstr("below"));
  if (ISOMATCH_HAS_PAGE) {
    EXPECT_THAT(refusal({"report", out, "-o", below + ".html"}), HasSubstr("below"));
  }
}

/// Runs the program as somebody whom permissions bind.
Outcome run_bound(std::vector<std::string> arguments) {
  if (geteuid() != 0) return run(arguments);
  arguments.insert(arguments.begin(),
                   {"--reuid=65534", "--regid=65534", "--clear-groups", isomatch_program()});
  return run(arguments, {.program = "/usr/bin/setpriv"});
}

TEST_F(Outputs, FoldersThatMayNotBeWrittenAreRefusedBeforeAnyWork) {
  fs::permissions(folder_.path(""), fs::perms(0755));
  if (run_bound({"--version"}).exit_code != 0) GTEST_SKIP() << "no other user may run the program";
  fs::create_directory(path("out"));
  fs::permissions(path("out"), fs::perms(0555));
  for (const char* folder : {"out", "out/new"}) {
    const Outcome outcome =
        run_bound({"match", path("no.off"), path("no.off"), "-o", path(folder)});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.errors, HasSubstr("cannot be created: Permission denied"));
  }
}

/// Names in Latin-1, as archives from Windows leave them.
class Latin1 : public Outputs {
 protected:
  void SetUp() override {
    Outputs::SetUp();
    fs::create_directory(path(kFolder));
    fs::rename(path("source.off"), path(name("K\366rper.off")));
    before_ = fs::current_path();
    fs::current_path(path(kFolder));
  }
  void TearDown() override { fs::current_path(before_); }

  static std::string name(const std::string& file) { return kFolder + ("/" + file); }
  static constexpr const char* kFolder = "\374ber 50%41";

  void succeed(const std::vector<std::string>& arguments) const {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << arguments[0] << ": " << outcome.errors;
  }

  fs::path before_;
};

TEST_F(Latin1, NamesThatAreNotUtf8WorkEverywhere) {
  const std::string mesh = "K\366rper.off", landmarks = "M\344rk.txt", out = "\344us";
  folder_.write(name(landmarks), "0 4\n");
  succeed({"match", mesh, path("target.ply"), "-o", out, "--landmarks", landmarks});
  const nlohmann::json report = json(name(out + "/report.json"));
  EXPECT_EQ(report["source"]["file"], "K\uFFFDrper.off");
  EXPECT_EQ(report["source"]["file_escaped"], "K%F6rper.off");
  EXPECT_EQ(report["target"].contains("file_escaped"), false);
  EXPECT_EQ(report["options"]["landmarks_escaped"], "M%E4rk.txt");
  EXPECT_THAT(report["working_folder_escaped"].get<std::string>(),
              testing::EndsWith("%FCber 50%2541"));
  succeed({"info", mesh});
  succeed({"info", mesh, "--json"});
  succeed({"eval", mesh, path("target.ply"), out + "/source_to_target.txt", "--json"});
  succeed({"convert", out, "\344.glb"});
  succeed({"convert", mesh, "\344.gltf"});
  succeed({"info", "\344.gltf"});
  succeed({"transfer", out, "--poses", mesh, "-o", "b\344lder"});
  succeed({"transfer", out, "--poses", mesh, "-o", "b\344lder"});
  EXPECT_TRUE(fs::exists(path(name("b\344lder/K\366rper.ply"))));
  // The mesh is found from elsewhere, too.
  fs::current_path(before_);
  succeed({"render", path(name(out)), "-o", path("\344.png")});
  if (ISOMATCH_HAS_PAGE) succeed({"report", path(name(out))});
  succeed({"match", path(name(mesh)), path("target.ply"), "-o", path(name(out)), "--method",
           "paper", "--levels", "2"});
}

}  // namespace
}  // namespace isomatch::test
