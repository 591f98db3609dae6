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

/// A command line, or a recipe, that cannot be understood: exit status 2.
struct WrongUsage : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Program;

/// Command with its parameters.
struct Verb {
  std::string name{}, help{};
  request::Parameters parameters{};
  std::function<void()> run{};        ///< what it does once its parameters have their values
  Program* program = nullptr;         ///< whose command it is; null: none's, to read the recipe of a file
  std::vector<result::Fields> documents{};  ///< that --json prints: one of these
  std::vector<std::string> typed{};   ///< names of parameters that the command line itself gives
};

/// The program: its commands, and the parameters of all of them. Parameters keep its address.
struct Program {
  std::deque<Verb> verbs;
  std::size_t threads = 0;
  bool help = false, help_all = false;
  request::Parameters of_all;

  Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;
};

/// Command of that name; null: none.
Verb* find_verb(Program& program, std::string_view name);

/// All parameters that are flags of a command: its own, then those of all commands.
std::vector<const request::Parameter*> flags_of(const Verb& verb);

/// Parameter of a flag, as "output" or "-o"; null: none.
request::Parameter* flag_of(Verb& verb, std::string_view flag);

/// Adds a parameter.
request::Parameter& add_flag(Verb& verb, request::Parameter parameter);

/// Adds parameters that a request describes.
void add_flags(Verb& verb, request::Parameters parameters);

template <class Request>
void add_described(Verb& verb, Request& request) {
  request::Parameters parameters;
  describe(parameters, request);
  add_flags(verb, std::move(parameters));
}

/// Adds the parameters that one of a request's functions describes, as uses::describe_map.
template <class Request>
void add_described(Verb& verb, Request& request,
                   void (*some)(request::Parameters&, std::type_identity_t<Request>&)) {
  request::Parameters parameters;
  some(parameters, request);
  add_flags(verb, std::move(parameters));
}

/// Adds a parameter with a value, as request::parameter has it.
template <typename Value>
request::Parameter& add_flag(Verb& verb, const std::string& names, Value& value,
                             const std::string& help) {
  return add_flag(verb, request::parameter(names, value, help));
}

/// Adds a parameter whose value is read by a function, as "2s" or "42.86,-73.77".
///
/// Given  take  reads the text; throws algebra::Error when it cannot
///        text  of the default, where it has one
request::Parameter& add_parsed(Verb& verb, const std::string& names,
                               std::function<void(const std::string&)> take,
                               const std::string& help, const std::string& text = "");

/// Adds a parameter whose value is one of some words, as request::choice has it.
template <typename Value, typename Field>
request::Parameter& add_choice(Verb& verb, const std::string& names, Field& value,
                               const request::Words<Value>& words, const std::string& help) {
  return add_flag(verb, request::choice(names, value, words, help));
}

/// Adds a flag without a value.
request::Parameter& add_switch(Verb& verb, const std::string& names, bool& value,
                               const std::string& help);

/// Adds a flag without a value that says how this run goes, as --json: no recipe holds it.
request::Parameter& add_run_switch(Verb& verb, const std::string& names, bool& value,
                                   const std::string& help);

/// Adds --json, and says which documents it prints (`coppermoon describe`).
void add_json_switch(Verb& verb, bool& value, std::vector<result::Fields> documents);

/// Returned  the new command, without parameters
Verb& add_verb(Program& program, const std::string& name, const std::string& help);

/// Adds --recipe, and what a command does once its parameters have their values.
void on_run(Verb& verb, std::function<void()> run);

/// Says on stderr which options have no effect beside the others. Of a recipe, which may hold all values, those that
/// differ from the usual ones are.
void say_what_has_no_effect(const Verb& verb);

/// Whether the command line, or a recipe, gives that parameter.
bool is_given(const Verb& verb, std::string_view name);

/// Whether the command line itself gives that parameter.
bool is_typed(const Verb& verb, std::string_view name);

/// Recipe of a command's parameters, in TOML (request::recipe_of).
std::string recipe_of(const Verb& verb);

}  // namespace coppermoon::verbs
