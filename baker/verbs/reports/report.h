// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "almanac/instant.h"
#include "plan/plan.h"
#include "result/as_json.h"

namespace coppermoon::verbs {

/// Converts a recipe from TOML to a JSON object.
nlohmann::ordered_json as_json(const std::string& recipe);

/// Describes the files that a command made: a single file under the key `file`, several under the key `files`.
template <class Field>
void describe_files(Field&& is, const std::vector<std::string>& files) {
  const bool one = files.size() == 1;
  is("file", algebra::if_any(one ? std::optional(files.front()) : std::nullopt),
     "the file that was made");
  is("files", algebra::if_any(one ? std::nullopt : std::optional(files)),
     "the files, where there are several");
}

/// What a command reports about the files that it made.
struct Report {
  std::vector<std::string> files;
  std::string recipe;
  double seconds = 0, relative_error = 0;
  plan::Plan plan{};
};

template <class Field>
void describe(Field&& is, const Report& made) {
  is.a("Report", "Files that were made, and how.");
  describe_files(is, made.files);
  is(
      "chosen", [&] { return as_json(made.recipe); },
      "recipe that makes the same again, as an object");
  describe(is, made.plan);
  is("reached", plan::Cost{made.seconds, made.relative_error}, "what was reached");
}

/// A file that was made for one moment, with some numbers that describe what it shows.
template <class Figures>
struct MadeOf {
  std::string file;
  almanac::Instant instant;
  Figures figures;
};

template <class Field, class Figures>
void describe(Field&& is, const MadeOf<Figures>& made) {
  is.a("Made", "A file of a moment, with its figures.");
  is("file", made.file, "the file that was made");
  is("instant", made.instant, "the moment, UTC");
  describe(is, made.figures);
}

/// Time that has passed since `start` [s].
double seconds_since(std::chrono::steady_clock::time_point start);

/// Prints a report on stdout, either as one line or as a JSON document.
void report(const Report& made, bool json);

}  // namespace coppermoon::verbs
