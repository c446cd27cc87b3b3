// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "program/help_format.h"

#include <sstream>
#include <string_view>

namespace isomatch::cli {
namespace {

constexpr std::size_t kColumn = 30, kLine = 80;

/// `type` as CLI11 makes it of the variable and the checks: TEXT:{a,b}, N:INT in [1 - 9].
std::string short_type(const std::string& type) {
  if (const std::size_t choice = type.find('{'); choice != std::string::npos)
    return type.substr(choice, type.rfind('}') + 1 - choice);
  const std::string name = type.substr(0, type.find(':'));
  if (name == "INT" || name == "UINT") return "N";
  return name == "FLOAT" ? "X" : name;
}

/// Breaks lines between words.
std::string wrapped(const std::string& text, std::size_t width) {
  std::istringstream words(text);
  std::string lines, word;
  for (std::size_t length = 0; words >> word; length += word.size()) {
    const bool fits = length + 1 + word.size() <= width;
    if (length > 0) lines += fits ? ' ' : '\n';
    length = fits && length > 0 ? length + 1 : 0;
    lines += word;
  }
  return lines;
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at))
    text.replace(at, from.size(), to);
}

}  // namespace

HelpFormat::HelpFormat() { column_width(kColumn); }

std::string HelpFormat::make_help(const CLI::App* app, std::string name,
                                  CLI::AppFormatMode mode) const {
  std::string help = Formatter::make_help(app, std::move(name), mode);
  replace_all(help, "\n\n\n", "\n\n");
  return help;
}

std::string HelpFormat::make_option_name(const CLI::Option* option, bool is_positional) const {
  const std::string name = Formatter::make_option_name(option, is_positional);
  // Of a flag that turns something off.
  return name.substr(0, name.find('{'));
}

std::string HelpFormat::make_option_opts(const CLI::Option* option) const {
  if (option->get_type_size() == 0 || option->get_positional()) return "";
  const std::string type = short_type(option->get_type_name());
  std::string text = " " + type;
  for (int k = 1; k < option->get_expected_min(); ++k) text += " " + type;
  if (option->get_expected_max() == CLI::detail::expected_max_vector_size) text += "...";
  if (!option->get_default_str().empty()) text += "=" + option->get_default_str();
  return option->get_required() ? text + " REQUIRED" : text;
}

std::string HelpFormat::make_option_desc(const CLI::Option* option) const {
  std::string text = option->get_description();
  for (const CLI::Option* needed : option->get_needs()) text += "; needs " + needed->get_name();
  return wrapped(text, kLine - kColumn);
}

}  // namespace isomatch::cli
