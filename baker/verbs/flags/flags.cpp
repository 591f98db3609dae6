// SPDX-License-Identifier: MIT
#include "verbs/flags/flags.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <utility>

#include "verbs/flags/known_words.h"
#include "verbs/flags/moments.h"
#include "verbs/flags/named_files.h"
#include "verbs/flags/verb.h"
#include "verbs/reports/progress_bar.h"

namespace coppermoon::verbs {
namespace {

using request::Affects, request::Kind;

/// Name of a kind's values in CLI11, which its messages and named_files.h know.
const char* type_name(Kind kind) {
  switch (kind) {
    case Kind::number:
      return "FLOAT";
    case Kind::whole:
      return "INT";
    case Kind::natural:
      return "UINT";
    case Kind::file_read:
      return read_file;
    case Kind::file_written:
      return written_file;
    case Kind::folder_written:
      return written_folder;
    default:
      return "TEXT";
  }
}

CLI::Option* option_for(CLI::App& verb, request::Parameter& parameter) {
  const auto& name = parameter.spelling;
  const auto spelling = name.find("--") == std::string::npos ? "--" + name : name;
  if (parameter.kind == Kind::presence)
    return verb.add_flag_function(
        spelling,
        [&parameter](std::int64_t count) {
          parameter.take(count > 0 ? request::Texts{"true"} : request::Texts{});
        },
        parameter.meaning);
  auto* option = verb.add_option(
      spelling,
      [&parameter](const CLI::results_t& texts) {
        try {
          parameter.take(texts);
        } catch (const request::UnknownWord& error) {
          throw WrongUsage(fmt::format("--{}", error.what()));
        }
        return true;
      },
      parameter.meaning);
  option->type_name(type_name(parameter.kind))->default_str(parameter.usual);
  if (is_number(parameter.kind) && !parameter.respelt)
    option->check(CLI::Validator(
        [kind = parameter.kind](const std::string& text) { return fault_in(kind, text); }, ""));
  if (!parameter.words.empty()) option->check(CLI::IsMember(parameter.words));
  if (parameter.many)
    option->expected(1, CLI::detail::expected_max_vector_size)->allow_extra_args(!parameter.parts);
  return option;
}

}  // namespace

request::Parameters& parameters_of(CLI::App& verb) { return dynamic_cast<Verb&>(verb).parameters; }

const request::Parameters& parameters_of(const CLI::App& verb) {
  return dynamic_cast<const Verb&>(verb).parameters;
}

Flag Flag::in(const std::string& group) const {
  option_->group(parameter_->heading = group);
  return *this;
}

Flag Flag::one_of(std::vector<std::string> words) const {
  parameter_->words = words;
  parameter_->kind = Kind::word;
  option_->check(CLI::IsMember(std::move(words)));
  return *this;
}

Flag Flag::within(double low, double high) const {
  parameter_->within(low, high);
  return *this;
}

Flag Flag::required() const {
  parameter_->required = true;
  option_->required();
  return *this;
}

Flag Flag::excludes(const std::string& flag) const {
  option_->excludes(flag);
  return *this;
}

Flag Flag::reads_file() const {
  parameter_->kind = Kind::file_read;
  option_->type_name(read_file);
  return *this;
}

Flag Flag::writes_file() const {
  parameter_->kind = Kind::file_written;
  option_->type_name(written_file);
  return of(Affects::run);
}

Flag Flag::writes_folder() const {
  parameter_->kind = Kind::folder_written;
  option_->type_name(written_folder);
  return of(Affects::run);
}

Flag Flag::kept_each_time() const {
  parameter_->many = true;
  option_->default_str("")->expected(1)->take_all();
  return *this;
}

Flag Flag::one_value_each_time() const {
  option_->allow_extra_args(false);
  return *this;
}

Flag Flag::of(Affects what) const {
  parameter_->affects = what;
  return *this;
}

Flag Flag::only_with(request::Conditions any) const {
  parameter_->only_with(std::move(any));
  return *this;
}

Flag Flag::not_beside(request::Conditions any) const {
  parameter_->not_beside(std::move(any));
  return *this;
}

Flag add_flag(CLI::App& verb, request::Parameter parameter) {
  auto& all = parameters_of(verb);
  all.begin("", "", Affects::ground);
  auto& mine = all.add(std::move(parameter));
  return {*option_for(verb, mine), mine};
}

void add_flags(CLI::App& verb, request::Parameters parameters) {
  auto& all = parameters_of(verb);
  for (auto& parameter : parameters) {
    auto& mine = all.keep(std::move(parameter));
    auto* option = option_for(verb, mine);
    if (!mine.heading.empty()) option->group(mine.heading);
  }
}

Flag add_parsed(CLI::App& verb, const std::string& names,
                std::function<void(const std::string&)> take, const std::string& help,
                const std::string& text) {
  request::Parameter parameter{.name = request::name_in(names), .spelling = names, .meaning = help};
  parameter.read = [text] { return text.empty() ? request::Texts{} : request::Texts{text}; };
  parameter.write = [take = std::move(take)](const request::Texts& texts) { take(texts.back()); };
  parameter.restore = [] {};
  return add_flag(verb, std::move(parameter));
}

Flag add_switch(CLI::App& verb, const std::string& names, bool& value, const std::string& help) {
  return add_flag(verb, request::presence(names, value, help));
}

Flag add_run_switch(CLI::App& verb, const std::string& names, bool& value,
                    const std::string& help) {
  return add_switch(verb, names, value, help).of(Affects::run);
}

void add_json_switch(CLI::App& verb, bool& value, std::vector<result::Fields> documents) {
  add_run_switch(verb, "--json", value, "prints one JSON document");
  dynamic_cast<Verb&>(verb).documents = std::move(documents);
}

CLI::App* add_verb(CLI::App& program, const std::string& name, const std::string& help) {
  return program.add_subcommand(std::make_shared<Verb>(program, name, help));
}

void on_run(CLI::App& verb, std::function<void()> run) {
  verb.callback([&verb, run = std::move(run)] {
    require_files_apart(verb);
    say_which_city(verb);
    say_what_is_utc(verb);
    say_what_has_no_effect(verb);
    const AtWork at_work(verb.get_name());
    run();
  });
}

void say_what_has_no_effect(const CLI::App& verb) {
  const auto& typed = dynamic_cast<const Verb&>(verb).typed;
  for (const auto& line : without_effect(
           parameters_of(verb), [](const auto& parameter) { return "--" + parameter.name; },
           [&](const auto& parameter) {
             return holds(typed, parameter.name) || parameter.text() != parameter.usual;
           }))
    fmt::print(stderr, "coppermoon: {}\n", line);
}

bool is_given(const CLI::App& verb, const std::string& name) {
  const auto* parameter = parameters_of(verb).find(name);
  return parameter != nullptr && parameter->given;
}

}  // namespace coppermoon::verbs
