// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "request/parameter.h"
#include "result/fields.h"

namespace coppermoon::verbs {

/// Error in the use of the program, such as an unknown flag or recipe key. The program then exits with status 2.
struct WrongUsage : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Program;

/// Functions that describe the documents that --json may print. They are called only when needed.
using Documents = std::vector<result::Fields (*)()>;

/// A command and its parameters.
struct Verb {
  std::string name{}, help{};
  request::Parameters parameters{};
  std::function<void()> run{};  ///< runs the command once its parameters are set
  Program* program = nullptr;   ///< nullptr if the command only serves to read a recipe
  Documents documents{};
  std::vector<std::string> typed{};  ///< parameters set on the command line, not by a recipe
  /// Parameters set by the header of a file that the program made. A header states all settings of the file's light,
  /// typed or not.
  std::vector<std::string> recorded{};
};

/// The program, with its commands and the parameters common to all. It cannot be moved, because parameters refer to it.
struct Program {
  std::deque<Verb> verbs;
  std::size_t threads = 0;
  bool help = false, help_all = false;
  request::Parameters of_all;

  Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;
};

/// Finds a command by its name; nullptr if there is none.
Verb* find_verb(Program& program, std::string_view name);

/// All parameters that a command accepts as flags: first its own, then those that all commands share.
std::vector<const request::Parameter*> flags_of(const Verb& verb);

/// Finds a command's parameter by a flag such as "output" or "-o"; nullptr if there is none.
request::Parameter* flag_of(Verb& verb, std::string_view flag);

request::Parameter& add_flag(Verb& verb, request::Parameter parameter);

void add_flags(Verb& verb, request::Parameters parameters);

template <class Request>
void add_described(Verb& verb, Request& request) {
  request::Parameters parameters;
  describe(parameters, request);
  add_flags(verb, std::move(parameters));
}

/// Adds flags for some members of `request`: those that the function `some`, such as uses::describe_map, describes.
template <class Request>
void add_described(Verb& verb, Request& request,
                   void (*some)(request::Parameters&, std::type_identity_t<Request>&)) {
  request::Parameters parameters;
  some(parameters, request);
  add_flags(verb, std::move(parameters));
}

/// Adds a parameter that sets a variable (request::parameter).
template <typename Value>
request::Parameter& add_flag(Verb& verb, const std::string& names, Value& value,
                             const std::string& help) {
  return add_flag(verb, request::parameter(names, value, help));
}

/// Adds a parameter whose text, such as "2s" or "42.86,-73.77", is parsed by a function.
///
/// Given  take  function that parses the text; throws algebra::Error for a text that it cannot parse
///        text  the default value as text; empty if there is no default
request::Parameter& add_parsed(Verb& verb, const std::string& names,
                               std::function<void(const std::string&)> take,
                               const std::string& help, const std::string& text = "");

/// Adds a parameter whose value is one of several words (request::choice).
template <typename Value, typename Field>
request::Parameter& add_choice(Verb& verb, const std::string& names, Field& value,
                               const request::Words<Value>& words, const std::string& help) {
  return add_flag(verb, request::choice(names, value, words, help));
}

/// Adds a flag without a value.
request::Parameter& add_switch(Verb& verb, const std::string& names, bool& value,
                               const std::string& help);

/// Adds a flag without a value, such as --json, that concerns only the present run and is not recorded in recipes.
request::Parameter& add_run_switch(Verb& verb, const std::string& names, bool& value,
                                   const std::string& help);

/// Adds --json. The documents that it may print are recorded, so that `coppermoon describe` can describe them.
request::Parameter& add_json_switch(Verb& verb, bool& value, Documents documents,
                                    const std::string& help = "prints one JSON document");

/// Adds a command, still without parameters, to the program.
Verb& add_verb(Program& program, const std::string& name, const std::string& help);

/// Adds --recipe to a command, and sets the function that runs the command once its parameters are set.
void on_run(Verb& verb, std::function<void()> run);

/// Reports on stderr which options have no effect in combination with the others. Options from a recipe are reported
/// only if they differ from their defaults, because a recipe may hold all options.
void say_what_has_no_effect(const Verb& verb);

/// Whether a parameter was set, by the command line or by a recipe.
bool is_given(const Verb& verb, std::string_view name);

/// Whether a parameter was set on the command line, not by a recipe.
bool is_typed(const Verb& verb, std::string_view name);

/// Recipe in TOML that records a command's parameters (request::recipe_of).
std::string recipe_of(const Verb& verb);

}  // namespace coppermoon::verbs
