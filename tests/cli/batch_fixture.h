// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "isomatch/io/mesh_io.h"
#include "program.h"
#include "support/shapes.h"
#include "support/temporary_folder.h"

namespace isomatch::test {

/// Three small shapes in a folder, and all of their pairs matched, once for all tests.
class Batch : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    shared_ = std::make_unique<TemporaryFolder>();
    std::filesystem::create_directories(shared_->path("shapes"));
    for (int number = 0; number < 3; ++number)
      write_mesh(shape(std::string(1, static_cast<char>('a' + number)) + ".off"), lump(number));
    whole_ = std::make_unique<Outcome>(
        run({"batch", "--all", shared_->path("shapes"), "-o", shared_->path("whole")}));
  }
  static void TearDownTestSuite() { shared_.reset(); }

  static std::string shape(const std::string& name) { return shared_->path("shapes/" + name); }

  std::string path(const std::string& name) const { return folder_.path(name); }

  Outcome batch(const std::string& folder, std::vector<std::string> words,
                const RunOptions& options = {}) const {
    words.insert(words.begin(), "batch");
    words.insert(words.end(), {"-o", path(folder)});
    return run(words, options);
  }
  Outcome all(const std::string& folder, std::vector<std::string> words = {},
              const RunOptions& options = {}) const {
    words.insert(words.end(), {"--all", shared_->path("shapes")});
    return batch(folder, words, options);
  }

  static std::string map(const std::string& folder) {
    return read_file(folder + "/source_to_target.bary.txt");
  }

  void expect_maps_of_whole(const std::string& folder) const {
    for (const char* pair : {"a__b", "a__c", "b__a", "b__c", "c__a", "c__b"})
      EXPECT_EQ(map(path(folder) + "/" + pair), map(shared_->path("whole/") + pair)) << pair;
  }

  /// A copy of all that is matched.
  void copy_whole(const std::string& folder) const {
    std::filesystem::copy(shared_->path("whole"), path(folder),
                          std::filesystem::copy_options::recursive);
  }

  /// Lines of a file, the first for column names.
  std::vector<std::string> lines(const std::string& name) const {
    std::vector<std::string> lines;
    std::istringstream text(read_file(path(name)));
    for (std::string line; std::getline(text, line);) lines.push_back(line);
    return lines;
  }

  /// What a table has in a column of its first pair; for tables without quotes.
  std::string column(const std::string& table, const std::string& name) const {
    std::istringstream names(lines(table).at(0)), values(lines(table).at(1));
    for (std::string field, value;
         std::getline(names, field, ',') && std::getline(values, value, ',');)
      if (field == name) return value;
    ADD_FAILURE() << table << " has no column " << name;
    return "0";
  }

  inline static std::unique_ptr<TemporaryFolder> shared_;
  inline static std::unique_ptr<Outcome> whole_;
  TemporaryFolder folder_;
};

}  // namespace isomatch::test
