// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/io/atomic_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <stdexcept>
#include <string>

#include "isomatch/error.h"
#include "support/temporary_folder.h"

namespace isomatch {
namespace {

namespace fs = std::filesystem;
using test::read_file;
using test::TemporaryFolder;

/// What creating an `AtomicFile` at `path` throws, without the path.
std::string creation_error(const std::string& path) {
  try {
    const AtomicFile file(path);
  } catch (const BadFile& error) {
    return std::string(error.what()).substr(path.size() + 2);
  }
  return "no error";
}

TEST(AtomicFile, AppearsWithCommitAndNotEarlier) {
  const TemporaryFolder folder;
  AtomicFile file(folder.path("a.txt"));
  EXPECT_EQ(file.path(), folder.path("a.txt"));
  file.write("one\n");
  file.write(std::string("tw\0o", 4));
  EXPECT_FALSE(fs::exists(folder.path("a.txt")));
  file.commit();
  EXPECT_EQ(read_file(folder.path("a.txt")), std::string("one\ntw\0o", 8));
  EXPECT_THAT(folder.names(), testing::ElementsAre("a.txt"));
}

TEST(AtomicFile, KeepsTheOldFileUntilCommit) {
  const TemporaryFolder folder;
  const std::string path = folder.write("a.txt", "old");
  {
    AtomicFile file(path);
    file.write("new");
    EXPECT_EQ(read_file(folder.path("a.txt")), "old");
    file.commit();
  }
  EXPECT_EQ(read_file(folder.path("a.txt")), "new");
}

TEST(AtomicFile, LeavesNoTraceWithoutCommit) {
  const TemporaryFolder folder;
  folder.write("a.txt", "old");
  try {
    AtomicFile file(folder.path("a.txt"));
    file.write("new");
    EXPECT_THAT(folder.names(), testing::SizeIs(2));
    throw std::runtime_error("interrupted");
  } catch (const std::runtime_error&) {
  }
  EXPECT_EQ(read_file(folder.path("a.txt")), "old");
  EXPECT_THAT(folder.names(), testing::ElementsAre("a.txt"));
}

TEST(AtomicFile, MayBeEmpty) {
  const TemporaryFolder folder;
  AtomicFile(folder.path("a.txt")).commit();
  EXPECT_TRUE(fs::exists(folder.path("a.txt")));
  EXPECT_EQ(read_file(folder.path("a.txt")), "");
}

TEST(AtomicFile, TakesNamesAsLongAsTheSystemAllows) {
  const TemporaryFolder folder;
  const std::string path = folder.path(std::string(255, 'n'));
  AtomicFile(path).commit();
  EXPECT_TRUE(fs::exists(path));
}

TEST(AtomicFile, HasTheUsualPermissions) {
  const TemporaryFolder folder;
  AtomicFile(folder.path("atomic")).commit();
  EXPECT_EQ(fs::status(folder.path("atomic")).permissions(),
            fs::status(folder.write("plain", "")).permissions());
}

TEST(AtomicFile, FollowsLinks) {
  const TemporaryFolder folder;
  fs::create_directory(folder.path("below"));
  folder.write("below/target", "old");
  fs::create_symlink("below/target", folder.path("link"));
  fs::create_symlink("below/new", folder.path("dangling"));
  for (const char* name : {"link", "dangling"}) {
    AtomicFile file(folder.path(name));
    file.write("new");
    file.commit();
    EXPECT_TRUE(fs::is_symlink(folder.path(name)));
  }
  EXPECT_EQ(read_file(folder.path("below/target")), "new");
  EXPECT_EQ(read_file(folder.path("below/new")), "new");
}

TEST(AtomicFile, RefusesLinksInACircle) {
  const TemporaryFolder folder;
  fs::create_symlink("two", folder.path("one"));
  fs::create_symlink("one", folder.path("two"));
  EXPECT_EQ(creation_error(folder.path("one")), "too many links");
}

TEST(AtomicFile, NamesPlacesWhereItCannotBe) {
  const TemporaryFolder folder;
  EXPECT_EQ(creation_error(folder.path("missing/a.txt")),
            "cannot be created: No such file or directory");
  EXPECT_EQ(creation_error(folder.path(".")), "is a folder");
  EXPECT_EQ(creation_error(folder.write("file", "") + "/a.txt"),
            "cannot be created: Not a directory");
  const std::string pipe = folder.path("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(creation_error(pipe), "not a regular file");
  EXPECT_EQ(creation_error("/dev/null"), "not a regular file");
}

TEST(AtomicFile, FailsOnAFullDiskAndLeavesNothing) {
  const TemporaryFolder folder;
  rlimit limit{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &limit), 0);
  rlimit small = limit;
  small.rlim_cur = 1000;
  // With its signal ignored, the limit on a file's size makes writes fail as a full disk does.
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &small);
  EXPECT_THROW(AtomicFile(folder.path("large")).write(std::string(100000, 'x')), BadFile);
  EXPECT_THROW(
      {
        AtomicFile file(folder.path("buffered"));
        file.write(std::string(1001, 'x'));
        file.commit();
      },
      BadFile);
  setrlimit(RLIMIT_FSIZE, &limit);
  std::signal(SIGXFSZ, old_handler);
  EXPECT_THAT(folder.names(), testing::IsEmpty());
}

TEST(AtomicFile, CannotBeUsedAfterCommit) {
  const TemporaryFolder folder;
  AtomicFile file(folder.path("a.txt"));
  file.commit();
  EXPECT_THROW(file.write("more"), InternalError);
  EXPECT_THROW(file.commit(), InternalError);
}

}  // namespace
}  // namespace isomatch
