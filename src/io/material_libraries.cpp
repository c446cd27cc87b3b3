// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/io/material_libraries.h"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <vector>

#include "io/text_cursor.h"

namespace isomatch {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kBlanks = " \t\v\f\r";
/// Bound the search where a line names several files. The name of a single file may have more.
constexpr std::size_t kMostWordsOfName = 16, kMostWordsOfLine = 256;
/// No file has a longer path.
constexpr std::size_t kLongestPath = 4096;

std::vector<std::string_view> split(std::string_view text) {
  std::vector<std::string_view> words;
  for (std::size_t at = text.find_first_not_of(kBlanks); at != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(kBlanks, at), text.size());
    words.push_back(text.substr(at, end - at));
    at = text.find_first_not_of(kBlanks, end);
  }
  return words;
}

/// The text from the first word to the last one, which are parts of the same text.
std::string joined(std::string_view first, std::string_view last) {
  return {first.begin(), last.end()};
}

bool ends_with_mtl(std::string_view word) {
  return word.size() > 4 && equal_ignoring_case(word.substr(word.size() - 4), ".mtl");
}

/// Takes a line of several names apart, as `material_libraries` says.
class NameSplitter {
 public:
  NameSplitter(const std::string& text, const std::string& beside)
      : words_(split(text)), beside_(beside) {}

  std::vector<std::string> names() {
    for (std::size_t at = 0; at < words_.size();) {
      if (const std::size_t count = words_of_file(at); count > 0) {
        end_name(at);
        end_name(at += count);
      } else if (at == begin_ && at > 0 && words_[at].starts_with('#')) {
        return names_;
      } else if (ends_with_mtl(words_[at++])) {
        end_name(at);
      }
    }
    end_name(words_.size());
    return names_;
  }

 private:
  /// How many words from `at` on are the name of a file; 0 if none are.
  std::size_t words_of_file(std::size_t at) const {
    for (std::size_t count = std::min(words_.size() - at, kMostWordsOfName); count > 0; --count)
      if (!find_named_file(joined(words_[at], words_[at + count - 1]), beside_).empty())
        return count;
    return 0;
  }

  /// The words in front of `end` that are in no name yet are one.
  void end_name(std::size_t end) {
    if (end > begin_) names_.push_back(joined(words_[begin_], words_[end - 1]));
    begin_ = end;
  }

  std::vector<std::string_view> words_;
  const std::string& beside_;
  std::vector<std::string> names_;
  std::size_t begin_ = 0;
};

std::vector<std::string> names_in(const std::string& text, const std::string& beside) {
  if (text.empty()) return {};
  if (!find_named_file(text, beside).empty() || split(text).size() > kMostWordsOfLine)
    return {text};
  return NameSplitter(text, beside).names();
}

std::string replaced(std::string_view text, std::string_view from, char to) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const bool is_there = text.substr(at, from.size()) == from;
    result += is_there ? to : text[at];
    at += is_there ? from.size() : 1;
  }
  return result;
}

std::string unquoted(const std::string& name) {
  const bool quoted = name.size() > 2 && name.front() == '"' && name.back() == '"';
  return quoted ? name.substr(1, name.size() - 2) : name;
}

}  // namespace

std::string find_named_file(const std::string& name, const std::string& beside) {
  if (name.empty() || name.size() > kLongestPath) return {};
  const fs::path folder = fs::path(beside).parent_path();
  const std::string bare = unquoted(name);
  for (const std::string& form :
       {name, bare, replaced(bare, "\\ ", ' '), replaced(replaced(bare, "\\\\", '/'), "\\", '/')}) {
    std::error_code error;
    if (const fs::path path = folder / form; fs::is_regular_file(path, error)) return path.string();
  }
  return {};
}

std::vector<std::string> material_libraries(const std::string& path) {
  const InputFile file(path);
  std::vector<std::string> names;
  TextCursor cursor(file, {.comments = true, .continuations = true});
  while (cursor.find_content()) {
    if (cursor.word() == "mtllib")
      for (std::string& name : names_in(cursor.rest_of_line(), path))
        if (std::ranges::find(names, name) == names.end()) names.push_back(std::move(name));
    cursor.skip_line();
  }
  return names;
}

}  // namespace isomatch
