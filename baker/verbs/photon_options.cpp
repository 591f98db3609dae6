// SPDX-License-Identifier: MIT
#include "verbs/photon_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "algebra/error.h"
#include "verbs/frame_range.h"
#include "verbs/photon_sums.h"
#include "verbs/recipe.h"

namespace coppermoon::verbs {
namespace {

/// Whether photons are others when this flag is.
bool changes_photons(const CLI::App& verb, const std::string& flag) {
  constexpr std::array<std::string_view, 6> ways{"seed",    "trace",   "rays",
                                                 "step-km", "ring-km", "precision"};
  constexpr std::array<std::string_view, 2> added_later{"scattered-light", "starlight"};
  if (std::find(added_later.begin(), added_later.end(), flag) != added_later.end()) return false;
  if (std::find(ways.begin(), ways.end(), flag) != ways.end()) return true;
  return heading_of(verb, "--" + flag) == "The Earth's air";
}

/// Of the recipe's flags those that count, and all of its tables of air.
std::string key_of(const CLI::App& verb) {
  return without(recipe_of(verb),
                 [&](const std::string& flag) { return !changes_photons(verb, flag); });
}

std::optional<shadow::PhotonSums> added(const std::vector<std::string>& paths) {
  std::optional<shadow::PhotonSums> all;
  for (const auto& path : paths) {
    auto sums = read_sums(path);
    try {
      all = all ? merged(std::move(*all), sums) : std::move(sums);
    } catch (const algebra::Error& error) {
      throw algebra::Error(fmt::format("{}: {}", path, error.what()));
    }
  }
  return all;
}

}  // namespace

void add_photon_options(CLI::App& verb, PhotonOptions& options) {
  const std::string group = "How light is computed";
  add_flag(verb, "--shard", options.shard, "K/N: traces the K-th of N parts of the photons")
      .in(group);
  add_flag(verb, "--keep", options.keep, "a file that the photons' sums are written to, JSON")
      .writes_file()
      .in(group);
  add_flag(verb, "--add", options.add,
           "a file that --keep wrote, of the same scene: its photons count and are not "
           "traced again; may be given again")
      .reads_file()
      .kept_each_time()
      .in(group);
  options.key = [&verb] { return key_of(verb); };
}

bool given(const PhotonOptions& options) {
  return !options.shard.empty() || !options.keep.empty() || !options.add.empty();
}

shadow::RefractedLight light_of_photons(const PhotonOptions& options,
                                        const atmosphere::Atmosphere& air,
                                        const shadow::Arrangement& arrangement,
                                        std::span<const double> wavelengths_nm,
                                        shadow::PhotonSettings settings,
                                        const algebra::Progress& progress) {
  if (options.key) settings.key = options.key();
  if (!options.shard.empty()) {
    const auto shard = shard_from(options.shard);
    settings.blocks = shadow::shard(shadow::blocks_of(settings.photons), shard.part, shard.parts);
  }
  const auto before = added(options.add);
  const auto sums = shadow::traced(air, arrangement, wavelengths_nm, settings,
                                   before ? &*before : nullptr, progress);
  if (!options.keep.empty()) write_sums(options.keep, sums);
  return shadow::estimated(sums);
}

}  // namespace coppermoon::verbs
