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

/// Error for a command line or a recipe that cannot be understood: exit status 2.
struct WrongUsage : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Program;

/// Documents that --json may print. Each is a function, because their fields are seldom needed.
using Documents = std::vector<result::Fields (*)()>;

/// A command and its parameters.
struct Verb {
  std::string name{}, help{};
  request::Parameters parameters{};
  std::function<void()> run{};  ///< runs it once its parameters are set
  Program* program = nullptr;   ///< its program; nullptr if it only reads a file's recipe
  Documents documents{};
  std::vector<std::string> typed{};  ///< names of parameters given on the command line itself
};

/// The program: its commands, and the parameters common to all of them. Must not move, as parameters refer to it.
struct Program {
  std::deque<Verb> verbs;
  std::size_t threads = 0;
  bool help = false, help_all = false;
  request::Parameters of_all;

  Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;
};

/// Command with this name; nullptr if there is none.
Verb* find_verb(Program& program, std::string_view name);

/// All parameters that a command accepts as flags: its own, then those common to all commands.
std::vector<const request::Parameter*> flags_of(const Verb& verb);

/// Parameter for a flag such as "output" or "-o"; nullptr if there is none.
request::Parameter* flag_of(Verb& verb, std::string_view flag);

/// Adds a parameter.
request::Parameter& add_flag(Verb& verb, request::Parameter parameter);

/// Adds several parameters.
void add_flags(Verb& verb, request::Parameters parameters);

template <class Request>
void add_described(Verb& verb, Request& request) {
  request::Parameters parameters;
  describe(parameters, request);
  add_flags(verb, std::move(parameters));
}

/// Adds the parameters that a function such as uses::describe_map describes for a request.
template <class Request>
void add_described(Verb& verb, Request& request,
                   void (*some)(request::Parameters&, std::type_identity_t<Request>&)) {
  request::Parameters parameters;
  some(parameters, request);
  add_flags(verb, std::move(parameters));
}

/// Adds a parameter bound to a value (request::parameter).
template <typename Value>
request::Parameter& add_flag(Verb& verb, const std::string& names, Value& value,
                             const std::string& help) {
  return add_flag(verb, request::parameter(names, value, help));
}

/// Adds a parameter whose text is read by a function, such as "2s" or "42.86,-73.77".
///
/// Given  take  reads the text; throws algebra::Error if it cannot
///        text  the default as text, if there is one
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

/// Adds a flag without a value that concerns only this run, such as --json, and stays out of recipes.
request::Parameter& add_run_switch(Verb& verb, const std::string& names, bool& value,
                                   const std::string& help);

/// Adds --json, and records which documents it prints, for `coppermoon describe`.
request::Parameter& add_json_switch(Verb& verb, bool& value, Documents documents,
                                    const std::string& help = "prints one JSON document");

/// Returned  the new command, without parameters
Verb& add_verb(Program& program, const std::string& name, const std::string& help);

/// Adds --recipe, and sets what a command does once its parameters have their values.
void on_run(Verb& verb, std::function<void()> run);

/// Says on stderr which options have no effect beside the others. From a recipe, which may hold all values, only those
/// that differ from their defaults are reported.
void say_what_has_no_effect(const Verb& verb);

/// Whether the command line or a recipe gives a parameter.
bool is_given(const Verb& verb, std::string_view name);

/// Whether the command line itself gives a parameter.
bool is_typed(const Verb& verb, std::string_view name);

/// Recipe for a command's parameters, in TOML (request::recipe_of).
std::string recipe_of(const Verb& verb);

}  // namespace coppermoon::verbs
