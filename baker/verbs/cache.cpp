// SPDX-License-Identifier: MIT
#include "verbs/cache.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <memory>

#include "algebra/error.h"
#include "algebra/number.h"
#include "files/cache_folder.h"
#include "files/environment.h"
#include "result/as_json.h"
#include "texture/read_image.h"
#include "verbs/command_line.h"
#include "verbs/reports/one_line.h"

namespace coppermoon::verbs {
namespace of_cache {
namespace {

using files::KeptFile;

struct Options {
  std::string folder;
  std::optional<double> limit_gb;
  bool list = false, clean = false, json = false, csv = false;
};

std::string in_megabytes(double bytes) { return fmt::format("{:.1f} MB", bytes / 1e6); }

double days_since(std::filesystem::file_time_type then) {
  const auto past = std::filesystem::file_time_type::clock::now() - then;
  return std::chrono::duration<double, std::ratio<86400>>(past).count();
}

/// The moment that a texture shows, in UTC, from DateTime in its header; empty if DateTime cannot be read.
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

/// A texture that is in the cache or was just removed from it.
struct Texture {
  KeptFile file;
  bool stays = true;
};

template <class Field>
void describe(Field&& is, const Texture& texture) {
  const auto if_it_stays = [&](auto value) {
    return [&texture, value] {
      return algebra::if_any(texture.stays ? std::optional(value(texture.file)) : std::nullopt);
    };
  };
  is.a("Texture", "A texture that is kept, or was removed.");
  is("file", texture.file.path.string(), "its path");
  is("bytes", texture.file.bytes, algebra::unit::bytes, "its size");
  is("days_since_use", if_it_stays([](const KeptFile& file) { return days_since(file.used); }),
     algebra::unit::days, "time since its last use");
  is("instant", if_it_stays([](const KeptFile& file) { return moment_of(file); }),
     "its moment, UTC; empty where its header has none");
}

/// The cache folder, with the textures that it holds or, after a removal, with those that were removed.
struct Folder {
  std::string path;
  std::vector<Texture> textures;
  std::optional<double> limit_bytes;  ///< largest allowed size of the cache; absent after a removal

  double bytes() const {
    double sum = 0;
    for (const auto& texture : textures) sum += static_cast<double>(texture.file.bytes);
    return sum;
  }
};

template <class Field>
void describe(Field&& is, const Folder& folder) {
  const auto some = [&](bool stay) {
    return algebra::if_any(stay == folder.limit_bytes.has_value() ? std::optional(folder.textures)
                                                                  : std::nullopt);
  };
  is.a("Folder", "Textures that are kept, or were removed.");
  is("folder", folder.path, "the folder");
  is("bytes", algebra::if_any(folder.limit_bytes ? std::optional(folder.bytes()) : std::nullopt),
     algebra::unit::bytes, "size of all textures");
  is("limit_bytes", algebra::if_any(folder.limit_bytes), algebra::unit::bytes, "size allowed");
  is("textures", some(true), "the textures, those used last first");
  is("removed", some(false), "the textures removed, with --clean");
}

Folder folder_of(const std::filesystem::path& path, const std::vector<KeptFile>& files,
                 std::optional<double> limit_bytes) {
  Folder folder{path.string(), {}, limit_bytes};
  for (const auto& file : files) folder.textures.push_back({file, limit_bytes.has_value()});
  return folder;
}

void print_list(const Folder& folder) {
  for (const auto& [file, stays] : folder.textures)
    fmt::print("{}  {:>10}  {:5.1f} days  {}\n", file.path.filename().string(),
               in_megabytes(static_cast<double>(file.bytes)), days_since(file.used),
               moment_of(file));
  fmt::print("{}: {} textures, {}; limit {:g} GB\n", one_line(folder.path), folder.textures.size(),
             in_megabytes(folder.bytes()), *folder.limit_bytes / 1e9);
}

void print_removed(const Folder& folder) {
  fmt::print("{}: {} textures removed, {}; {} textures stay\n", one_line(folder.path),
             folder.textures.size(), in_megabytes(folder.bytes()),
             files::kept_in(folder.path).size());
}

void run(const Options& options) {
  if (options.limit_gb) algebra::require_within("limit [GB]", *options.limit_gb, 0, 1e6);
  if (options.limit_gb && !options.clean)
    throw WrongUsage(
        "--limit: allowed with --clean; the variable COPPERMOON_CACHE_LIMIT limits "
        "the usual cache");
  const std::filesystem::path folder =
      options.folder.empty() ? files::usual_cache() : std::filesystem::path(options.folder);
  const double limit_bytes = options.limit_gb.value_or(cache_limit_gb()) * 1e9;
  const auto found = options.clean
                         ? folder_of(folder,
                                     files::remove_oldest(folder, limit_bytes,
                                                          std::filesystem::file_time_type::max()),
                                     {})
                         : folder_of(folder, files::kept_in(folder), limit_bytes);
  if (options.json)
    fmt::print("{}\n", result::as_json(found).dump(2));
  else if (options.csv)
    fmt::print("{}", result::as_csv(found.textures));
  else
    options.clean ? print_removed(found) : print_list(found);
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
  add_json_switch(verb, options->json, {result::fields_of<Folder>});
  add_run_switch(verb, "--csv", options->csv, "prints the textures as CSV").not_beside({{"json"}});
  verb.run = [options] { run(*options); };
}

}  // namespace coppermoon::verbs
