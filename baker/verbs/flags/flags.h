// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "files/endings.h"
#include "request/parameter.h"

namespace coppermoon::result {
struct Fields;
}  // namespace coppermoon::result

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace coppermoon::verbs {

/// A command line, or a recipe, that cannot be understood: exit status 2.
struct WrongUsage : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A flag that a verb has just got, and its parameter.
class Flag {
 public:
  Flag(CLI::Option& option, request::Parameter& parameter)
      : option_(&option), parameter_(&parameter) {}

  Flag in(const std::string& group) const;  ///< the heading that --help lists it under
  Flag one_of(std::vector<std::string> words) const;
  Flag within(double low, double high) const;
  Flag required() const;
  Flag excludes(const std::string& flag) const;
  Flag reads_file() const;   ///< the value names a file that is read
  Flag writes_file() const;  ///< the value names a file that is written
  /// The value names a file that is written, in one of the formats of a table.
  template <class Formats>
  Flag writes_file(const Formats& formats) const {
    for (const files::Ending& format : formats)
      parameter_->endings.emplace_back(format.ending, format.help);
    return writes_file();
  }
  Flag writes_folder() const;        ///< the value names a folder that files are written into
  Flag kept_each_time() const;       ///< may be given again; every value is kept
  Flag one_value_each_time() const;  ///< may be given again; what follows a value is no second one
  Flag of(request::Affects what) const;
  Flag only_with(request::Conditions any) const;
  Flag not_beside(request::Conditions any) const;

 private:
  CLI::Option* option_;
  request::Parameter* parameter_;
};

/// Parameters of all flags that a verb has.
request::Parameters& parameters_of(CLI::App& verb);
const request::Parameters& parameters_of(const CLI::App& verb);

/// A flag for a parameter, which the verb keeps.
Flag add_flag(CLI::App& verb, request::Parameter parameter);

/// Flags for all parameters that a request describes.
void add_flags(CLI::App& verb, request::Parameters parameters);

template <class Request>
void add_described(CLI::App& verb, Request& request) {
  request::Parameters parameters;
  describe(parameters, request);
  add_flags(verb, std::move(parameters));
}

/// Flags for the parameters that one of a request's functions describes, as uses::describe_map.
template <class Request>
void add_described(CLI::App& verb, Request& request,
                   void (*some)(request::Parameters&, std::type_identity_t<Request>&)) {
  request::Parameters parameters;
  some(parameters, request);
  add_flags(verb, std::move(parameters));
}

/// A flag with a value, as request::parameter has it.
template <typename Value>
Flag add_flag(CLI::App& verb, const std::string& names, Value& value, const std::string& help) {
  return add_flag(verb, request::parameter(names, value, help));
}

/// A flag whose value is read by a function, as "2s" or "42.86,-73.77".
///
/// Given  take  reads the text; throws algebra::Error when it cannot
///        text  of the default, where it has one
Flag add_parsed(CLI::App& verb, const std::string& names,
                std::function<void(const std::string&)> take, const std::string& help,
                const std::string& text = "");

/// A flag whose value is one of some words, as request::choice has it.
template <typename Value, typename Field>
Flag add_choice(CLI::App& verb, const std::string& names, Field& value,
                const request::Words<Value>& words, const std::string& help) {
  return add_flag(verb, request::choice(names, value, words, help));
}

/// A flag without a value.
Flag add_switch(CLI::App& verb, const std::string& names, bool& value, const std::string& help);

/// A flag without a value that says how this run goes, as --json: no recipe holds it.
Flag add_run_switch(CLI::App& verb, const std::string& names, bool& value, const std::string& help);

/// Adds --json, and says which documents it prints (`coppermoon describe`).
void add_json_switch(CLI::App& verb, bool& value, std::vector<result::Fields> documents);

/// Returned  the new word of the command line
CLI::App* add_verb(CLI::App& program, const std::string& name, const std::string& help);

/// What a verb does, once its flags are read, and its files are known to be apart
/// (require_files_apart).
void on_run(CLI::App& verb, std::function<void()> run);

/// Says on stderr which options have no effect beside the others. Of a recipe, which may hold all values, those that
/// differ from the usual ones are.
void say_what_has_no_effect(const CLI::App& verb);

/// Whether the command line, or a recipe, gives that parameter.
bool is_given(const CLI::App& verb, const std::string& name);

}  // namespace coppermoon::verbs
