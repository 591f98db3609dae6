// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace coppermoon::verbs {

/// A command line, or a recipe, that cannot be understood: exit status 2.
struct WrongUsage : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A flag while a verb describes it. What it stands on, CLI11, costs seconds to compile: flags.cpp
/// pays them once for all verbs.
class Flag {
 public:
  explicit Flag(CLI::Option& option) : option_(&option) {}

  Flag in(const std::string& group) const;  ///< the heading that --help lists it under
  Flag one_of(std::vector<std::string> words) const;
  Flag not_negative() const;
  Flag within(double low, double high) const;
  Flag required() const;
  Flag excludes(const std::string& flag) const;
  Flag reads_file() const;           ///< the value names a file that is read
  Flag writes_file() const;          ///< the value names a file that is written
  Flag writes_folder() const;        ///< the value names a folder that files are written into
  Flag kept_each_time() const;       ///< may be given again; every value is kept
  Flag one_value_each_time() const;  ///< may be given again; what follows a value is no second one

 private:
  CLI::Option* option_;
};

/// A flag of one of some words: `take` is told which.
Flag add_word(CLI::App& verb, const std::string& names, const std::vector<std::string>& words,
              const std::string& text, const std::string& help,
              std::function<void(std::size_t)> take);

template <typename Value>
std::vector<std::string> names_of(const std::vector<std::pair<std::string, Value>>& words) {
  std::vector<std::string> names;
  for (const auto& word : words) names.push_back(word.first);
  return names;
}

/// A flag with a value.
///
/// Given  names  as "-o,--output", or "instant,--instant" for one that needs no name
///        value  where the value is put; what is there is the default
/// Value is double, int, std::size_t or std::string, an std::optional of these, or a list of
/// std::string.
template <typename Value>
Flag add_flag(CLI::App& verb, const std::string& names, Value& value, const std::string& help);

/// A flag whose value is read by a function, as "2s" or "42.86,-73.77".
///
/// Given  take  told the text; throws algebra::Error for one that it cannot understand
///        text  of the default, where it has one
Flag add_parsed(CLI::App& verb, const std::string& names,
                std::function<void(const std::string&)> take, const std::string& help,
                const std::string& text = "");

/// A flag that names files, each time one.
Flag add_files(CLI::App& verb, const std::string& names, std::vector<std::filesystem::path>& files,
               const std::string& help);

/// A flag whose value is one of some words, each of which means something.
///
/// Given  value  where the meaning is put; the word for what is there is the default
template <typename Value>
Flag add_choice(CLI::App& verb, const std::string& names, Value& value,
                const std::vector<std::pair<std::string, Value>>& words, const std::string& help) {
  const auto word_of = [&] {
    for (const auto& [word, meaning] : words)
      if (meaning == value) return word;
    return std::string();
  };
  return add_word(verb, names, names_of(words), word_of(), help,
                  [&value, words](std::size_t i) { value = words[i].second; });
}

/// The same without a default.
template <typename Value>
Flag add_choice(CLI::App& verb, const std::string& names, std::optional<Value>& value,
                const std::vector<std::pair<std::string, Value>>& words, const std::string& help) {
  return add_word(verb, names, names_of(words), "", help,
                  [&value, words](std::size_t i) { value = words[i].second; });
}

/// "on" or "off".
Flag add_on_off(CLI::App& verb, const std::string& names, bool& value, const std::string& help);
Flag add_on_off(CLI::App& verb, const std::string& names, std::optional<bool>& value,
                const std::string& help);

/// A flag without a value.
Flag add_switch(CLI::App& verb, const std::string& names, bool& value, const std::string& help);

/// Returned  the new word of the command line
CLI::App* add_verb(CLI::App& program, const std::string& name, const std::string& help);

/// What a verb does, once its flags are read, and its files are known to be apart
/// (require_files_apart).
void on_run(CLI::App& verb, std::function<void()> run);

/// Whether the command line, or a recipe, gives a flag of that name.
bool is_given(const CLI::App& verb, const std::string& flag);

/// Words of a command line, "--flag", "value", for the flags of a list (without dashes) that are given. Names of
/// files that are read are those to share (files::name_to_share).
std::vector<std::string> words_given(const CLI::App& verb, const std::vector<std::string>& flags);

/// The heading that a flag stands under, empty when the verb has no such flag.
std::string heading_of(const CLI::App& verb, const std::string& flag);

}  // namespace coppermoon::verbs
