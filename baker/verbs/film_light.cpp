// SPDX-License-Identifier: MIT
#include "verbs/film_light.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "algebra/error.h"
#include "verbs/film_account.h"
#include "verbs/light_file.h"
#include "verbs/lit_scene.h"

namespace coppermoon::verbs {
namespace {

constexpr const char* file_name = "eclipse.light";

/// Moments of the Moon's way, at most three minutes apart: it leaves a straight line by 0.1 km.
std::vector<almanac::SkyState> skies_between(const almanac::Instant& from,
                                             const almanac::Instant& to) {
  constexpr double apart_s = 180;
  const double seconds = almanac::seconds_between(from, to);
  const int intervals = std::max(1, static_cast<int>(std::ceil(seconds / apart_s)));
  std::vector<almanac::SkyState> skies;
  for (int i = 0; i <= intervals; ++i)
    skies.push_back(almanac::sky_at(almanac::later(from, seconds * i / intervals)));
  return skies;
}

/// With the photons that shards left in a folder.
LightOptions with_shards(LightOptions options, const std::filesystem::path& folder) {
  if (!wants_photons(options)) return options;
  options.solver = "photons";
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".sums")
      options.photon_files.add.push_back(entry.path().string());
  std::ranges::sort(options.photon_files.add);  // sums of the same order have the same bits
  return options;
}

}  // namespace

FilmLight film_light(const LightOptions& options, const almanac::Instant& from,
                     const almanac::Instant& to, const Purpose& purpose, const std::string& key,
                     const std::filesystem::path& folder, bool replace) {
  const auto moon = moon_on_its_way(options, skies_between(from, to));
  const auto whole_key = fmt::format("first-frame = {}\nlast-frame = {}\n{}",
                                     almanac::utc_text(from, 3), almanac::utc_text(to, 3), key);
  const FolderLock alone(folder);
  if (auto known = read_light(folder / file_name)) {
    if (known->key != whole_key && !replace)
      throw algebra::Error(fmt::format(
          "{}: holds the light of a film made with {} ({}), allowed another folder, or --replace",
          folder.string(), differences(known->key, whole_key), file_name));
    if (known->key == whole_key && complete(options, moon, known->light))
      return {std::move(known->light), true};
  }
  auto light = light_on_the_way(with_shards(options, folder), moon, purpose);
  write_light(folder / file_name, whole_key, light);
  return {std::move(light), false};
}

void trace_shard(const LightOptions& asked, const almanac::Instant& from,
                 const almanac::Instant& to, std::size_t part, std::size_t parts,
                 const std::filesystem::path& folder) {
  if (!wants_photons(asked) || !asked.photons)
    throw algebra::Error(fmt::format(
        "shard = {}/{} of the light, allowed where --photons says how many", part, parts));
  auto options = asked;
  options.solver = "photons";
  options.photon_files.shard = fmt::format("{}/{}", part, parts);
  options.photon_files.keep = folder / fmt::format("eclipse.{}-of-{}.sums", part, parts);
  light_on_the_way(options, moon_on_its_way(options, skies_between(from, to)), {});
}

}  // namespace coppermoon::verbs
