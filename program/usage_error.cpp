// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "program/usage_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "program/closest_word.h"

namespace isomatch::cli {
namespace {

bool is_option(const std::string& word) { return word.size() > 1 && word[0] == '-'; }

std::string meant(const std::optional<std::string>& word) {
  return word ? fmt::format("; did you mean {}?", *word) : "";
}

bool is_like_a_file(const std::string& word) {
  std::error_code error;
  return word.find_first_of("./") != std::string::npos || std::filesystem::exists(word, error);
}

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  return names;
}

std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

/// What is wrong where a command is expected.
std::string command_error(const CLI::App& app, const std::vector<std::string>& words) {
  std::vector<std::string> given;
  std::ranges::copy_if(words.begin() + 1, words.end(), std::back_inserter(given),
                       [](const std::string& word) { return !is_option(word); });
  if (given.empty()) return "there is no command";
  if (given.size() > 1 && is_like_a_file(given[0]))
    return fmt::format("there is no command; did you mean {} match {} {}?", app.get_name(),
                       given[0], given[1]);
  return fmt::format("unknown command '{}'{}", given[0],
                     meant(closest_word(given[0], command_names(app))));
}

/// The option without its value, and with both of its dashes.
std::string name_of(const std::string& option) {
  const std::size_t begin = option.find_first_not_of('-');
  return begin == std::string::npos ? option
                                    : "--" + option.substr(begin, option.find('=') - begin);
}

/// What is wrong with the words that `command` does not know, if there are any.
std::optional<std::string> word_error(const CLI::App& command,
                                      const std::vector<std::string>& words) {
  const std::vector<std::string> unknown = command.remaining();
  const auto find = [&](const auto& wanted) {
    return std::ranges::find_if(words, [&](const std::string& word) {
      return wanted(word) && std::ranges::count(unknown, word) > 0;
    });
  };
  if (const auto option = find(is_option); option != words.end())
    return fmt::format("unknown option {}{}", option->substr(0, option->find('=')),
                       meant(closest_word(name_of(*option), option_names(command))));
  const auto word = find([](const std::string&) { return true; });
  if (word == words.end()) return std::nullopt;
  return fmt::format("there is one word too many, '{}'", *word);
}

}  // namespace

std::string usage_error(const CLI::App& app, const std::vector<std::string>& words,
                        const CLI::ParseError& error) {
  const std::vector<CLI::App*> chosen = app.get_subcommands();
  const CLI::App& command = chosen.empty() ? app : *chosen.front();
  const std::string help =
      chosen.empty() ? app.get_name() : app.get_name() + " " + command.get_name();
  const bool lacks_command = chosen.empty() && !command_names(app).empty();
  const bool begins_with_option = words.size() > 1 && is_option(words[1]);
  const std::optional<std::string> reason =
      lacks_command && !begins_with_option ? command_error(app, words) : word_error(command, words);
  return fmt::format("{} (see {} --help)", reason.value_or(error.what()), help);
}

std::vector<std::string> with_help_as_option(const CLI::App& app, std::vector<std::string> words) {
  if (words.size() < 2 || words[1] != "help") return words;
  words.erase(words.begin() + 1);
  if (words.size() == 1 || std::ranges::count(command_names(app), words[1]) > 0)
    words.emplace_back("--help");
  return words;
}

}  // namespace isomatch::cli
