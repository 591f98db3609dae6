// SPDX-License-Identifier: MIT
#include "verbs/reports/film_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "algebra/error.h"
#include "almanac/calendar.h"
#include "verbs/flags/film_options.h"

namespace coppermoon::verbs {
namespace {

namespace fs = std::filesystem;
using request::Kind;

/// A text in double quotes, with escapes that are valid in both YAML and JSON.
std::string quoted(const std::string& text) { return nlohmann::json(text).dump(); }

/// A path relative to a folder; absent if the path is outside the folder.
std::optional<std::string> path_within(const fs::path& folder, const fs::path& path) {
  const auto found = (fs::current_path() / path).lexically_normal().lexically_relative(folder);
  if (found.empty() || *found.begin() == "..") return std::nullopt;
  return found.string();
}

/// Name of the job parameter for a flag, such as "ContactSheet" for "contact-sheet".
std::string parameter_name(const std::string& flag) {
  std::string name;
  bool begins = true;
  for (const char c : flag) {
    if (c != '-') name += begins ? static_cast<char>(std::toupper(c)) : c;
    begins = c == '-';
  }
  return name;
}

/// Definition of a job parameter for a path. A render farm may map paths to other locations, but a job template may
/// contain only paths within its own folder. Any other path is therefore defined as a string.
///
/// Given  kind  lines with the path's "objectType" and "dataFlow"
std::string path_parameter(const std::string& name, std::string_view kind, const fs::path& folder,
                           const std::string& path, const std::string& description) {
  const auto within = path_within(folder, path);
  return fmt::format("  - name: {}\n    type: {}    default: {}\n    description: {}\n", name,
                     within ? fmt::format("PATH\n{}", kind) : "STRING\n",
                     quoted(within.value_or(path)), quoted(description));
}

/// Flags for the commands in the job's tasks, and definitions of job parameters for the files that these flags name.
struct Flags {
  std::vector<std::string> of_shard, of_film;
  std::string parameters;
};

void add_file(Flags& flags, const request::Parameter& flag, const std::string& name,
              const fs::path& job_folder, const std::string& file) {
  const bool folder = flag.kind == Kind::folder_written, read = flag.kind == Kind::file_read;
  const auto kind = fmt::format("    objectType: {}\n    dataFlow: {}\n",
                                folder ? "DIRECTORY" : "FILE", read ? "IN" : "OUT");
  flags.parameters += path_parameter(name, kind, job_folder, file, "--" + flag.name);
  const auto word = fmt::format("--{}={{{{Param.{}}}}}", flag.name, name);
  flags.of_film.push_back(word);
  if (folder || read) flags.of_shard.push_back(word);
}

void add_word(Flags& flags, const request::Parameter& flag, const std::string& text) {
  if (text.find("{{") != std::string::npos)
    throw algebra::Error(
        fmt::format("{} = {}, allowed without {{{{ in a job's template", flag.name, text));
  const auto word = flag.kind == Kind::presence ? "--" + flag.name : "--" + flag.name + "=" + text;
  flags.of_film.push_back(word);
  flags.of_shard.push_back(word);
}

/// Whether the text given for a flag names a file or folder. The text may instead be a word such as "built-in".
bool names_file(const request::Parameter& flag, const std::string& text) {
  return is_written(flag.kind) || (flag.kind == Kind::file_read && fs::exists(text));
}

/// Value of --make for all tasks if the last task needs more products than the user's --make lists; else empty.
std::string added_products(const Verb& verb, const uses::Film& film) {
  const auto asked = make_text(products_of({.make = verb.parameters.find("make")->text()}));
  const auto all = make_text(film.products);
  return all == asked ? "" : all;
}

/// Collects the flags that were given, for use in the job's tasks.
///
/// Given  make  if not empty, replaces the value of --make
Flags given_flags(const Verb& verb, const fs::path& folder, const std::string& make) {
  constexpr std::array of_the_run{"job", "recipe", "shard"};
  Flags flags;
  for (const auto& flag : verb.parameters) {
    if (flag.name == "make" && !make.empty()) {
      add_word(flags, flag, make);
      continue;
    }
    if (!flag.given || std::ranges::find(of_the_run, flag.name) != of_the_run.end()) continue;
    std::size_t count = 0;
    for (const auto& text : *flag.given)
      if (!names_file(flag, text))
        add_word(flags, flag, text);
      else
        add_file(flags, flag,
                 parameter_name(flag.name) + (count++ > 0 ? fmt::format("{}", count) : ""), folder,
                 text);
  }
  return flags;
}

/// The command that a step runs. GNU's env starts it in the folder to which relative file names refer.
std::string action(const std::vector<std::string>& flags) {
  std::string text =
      "    script:\n      actions:\n        onRun:\n          command: env\n          args:\n";
  for (const auto* word : {"--chdir={{Param.Folder}}", "{{Param.Program}}", "animate"})
    text += fmt::format("            - {}\n", quoted(word));
  for (const auto& word : flags) text += fmt::format("            - {}\n", quoted(word));
  return text;
}

}  // namespace

std::string film_job(const Verb& verb, const uses::Film& film, const fs::path& job_file) {
  constexpr std::size_t usual_shards = 8;
  const auto folder = fs::absolute(job_file).lexically_normal().parent_path();
  if (!path_within(folder, ""))
    throw algebra::Error(fmt::format("{}: allowed in the current folder, or above it, for a job",
                                     job_file.string()));
  const auto frames = film.moments.frames.size();
  auto flags = given_flags(verb, folder, added_products(verb, film));
  flags.of_shard.emplace_back("--shard={{Task.Param.Shard}}/{{Param.Shards}}");
  const auto day = almanac::utc_text(film.moments.eclipse.greatest, film.moments.eclipse.calendar);
  return fmt::format(
             "specificationVersion: jobtemplate-2023-09\n"
             "name: coppermoon {}\n"
             "parameterDefinitions:\n"
             "  - name: Program\n    type: STRING\n    default: coppermoon\n"
             "    description: the program, of one version on all workers\n"
             "  - name: Shards\n    type: INT\n    minValue: 1\n    maxValue: {}\n"
             "    default: {}\n    description: tasks that share the frames\n",
             day.substr(0, day.find('T')), frames, std::min(frames, usual_shards)) +
         path_parameter("Folder", "    objectType: DIRECTORY\n    dataFlow: NONE\n", folder, "",
                        "folder that the program runs in") +
         flags.parameters +
         "steps:\n"
         "  - name: frames\n"
         "    parameterSpace:\n      taskParameterDefinitions:\n"
         "        - name: Shard\n          type: INT\n          range: \"1-{{Param.Shards}}\"\n" +
         action(flags.of_shard) + "  - name: film\n    dependencies:\n      - dependsOn: frames\n" +
         action(flags.of_film);
}

}  // namespace coppermoon::verbs
