// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/batch/pair_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "isomatch/error.h"
#include "results/files/mesh_files.h"

namespace isomatch::results {
namespace {

namespace fs = std::filesystem;

/// A character of a line, and whether quotes around it take its meaning away.
struct Letter {
  char value;
  bool quoted;

  bool is(std::string_view any) const {
    return !quoted && any.find(value) != std::string_view::npos;
  }
};

constexpr std::string_view kBlankLetters = " \t\r", kFieldEnds = ",;\t";

/// A line without its quotes and its comment; two quotes between quotes are one. Nothing if a quote
/// is not closed.
std::optional<std::vector<Letter>> letters_of(std::string_view line) {
  std::vector<Letter> letters;
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '#' && !quoted) break;
    if (line[i] != '"') {
      letters.push_back({line[i], quoted});
    } else if (quoted && i + 1 < line.size() && line[i + 1] == '"') {
      letters.push_back({'"', quoted});
      ++i;
    } else {
      quoted = !quoted;
    }
  }
  if (quoted) return std::nullopt;
  return letters;
}

std::string text_of(std::span<const Letter> letters) {
  while (!letters.empty() && letters.front().is(kBlankLetters)) letters = letters.subspan(1);
  while (!letters.empty() && letters.back().is(kBlankLetters))
    letters = letters.first(letters.size() - 1);
  std::string text;
  for (const Letter& letter : letters) text += letter.value;
  return text;
}

/// Fields between the separator that comes first in the line, or between blanks if there is none.
/// Empty for a line without content.
std::vector<std::string> fields_of(const std::vector<Letter>& letters) {
  const auto first =
      std::ranges::find_if(letters, [](const Letter& letter) { return letter.is(kFieldEnds); });
  const bool separated = first != letters.end();
  const std::string_view ends = separated ? std::string_view(&first->value, 1) : kBlankLetters;
  std::vector<std::string> fields;
  const std::span<const Letter> all = letters;
  for (std::size_t begin = 0; begin <= all.size();) {
    std::size_t end = begin;
    while (end < all.size() && !all[end].is(ends)) ++end;
    std::string field = text_of(all.subspan(begin, end - begin));
    if (separated || !field.empty()) fields.push_back(std::move(field));
    begin = end + 1;
  }
  return fields;
}

bool is_column_name(std::string word) {
  std::ranges::transform(word, word.begin(), [](unsigned char c) { return std::tolower(c); });
  return word == "source";
}

std::string name_of(const std::string& source, const std::string& target) {
  return fs::path(source).stem().string() + "__" + fs::path(target).stem().string();
}

/// Files of the batch itself have such names.
bool is_reserved(const std::string& name) {
  return (name.starts_with("results") && name.find(".sqlar") != std::string::npos) ||
         (name.starts_with("pairs") && name.ends_with(".csv")) ||
         (name.starts_with("batch") && (name.ends_with(".log") || name.ends_with(".json")));
}

bool can_be_a_folder(const std::string& name) {
  constexpr std::size_t kLongest = 150;  // While results are made, host and process come to it.
  return !name.empty() && name.size() <= kLongest && name.front() != '.' &&
         name.find('/') == std::string::npos && !is_reserved(name);
}

/// Collects pairs, whose names must differ.
class Collector {
 public:
  explicit Collector(std::string path) : path_(std::move(path)) {}

  /// `place` tells where it is listed.
  void add(ListedPair pair, const std::string& place) {
    if (pair.name.empty()) pair.name = name_of(pair.source, pair.target);
    if (!can_be_a_folder(pair.name))
      throw BadFile(path_, place, fmt::format("'{}' cannot be the name of a result", pair.name));
    const auto [known, is_new] = places_.emplace(pair.name, place);
    if (!is_new)
      throw BadFile(path_, place,
                    fmt::format("the name {} is that of {} as well: a list gives them others",
                                pair.name, known->second));
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

std::vector<std::string> at_least_two(const std::string& folder) {
  std::vector<std::string> meshes = meshes_in(folder);
  if (meshes.size() < 2)
    throw BadFile(folder,
                  fmt::format("{} of its files are meshes; a pair needs two", meshes.size()));
  return meshes;
}

}  // namespace

std::vector<ListedPair> read_pairs(const std::string& path) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  std::error_code error;
  if (fs::is_directory(path, error))
    throw BadFile(path, "is a folder, not a list; --all, --star and --chain take one");
  std::ifstream file(path);
  if (!file) throw BadFile(path, "cannot be opened");
  Collector collector(path);
  int number = 0;
  bool first = true;
  for (std::string line; std::getline(file, line);) {
    const std::string place = fmt::format("line {}", ++number);
    if (number == 1 && line.starts_with(kByteOrderMark)) line.erase(0, kByteOrderMark.size());
    const std::optional<std::vector<Letter>> letters = letters_of(line);
    if (!letters) throw BadFile(path, place, "a quote is not closed");
    if (text_of(*letters).empty()) continue;
    const std::vector<std::string> fields = fields_of(*letters);
    if (std::exchange(first, false) && is_column_name(fields.front())) continue;
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
  std::error_code error;
  if (!fs::is_regular_file(center, error)) throw BadFile(center, "is no file");
  Collector collector(folder);
  for (const std::string& mesh : meshes_in(folder)) {
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

}  // namespace isomatch::results
