// SPDX-License-Identifier: MIT
#include "verbs/cache.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>
#include <numeric>

#include "algebra/error.h"
#include "algebra/number.h"
#include "files/cache_folder.h"
#include "files/environment.h"
#include "texture/read_image.h"
#include "verbs/command_line.h"
#include "verbs/reports/one_line.h"

namespace coppermoon::verbs {
namespace of_cache {
namespace {

using Json = nlohmann::ordered_json;
using files::KeptFile;

struct Options {
  std::string folder;
  std::optional<double> limit_gb;
  bool list = false, clean = false, json = false;
};

double bytes_of(const std::vector<KeptFile>& files) {
  return std::accumulate(files.begin(), files.end(), 0., [](double sum, const KeptFile& file) {
    return sum + static_cast<double>(file.bytes);
  });
}

std::string in_megabytes(double bytes) { return fmt::format("{:.1f} MB", bytes / 1e6); }

double days_since(std::filesystem::file_time_type then) {
  const auto past = std::filesystem::file_time_type::clock::now() - then;
  return std::chrono::duration<double, std::ratio<86400>>(past).count();
}

/// Moment of a texture in UTC, by its header's DateTime ("2018:07:27 19:40:17"); empty where it cannot be read.
std::string moment_of(const KeptFile& file) {
  try {
    auto text = texture::read_attribute(file.path, "DateTime").value_or("");
    if (text.size() != 19) return "";
    text[4] = text[7] = '-';
    text[10] = 'T';
    return text + "Z";
  } catch (const algebra::Error&) {
    return "";
  }
}

Json as_json(const std::vector<KeptFile>& files) {
  auto all = Json::array();
  for (const auto& file : files)
    all.push_back({{"file", file.path.string()},
                   {"bytes", file.bytes},
                   {"days_since_use", days_since(file.used)},
                   {"instant", moment_of(file)}});
  return all;
}

void print(const std::vector<KeptFile>& files) {
  for (const auto& file : files)
    fmt::print("{}  {:>10}  {:5.1f} days  {}\n", file.path.filename().string(),
               in_megabytes(static_cast<double>(file.bytes)), days_since(file.used),
               moment_of(file));
}

void list(const std::filesystem::path& folder, const Options& options) {
  const auto files = files::kept_in(folder);
  if (options.json) {
    fmt::print("{}\n", Json{{"folder", folder.string()},
                            {"bytes", bytes_of(files)},
                            {"limit_bytes", cache_limit_gb() * 1e9},
                            {"textures", as_json(files)}}
                           .dump(2));
    return;
  }
  print(files);
  fmt::print("{}: {} textures, {}; limit {:g} GB\n", one_line(folder.string()), files.size(),
             in_megabytes(bytes_of(files)), cache_limit_gb());
}

void clean(const std::filesystem::path& folder, const Options& options) {
  const auto removed =
      files::remove_oldest(folder, options.limit_gb.value_or(cache_limit_gb()) * 1e9,
                           std::filesystem::file_time_type::max());
  if (options.json) {
    auto files = Json::array();
    for (const auto& file : removed)
      files.push_back({{"file", file.path.string()}, {"bytes", file.bytes}});
    fmt::print("{}\n", Json{{"folder", folder.string()}, {"removed", files}}.dump(2));
    return;
  }
  fmt::print("{}: {} textures removed, {}; {} textures stay\n", one_line(folder.string()),
             removed.size(), in_megabytes(bytes_of(removed)), files::kept_in(folder).size());
}

void run(const Options& options) {
  if (options.limit_gb) algebra::require_within("limit [GB]", *options.limit_gb, 0, 1e6);
  if (options.limit_gb && !options.clean)
    throw WrongUsage(
        "--limit: allowed with --clean; the variable COPPERMOON_CACHE_LIMIT limits "
        "the usual cache");
  const std::filesystem::path folder =
      options.folder.empty() ? files::usual_cache() : std::filesystem::path(options.folder);
  options.clean ? clean(folder, options) : list(folder, options);
}

}  // namespace
}  // namespace of_cache

double cache_limit_gb() {
  const auto text = files::variable("COPPERMOON_CACHE_LIMIT");
  if (text.empty()) return 20;
  const auto number = algebra::number_in(text);
  if (!number || !(*number >= 0))
    throw algebra::Error(fmt::format(
        "COPPERMOON_CACHE_LIMIT [GB] = {}, allowed a number of 0 or more", one_line(text)));
  return *number;
}

std::filesystem::file_time_type a_day_ago() {
  return std::filesystem::file_time_type::clock::now() - std::chrono::hours(24);
}

void add_cache(Program& program) {
  using namespace of_cache;
  auto& verb = add_verb(program, "cache",
                        "lists or removes the textures that programs and Blender have kept");
  const auto options = std::make_shared<Options>();
  add_run_switch(verb, "--list", options->list,
                 "lists the textures, those used last first: size, days since the last use, "
                 "moment (default)");
  add_run_switch(verb, "--clean", options->clean,
                 "removes textures, those used longest ago first, down to the limit")
      .excludes("list");
  add_flag(verb, "--limit", options->limit_gb,
           "size that --clean leaves [GB], 0 to 1000000; default: the variable "
           "COPPERMOON_CACHE_LIMIT, or 20")
      .within(0, 1e6);
  add_flag(verb, "--folder", options->folder,
           "folder of kept textures; default: the variable COPPERMOON_CACHE, or coppermoon in the "
           "user's folder of caches")
      .writes_folder();
  add_run_switch(verb, "--json", options->json, "prints one JSON document");
  verb.run = [options] { run(*options); };
}

}  // namespace coppermoon::verbs
