// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/io/values_io.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>

#include "io/input_file.h"
#include "io/line_writer.h"
#include "io/number_table.h"
#include "io/text_cursor.h"
#include "io/whole_number.h"

namespace isomatch {
namespace {

/// Calls `read_line` at the beginning of every line and checks their number.
template <class ReadLine>
void read_lines(const InputFile& file, TextCursor cursor, int num_vertices,
                const ReadLine& read_line) {
  int lines = 0;
  for (; cursor.find_content(); ++lines) {
    if (lines == num_vertices)
      cursor.fail(fmt::format("more lines than the mesh has vertices, {}", num_vertices));
    read_line(cursor);
    cursor.expect_line_end();
  }
  if (lines != num_vertices)
    file.fail(fmt::format("has {} lines, but the mesh has {} vertices", lines, num_vertices));
}

double read_value(TextCursor& cursor) {
  if (!equal_ignoring_case(cursor.peek_word(), "nan")) return cursor.number();
  cursor.word();
  return std::numeric_limits<double>::quiet_NaN();
}

Influence read_influence(const TextCursor& before, std::string_view word) {
  Influence influence{};
  const char* const end = std::to_address(word.end());
  const auto bone = std::from_chars(std::to_address(word.begin()), end, influence.bone);
  const bool separated = bone.ec == std::errc() && bone.ptr != end && *bone.ptr == ':';
  const auto weight = std::from_chars(separated ? bone.ptr + 1 : end, end, influence.weight);
  if (!separated || weight.ec != std::errc() || weight.ptr != end || influence.bone < 0)
    before.fail(fmt::format("expected BONE:WEIGHT, found {}", in_quotes(word)));
  if (!std::isfinite(influence.weight) || influence.weight < 0)
    before.fail(fmt::format("the weight in {} is not a number from 0", in_quotes(word)));
  return influence;
}

std::vector<Influence> read_influences(TextCursor& cursor) {
  std::vector<Influence> influences;
  if (cursor.peek_word() == "-") {
    cursor.word();
    return influences;
  }
  while (!cursor.at_line_end()) {
    const TextCursor before = cursor;
    influences.push_back(read_influence(before, cursor.word()));
  }
  std::ranges::sort(influences, {}, &Influence::bone);
  if (std::ranges::adjacent_find(influences, {}, &Influence::bone) != influences.end())
    cursor.fail("a bone occurs twice");
  return influences;
}

}  // namespace

Eigen::MatrixXd read_values(const std::string& path, int num_vertices) {
  const InputFile file(path);
  std::vector<double> values;
  std::size_t columns = 0;
  read_lines(file, table_rows(file), num_vertices, [&](TextCursor& cursor) {
    const std::size_t before = values.size();
    for (; !cursor.at_line_end(); cursor.skip_separator()) values.push_back(read_value(cursor));
    if (before == 0) columns = values.size();
    if (values.size() - before != columns)
      cursor.fail(
          fmt::format("{} values, but {} on the first line", values.size() - before, columns));
  });
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  return Eigen::Map<const Rows>(values.data(), num_vertices, static_cast<Eigen::Index>(columns));
}

void write_values(const std::string& path, const Eigen::MatrixXd& values) {
  const bool is_csv = equal_ignoring_case(std::filesystem::path(path).extension().string(), ".csv");
  const char* const separator = is_csv ? "," : " ";
  AtomicFile file(path);
  LineWriter lines(file);
  for (const auto& row : values.rowwise()) lines.add("{}", fmt::join(row, separator));
  file.commit();
}

std::vector<int> read_labels(const std::string& path, int num_vertices) {
  const InputFile file(path);
  std::vector<int> labels;
  read_lines(file, table_rows(file), num_vertices, [&](TextCursor& cursor) {
    const TextCursor before = cursor;
    const std::int64_t label = whole_number(cursor);
    if (label < kNoLabel || label > std::numeric_limits<int>::max())
      before.fail(fmt::format("label {} is out of range", label));
    labels.push_back(static_cast<int>(label));
  });
  return labels;
}

void write_labels(const std::string& path, const std::vector<int>& labels) {
  AtomicFile file(path);
  LineWriter lines(file);
  for (const int label : labels) lines.add("{}", label);
  file.commit();
}

SkinWeights read_skin_weights(const std::string& path, int num_vertices) {
  const InputFile file(path);
  SkinWeights weights;
  read_lines(file, TextCursor(file, kNumberLines), num_vertices,
             [&](TextCursor& cursor) { weights.push_back(read_influences(cursor)); });
  return weights;
}

void write_skin_weights(const std::string& path, const SkinWeights& weights) {
  AtomicFile file(path);
  LineWriter lines(file);
  std::vector<std::string> words;
  for (const auto& influences : weights) {
    words.clear();
    for (const auto& [bone, weight] : influences)
      words.push_back(fmt::format("{}:{}", bone, weight));
    lines.add("{}", words.empty() ? "-" : fmt::format("{}", fmt::join(words, " ")));
  }
  file.commit();
}

}  // namespace isomatch
