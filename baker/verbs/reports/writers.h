// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "algebra/error.h"
#include "almanac/instant.h"
#include "files/whole_file.h"
#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// Kind of file that a command makes of a result.
template <class Result>
struct Writer {
  std::vector<std::string> endings;  ///< of the file's name: ".csv"
  std::string what;                  ///< what the file is, for help: "the moments"
  std::function<void(const Result&, const std::filesystem::path&)> write;
};

/// Kinds of files that a command makes, as its help lists them.
template <class Result>
using Writers = std::vector<Writer<Result>>;

/// ".ics for a calendar; .csv for the moments".
template <class Result>
std::string kinds_of(const Writers<Result>& writers) {
  std::vector<std::string> kinds;
  for (const auto& writer : writers)
    kinds.push_back(fmt::format("{} for {}", fmt::join(writer.endings, ", "), writer.what));
  return fmt::format("{}", fmt::join(kinds, "; "));
}

/// Adds -o: files of a result, whose endings choose their writers.
template <class Result>
void add_outputs(CLI::App& verb, std::vector<std::string>& names, const Writers<Result>& writers) {
  add_flag(verb, "-o,--output", names,
           fmt::format("file: {}. May be given again", kinds_of(writers)))
      .writes_file()
      .kept_each_time();
}

/// Throws  algebra::Error  when a file has no writer: names those that there are
template <class Result>
const Writer<Result>& writer_of(const std::filesystem::path& file, const Writers<Result>& writers) {
  const auto found = std::ranges::find_if(writers, [&](const Writer<Result>& writer) {
    return std::ranges::count(writer.endings, file.extension().string()) > 0;
  });
  if (found == writers.end())
    throw algebra::Error(fmt::format("{}: allowed {}", file.string(), kinds_of(writers)));
  return *found;
}

/// Refuses files that cannot be written, before the work for them.
///
/// Throws  algebra::Error  as writer_of and files::require_place_for
template <class Result>
void require_writers(const std::vector<std::string>& names, const Writers<Result>& writers) {
  for (const std::filesystem::path file : names) {
    writer_of(file, writers);
    files::require_place_for(file);
  }
}

template <class Result>
void write_files(const Result& result, const std::vector<std::string>& names,
                 const Writers<Result>& writers) {
  for (const std::filesystem::path file : names) writer_of(file, writers).write(result, file);
}

/// Whether one of the files has that ending.
bool has_ending(const std::vector<std::string>& names, std::string_view ending);

/// Prints the names of files below a table.
void print_names(const std::vector<std::string>& names);

/// The present moment.
almanac::Instant now();

}  // namespace coppermoon::verbs
