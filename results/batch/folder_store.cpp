// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "isomatch/error.h"
#include "results/batch/result_store.h"
#include "results/batch/unfinished.h"

namespace isomatch::results {
namespace {

namespace fs = std::filesystem;

class FolderStore : public ResultStore {
 public:
  explicit FolderStore(fs::path folder) : folder_(std::move(folder)) {}

  std::string place_for(const std::string& pair) const override {
    return (folder_ / unfinished_name(pair)).string();
  }

  bool finish(const std::string& pair) override {
    std::error_code error;
    fs::rename(place_for(pair), folder_ / pair, error);
    if (error == std::errc::directory_not_empty || error == std::errc::file_exists) {
      abandon(pair);
      return false;
    }
    if (error)
      throw BadFile((folder_ / pair).string(),
                    fmt::format("cannot be created: {}", error.message()));
    return true;
  }

  void abandon(const std::string& pair) noexcept override {
    try {
      std::error_code ignored;
      fs::remove_all(place_for(pair), ignored);
    } catch (...) {  // Out of memory: it stays, hidden.
    }
  }

 private:
  fs::path folder_;
};

}  // namespace

std::unique_ptr<ResultStore> folder_store(const std::string& folder) {
  return std::make_unique<FolderStore>(folder);
}

}  // namespace isomatch::results
