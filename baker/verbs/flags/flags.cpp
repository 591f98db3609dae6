// SPDX-License-Identifier: MIT
#include "verbs/flags/flags.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <optional>
#include <system_error>
#include <type_traits>
#include <utility>

#include "algebra/number.h"
#include "files/name_to_share.h"
#include "verbs/flags/moments.h"
#include "verbs/flags/named_files.h"

namespace coppermoon::verbs {

Flag Flag::in(const std::string& group) const {
  option_->group(group);
  return *this;
}

Flag Flag::one_of(std::vector<std::string> words) const {
  option_->check(CLI::IsMember(std::move(words)));
  return *this;
}

Flag Flag::not_negative() const {
  option_->check(CLI::NonNegativeNumber);
  return *this;
}

Flag Flag::within(double low, double high) const {
  option_->check(CLI::Range(low, high));
  return *this;
}

Flag Flag::required() const {
  option_->required();
  return *this;
}

Flag Flag::excludes(const std::string& flag) const {
  option_->excludes(flag);
  return *this;
}

Flag Flag::reads_file() const {
  option_->type_name(read_file);
  return *this;
}

Flag Flag::writes_file() const {
  option_->type_name(written_file);
  return *this;
}

Flag Flag::writes_folder() const {
  option_->type_name(written_folder);
  return *this;
}

Flag Flag::kept_each_time() const {
  option_->default_str("")->expected(1)->take_all();
  return *this;
}

Flag Flag::one_value_each_time() const {
  option_->allow_extra_args(false);
  return *this;
}

namespace {

/// What is wrong with a text that is to be a whole number; nothing where CLI11 is left to say it.
template <typename Whole>
std::string fault_of(const std::string& text) {
  const auto end = text.data() + text.size();
  const auto begin = text.data() + text.starts_with('+');
  Whole whole{};
  const auto [rest, failed] = std::from_chars(begin, end, whole);
  const bool number = algebra::number_in(text).has_value();
  if (failed == std::errc() && rest == end) return {};
  if (std::is_unsigned_v<Whole> && number && text.starts_with('-'))
    return fmt::format("{}, allowed whole numbers, 0 or more", text);
  if (failed == std::errc::result_out_of_range)
    return fmt::format("{}, allowed {} to {}", text, std::numeric_limits<Whole>::min(),
                       std::numeric_limits<Whole>::max());
  return number ? fmt::format("{}, allowed whole numbers", text) : "";
}

template <typename Value>
struct Single {
  using Type = Value;
};
template <typename Value>
struct Single<std::optional<Value>> {
  using Type = Value;
};

}  // namespace

template <typename Value>
Flag add_flag(CLI::App& verb, const std::string& names, Value& value, const std::string& help) {
  auto* option = verb.add_option(names, value, help);
  using Type = typename Single<Value>::Type;
  if constexpr (std::is_integral_v<Type>) option->check(CLI::Validator(fault_of<Type>, ""));
  return Flag(*option);
}

template Flag add_flag(CLI::App&, const std::string&, double&, const std::string&);
template Flag add_flag(CLI::App&, const std::string&, int&, const std::string&);
template Flag add_flag(CLI::App&, const std::string&, std::size_t&, const std::string&);
template Flag add_flag(CLI::App&, const std::string&, std::string&, const std::string&);
template Flag add_flag(CLI::App&, const std::string&, std::optional<double>&, const std::string&);
template Flag add_flag(CLI::App&, const std::string&, std::optional<int>&, const std::string&);
template Flag add_flag(CLI::App&, const std::string&, std::optional<std::size_t>&,
                       const std::string&);
template Flag add_flag(CLI::App&, const std::string&, std::optional<std::string>&,
                       const std::string&);
template Flag add_flag(CLI::App&, const std::string&, std::vector<std::string>&,
                       const std::string&);

Flag add_parsed(CLI::App& verb, const std::string& names,
                std::function<void(const std::string&)> take, const std::string& help,
                const std::string& text) {
  auto* option = verb.add_option_function<std::string>(names, std::move(take), help);
  option->default_str(text);
  return Flag(*option);
}

Flag add_files(CLI::App& verb, const std::string& names, std::vector<std::filesystem::path>& files,
               const std::string& help) {
  return Flag(*verb.add_option_function<std::vector<std::string>>(
      names,
      [&files](const std::vector<std::string>& paths) { files.assign(paths.begin(), paths.end()); },
      help));
}

Flag add_word(CLI::App& verb, const std::string& names, const std::vector<std::string>& words,
              const std::string& text, const std::string& help,
              std::function<void(std::size_t)> take) {
  const auto index_of = [words](const std::string& word) {
    return static_cast<std::size_t>(std::ranges::find(words, word) - words.begin());
  };
  return add_parsed(
             verb, names,
             [index_of, take = std::move(take)](const std::string& word) { take(index_of(word)); },
             help, text)
      .one_of(words);
}

Flag add_on_off(CLI::App& verb, const std::string& names, bool& value, const std::string& help) {
  return add_choice<bool>(verb, names, value, {{"on", true}, {"off", false}}, help);
}

Flag add_on_off(CLI::App& verb, const std::string& names, std::optional<bool>& value,
                const std::string& help) {
  return add_choice<bool>(verb, names, value, {{"on", true}, {"off", false}}, help);
}

Flag add_switch(CLI::App& verb, const std::string& names, bool& value, const std::string& help) {
  return Flag(*verb.add_flag(names, value, help));
}

CLI::App* add_verb(CLI::App& program, const std::string& name, const std::string& help) {
  return program.add_subcommand(name, help);
}

void on_run(CLI::App& verb, std::function<void()> run) {
  verb.callback([&verb, run = std::move(run)] {
    require_files_apart(verb);
    say_what_is_utc(verb);
    run();
  });
}

bool is_given(const CLI::App& verb, const std::string& flag) {
  const auto* option = verb.get_option_no_throw(flag);
  return option != nullptr && option->count() > 0;
}

std::vector<std::string> words_given(const CLI::App& verb, const std::vector<std::string>& flags) {
  std::vector<std::string> words;
  for (const auto& flag : flags) {
    const auto* option = verb.get_option_no_throw("--" + flag);
    if (option == nullptr) continue;
    const bool file = option->get_type_name() == read_file;
    for (const auto& value : option->results())
      words.insert(words.end(), {"--" + flag, file ? files::name_to_share(value) : value});
  }
  return words;
}

std::string heading_of(const CLI::App& verb, const std::string& flag) {
  const auto* option = verb.get_option_no_throw(flag);
  return option != nullptr ? option->get_group() : "";
}

}  // namespace coppermoon::verbs
