// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "almanac/instant.h"
#include "files/endings.h"
#include "files/whole_file.h"
#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// Format of a file that a command makes of a result.
template <class Result>
struct Writer : files::Ending {
  std::function<void(const Result&, const std::filesystem::path&)> write;
};

/// Formats of a command's files, as its help lists them.
template <class Result>
using Writers = std::vector<Writer<Result>>;

/// Adds -o: files of a result, whose endings choose their writers.
template <class Result>
void add_outputs(Verb& verb, std::vector<std::string>& names, const Writers<Result>& writers) {
  add_flag(verb, "-o,--output", names,
           fmt::format("file: {}; may be given again", files::in_words(writers)))
      .writes_file(writers);
}

/// Refuses files that cannot be written, before the work for them.
///
/// Given   what  they hold, as "a night"
/// Throws  algebra::Error  as files::format_of and files::require_place_for
template <class Result>
void require_writers(const std::vector<std::string>& names, const Writers<Result>& writers,
                     std::string_view what) {
  for (const std::filesystem::path file : names) {
    files::format_of(file, writers, what);
    files::require_place_for(file);
  }
}

/// Throws  algebra::Error  as the writers
template <class Result>
void write_files(const Result& result, const std::vector<std::string>& names,
                 const Writers<Result>& writers) {
  for (const std::filesystem::path file : names)
    files::format_of(file, writers, "a file").write(result, file);
}

/// Whether one of the files has that ending.
bool has_ending(const std::vector<std::string>& names, std::string_view ending);

/// Prints the names of files below a table.
void print_names(const std::vector<std::string>& names);

/// The present moment.
almanac::Instant now();

}  // namespace coppermoon::verbs
