// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <utility>
#include <vector>

#include "request/parameter.h"
#include "result/fields.h"

namespace coppermoon::verbs {

/// Command with its parameters. CLI11 takes seconds to compile: few files include this.
struct Verb : CLI::App {
  Verb() = default;
  Verb(CLI::App& program, std::string name, std::string help)
      : CLI::App(std::move(help), std::move(name), &program) {}

  request::Parameters parameters;
  std::vector<result::Fields> documents;  ///< that --json prints: one of these
  std::vector<std::string> typed;         ///< names of the flags on the command line itself
};

}  // namespace coppermoon::verbs
