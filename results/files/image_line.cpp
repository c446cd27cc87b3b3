// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/files/image_line.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <iterator>

#include "isomatch/error.h"
#include "isomatch/io/material_libraries.h"

namespace isomatch::results {
namespace {

constexpr std::string_view kBlanks = " \t\v\f\r";

/// An option of an image and how many words it has; those that it need not have are numbers.
struct ImageOption {
  std::string_view name;
  int least, most;
};

constexpr std::array<ImageOption, 14> kOptions = {{{"-blendu", 1, 1},
                                                   {"-blendv", 1, 1},
                                                   {"-bm", 1, 1},
                                                   {"-boost", 1, 1},
                                                   {"-cc", 1, 1},
                                                   {"-clamp", 1, 1},
                                                   {"-colorspace", 1, 1},
                                                   {"-imfchan", 1, 1},
                                                   {"-mm", 2, 2},
                                                   {"-o", 1, 3},
                                                   {"-s", 1, 3},
                                                   {"-t", 1, 3},
                                                   {"-texres", 1, 1},
                                                   {"-type", 1, 1}}};

/// Bound the search: words of an option that is none of them, places where a name may end.
constexpr std::size_t kMostUnknownWords = 8, kMostEnds = 16;

bool names_image(std::string_view keyword) {
  // This one turns antialiasing on.
  if (keyword == "map_aat") return false;
  return keyword.starts_with("map_") || keyword == "bump" || keyword == "disp" ||
         keyword == "decal" || keyword == "refl" || keyword == "norm";
}

const ImageOption* find_option(std::string_view word) {
  const auto found = std::ranges::find(kOptions, word, &ImageOption::name);
  return found == kOptions.end() ? nullptr : &*found;
}

bool is_number(std::string_view word) {
  double value = 0;
  const auto [last, error] = std::from_chars(word.begin(), word.end(), value);
  return error == std::errc() && last == word.end();
}

std::string_view trimmed(std::string_view text) {
  const std::size_t start = std::min(text.find_first_not_of(kBlanks), text.size());
  return text.substr(start, text.find_last_not_of(kBlanks) + 1 - start);
}

/// The words of a line behind its keyword.
std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  for (std::string_view rest = trimmed(line); !rest.empty(); rest = trimmed(rest)) {
    words.push_back(rest.substr(0, rest.find_first_of(kBlanks)));
    rest.remove_prefix(words.back().size());
  }
  if (!words.empty()) words.erase(words.begin());
  return words;
}

using Words = std::vector<std::string_view>;

/// Where among the words the name may begin: several places if numbers may be of the last option
/// or of the name, or if an option is unknown. What is likely comes last, the number of words for
/// nowhere.
std::vector<std::size_t> possible_starts(const Words& words) {
  std::vector<std::size_t> starts;
  std::size_t at = 0;
  while (at < words.size()) {
    const ImageOption* const option = find_option(words[at]);
    if (!option) break;
    starts.clear();
    ++at;
    for (int k = 0; k < option->most && at < words.size(); ++k, ++at) {
      if (k < option->least) continue;
      if (!is_number(words[at])) break;
      starts.push_back(at);
    }
  }
  if (at < words.size() && words[at].starts_with('-'))
    for (std::size_t k = at + 1; k < std::min(words.size(), at + kMostUnknownWords); ++k)
      starts.push_back(k);
  starts.push_back(at);
  return starts;
}

/// Calls `is_file` with the text from word `start` to each place where the name may end, the last
/// place first, until it is one.
template <class IsFile>
std::optional<std::string_view> find_end(const Words& words, std::size_t start,
                                         const IsFile& is_file) {
  const char* const begin = words[start].data();
  std::size_t left = kMostEnds;
  for (std::size_t end = words.size(); end > start && left > 0; --end) {
    const bool may_end =
        end == words.size() || words[end].starts_with('#') || find_option(words[end]);
    if (!may_end) continue;
    --left;
    const std::string_view name(begin, words[end - 1].data() + words[end - 1].size());
    if (is_file(name)) return name;
  }
  return std::nullopt;
}

}  // namespace

std::vector<std::string> material_lines(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!file) throw BadFile(path, "cannot be read");
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  std::size_t at = text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
  std::vector<std::string> lines;
  while (at < text.size()) {
    const std::size_t end = std::min(text.find_first_of("\r\n", at), text.size());
    lines.push_back(text.substr(at, end - at));
    at = end + (text.compare(end, 2, "\r\n") == 0 ? 2 : 1);
  }
  return lines;
}

std::string_view keyword_of(std::string_view line) {
  const std::string_view text = trimmed(line);
  return text.substr(0, text.find_first_of(kBlanks));
}

std::optional<std::string> new_material(std::string_view line) {
  constexpr std::string_view kKeyword = "newmtl";
  if (keyword_of(line) != kKeyword) return std::nullopt;
  return std::string(trimmed(trimmed(line).substr(kKeyword.size())));
}

std::optional<ImageLine> image_line(const std::string& line, const std::string& library) {
  if (!names_image(keyword_of(line))) return std::nullopt;
  const Words words = words_of(line);
  const std::vector<std::size_t> starts = possible_starts(words);
  const std::string_view whole = line;
  const auto parts = [&](std::string_view name, std::string path) {
    return ImageLine{{whole.begin(), name.begin()},
                     std::string(name),
                     {name.end(), whole.end()},
                     std::move(path)};
  };
  std::string path;
  const auto is_file = [&](std::string_view name) {
    path = find_named_file(std::string(name), library);
    return !path.empty();
  };
  for (const std::size_t start : starts)
    if (start < words.size())
      if (const auto name = find_end(words, start, is_file)) return parts(*name, path);
  if (starts.back() == words.size()) return std::nullopt;
  return parts({words[starts.back()].begin(), words.back().end()}, "");
}

}  // namespace isomatch::results
