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
#include "result/as_json.h"
#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// A file format in which a command can write its result.
template <class Result>
struct Writer : files::Ending {
  std::function<void(const Result&, const std::filesystem::path&)> write;
};

/// All file formats in which a command can write its result, in the order in which help lists them.
template <class Result>
using Writers = std::vector<Writer<Result>>;

/// Makes a writer from a function that converts the result to text, such as a table.
template <class Result>
Writer<Result> writer_of(files::Ending ending, std::string (*text)(const Result&)) {
  return {ending, [text](const Result& result, const std::filesystem::path& file) {
            files::write_whole(file, text(result));
          }};
}

/// Makes a writer from a function that converts the result to a JSON document.
template <class Result>
Writer<Result> writer_of(files::Ending ending, result::Json (*document)(const Result&)) {
  return {ending, [document](const Result& result, const std::filesystem::path& file) {
            files::write_whole(file, document(result).dump(2) + "\n");
          }};
}

/// Prints a JSON document on stdout, after adding the names of the files that were written.
void print_json(result::Json document, const std::vector<std::string>& files = {});

/// Adds --output, which names files for the result. The ending of a name determines the format.
template <class Result>
void add_outputs(Verb& verb, std::vector<std::string>& names, const Writers<Result>& writers) {
  add_flag(verb, "-o,--output", names,
           fmt::format("file: {}; may be given again", files::in_words(writers)))
      .writes_file(writers);
}

/// Checks that the named files can be written. Call this before the result is computed.
///
/// Given   what  what the files hold, such as "a night", for error messages
/// Throws  algebra::Error  like files::format_of and files::require_place_for
template <class Result>
void require_writers(const std::vector<std::string>& names, const Writers<Result>& writers,
                     std::string_view what) {
  for (const std::filesystem::path file : names) {
    files::format_of(file, writers, what);
    files::require_place_for(file);
  }
}

/// Writes a result to each of the named files, in the format that its ending determines.
///
/// Throws  algebra::Error  like the writers
template <class Result>
void write_files(const Result& result, const std::vector<std::string>& names,
                 const Writers<Result>& writers) {
  for (const std::filesystem::path file : names)
    files::format_of(file, writers, "a file").write(result, file);
}

bool has_ending(const std::vector<std::string>& names, std::string_view ending);

/// Prints the names of files that were written, below the table that the command prints.
void print_names(const std::vector<std::string>& names);

almanac::Instant now();

}  // namespace coppermoon::verbs
