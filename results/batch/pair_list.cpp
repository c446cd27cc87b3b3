// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/batch/pair_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <string_view>
#include <utility>

#include "isomatch/error.h"
#include "results/files/outputs.h"

namespace isomatch::results {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kBlanks = " \t\r";

std::string trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return "";
  return std::string(text.substr(first, text.find_last_not_of(kBlanks) - first + 1));
}

std::vector<std::string> split_at_blanks(std::string_view line) {
  std::vector<std::string> fields;
  for (auto begin = line.find_first_not_of(kBlanks); begin != std::string_view::npos;) {
    const auto end = std::min(line.find_first_of(kBlanks, begin), line.size());
    fields.emplace_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(kBlanks, end);
  }
  return fields;
}

/// Fields may be between quotes, which separators inside do not end.
std::vector<std::string> split_at(char separator, std::string_view line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"')
      quoted = !quoted;
    else if (c == separator && !quoted)
      fields.emplace_back();
    else
      fields.back() += c;
  }
  for (std::string& field : fields) field = trimmed(field);
  return fields;
}

std::vector<std::string> fields_of(std::string_view line) {
  for (const char separator : {'\t', ',', ';'})
    if (line.find(separator) != std::string_view::npos) return split_at(separator, line);
  return split_at_blanks(line);
}

std::string name_of(const std::string& source, const std::string& target) {
  return fs::path(source).stem().string() + "__" + fs::path(target).stem().string();
}

bool can_be_a_folder(const std::string& name) {
  return !name.empty() && name.front() != '.' && name.find('/') == std::string::npos;
}

/// Collects pairs, whose names must differ.
class Collector {
 public:
  explicit Collector(std::string path) : path_(std::move(path)) {}

  /// `place` tells where it is listed.
  void add(ListedPair pair, const std::string& place) {
    if (pair.name.empty()) pair.name = name_of(pair.source, pair.target);
    if (!can_be_a_folder(pair.name))
      throw BadFile(path_, place, fmt::format("'{}' cannot be the name of a folder", pair.name));
    const auto [known, is_new] = places_.emplace(pair.name, place);
    if (!is_new)
      throw BadFile(path_, place,
                    fmt::format("the name {} is that of {} as well", pair.name, known->second));
    pairs_.push_back(std::move(pair));
  }

  std::vector<ListedPair> pairs() && {
    if (pairs_.empty()) throw BadFile(path_, "there is no pair in it");
    return std::move(pairs_);
  }

 private:
  std::string path_;
  std::map<std::string, std::string> places_;
  std::vector<ListedPair> pairs_;
};

ListedPair pair_of(const std::vector<std::string>& fields, const fs::path& folder) {
  const auto seen_from = [&](const std::string& file) { return (folder / file).string(); };
  return {seen_from(fields[0]), seen_from(fields[1]), fields.size() > 2 ? fields[2] : ""};
}

std::vector<std::string> meshes_in(const std::string& folder) {
  constexpr std::array kEndings{".off", ".obj", ".ply", ".stl", ".glb", ".gltf", ".mat"};
  std::error_code error;
  std::vector<std::string> meshes;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    if (entry.is_regular_file() &&
        std::ranges::count(kEndings, lower_ending(entry.path().string())) > 0)
      meshes.push_back(entry.path().string());
  if (error) throw BadFile(folder, error.message());
  std::ranges::sort(meshes);
  return meshes;
}

std::vector<std::string> at_least_two(const std::string& folder) {
  std::vector<std::string> meshes = meshes_in(folder);
  if (meshes.size() < 2)
    throw BadFile(folder,
                  fmt::format("{} of its files are meshes; a pair needs two", meshes.size()));
  return meshes;
}

}  // namespace

std::vector<ListedPair> read_pairs(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw BadFile(path, "cannot be opened");
  Collector collector(path);
  int number = 0;
  for (std::string line; std::getline(file, line);) {
    const std::string place = fmt::format("line {}", ++number);
    line = trimmed(line.substr(0, line.find('#')));
    if (line.empty()) continue;
    const std::vector<std::string> fields = fields_of(line);
    if (number == 1 && fields.front() == "source") continue;
    if (fields.size() < 2 || fields.size() > 3 || fields[0].empty() || fields[1].empty())
      throw BadFile(path, place, "expected source, target and perhaps a name");
    collector.add(pair_of(fields, fs::path(path).parent_path()), place);
  }
  return std::move(collector).pairs();
}

std::vector<ListedPair> all_pairs(const std::string& folder) {
  const std::vector<std::string> meshes = at_least_two(folder);
  Collector collector(folder);
  for (const std::string& source : meshes)
    for (const std::string& target : meshes)
      if (source != target)
        collector.add({source, target, ""}, fmt::format("{} and {}", source, target));
  return std::move(collector).pairs();
}

std::vector<ListedPair> star_of_pairs(const std::string& center, const std::string& folder) {
  Collector collector(folder);
  for (const std::string& mesh : meshes_in(folder)) {
    std::error_code error;
    if (!fs::equivalent(center, mesh, error)) collector.add({center, mesh, ""}, mesh);
  }
  return std::move(collector).pairs();
}

std::vector<ListedPair> chain_of_pairs(const std::string& folder) {
  const std::vector<std::string> meshes = at_least_two(folder);
  Collector collector(folder);
  for (std::size_t i = 1; i < meshes.size(); ++i)
    collector.add({meshes[i - 1], meshes[i], ""}, meshes[i]);
  return std::move(collector).pairs();
}

std::vector<ListedPair> share_of(const std::vector<ListedPair>& pairs, int share, int count) {
  const auto end_of = [&](int k) { return pairs.begin() + std::ssize(pairs) * k / count; };
  return {end_of(share - 1), end_of(share)};
}

}  // namespace isomatch::results
