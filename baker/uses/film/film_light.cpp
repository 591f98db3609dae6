// SPDX-License-Identifier: MIT
#include "uses/film/film_light.h"

#include <fmt/format.h>

#include <algorithm>

#include "algebra/error.h"
#include "files/lock.h"
#include "files/own_file.h"
#include "uses/light/light_file.h"
#include "uses/light/light_parameters.h"

namespace coppermoon::uses {
namespace {

/// The Moon in the Earth's shadow, along its path during the film.
ShadowedMoon moon_of(const Film& film, const LightRequest& request) {
  const auto& frames = film.moments.frames;
  return moon_on_its_way(request, skies_between(frames.front(), frames.back()));
}

request::Recipe key_of(const Film& film) {
  const auto& frames = film.moments.frames;
  const auto moment = [](const char* name, const almanac::Instant& when) {
    return request::Setting{.name = name, .texts = {almanac::utc_text(when, 3)}, .bare = true};
  };
  return with({moment("first-frame", frames.front()), moment("last-frame", frames.back())},
              film.record.light_key());
}

Purpose purpose_of(const Film& film) {
  const auto width = static_cast<double>(texture_width_of(film.moon));
  return {width * width / 2, reads_map(film.moon)};
}

/// Adds a folder's .sums files to a request. Each of them holds the summed light of one shard of the film's photons.
LightRequest with_shards(LightRequest request, const std::filesystem::path& folder) {
  if (!wants_photons(request)) return request;
  if (request.solver == Solver::automatic) request.solver = Solver::table;
  auto& sums = request.photon_files.add;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".sums") sums.push_back(entry.path());
  std::ranges::sort(sums);  // because the sum's last bits depend on the order
  return request;
}

/// Differences between the settings stored with known light and the requested ones. Empty if `asked` equals the stored
/// settings, either as they were requested or with those that the program's planner chose.
std::vector<request::Difference> differences_of(const KeptLight& known,
                                                const request::Recipe& asked) {
  const auto there = light_key_in(known.key);
  if (request::differences(with_work(there, known.light.plan.work), asked).empty()) return {};
  return request::differences(there, asked);
}

/// Reads eclipse.light in the film's folder, if complete. Another film's file is refused, or ignored with `replace`.
std::optional<Moonlight> kept_on_the_way(const Film& film, const ShadowedMoon& moon, bool replace) {
  auto known = read_light(film.folder / light_file);
  if (!known) return std::nullopt;
  const auto others = differences_of(*known, key_of(film));
  const bool same = others.empty();
  if (!same && !replace)
    throw algebra::Error(
        fmt::format("{}: holds the light of a film made with {} ({}), allowed another folder{}",
                    film.folder.string(), in_words(others), light_file, film.record.way_out));
  if (!same || !complete(moon, known->light)) return std::nullopt;
  return std::move(known->light);
}

}  // namespace

FilmLight film_light(const Film& film, bool replace, const algebra::Progress& progress) {
  const auto moon = moon_of(film, film.moon.light);
  const auto alone = files::lock_folder(film.folder);
  if (auto kept = kept_on_the_way(film, moon, replace)) return {std::move(*kept), true};
  auto light =
      light_on_the_way(with_shards(film.moon.light, film.folder), moon, purpose_of(film), progress);
  write_light(film.folder / light_file, text_of(key_of(film)), light);
  return {std::move(light), false};
}

std::optional<Moonlight> kept_light(const Film& film, bool replace) {
  return kept_on_the_way(film, moon_of(film, film.moon.light), replace);
}

std::filesystem::path sums_file(const Film& film, const Shard& shard) {
  return film.folder / fmt::format("eclipse.{}-of-{}.sums", shard.part, shard.parts);
}

void trace_shard(const Film& film, const Shard& shard, const algebra::Progress& progress) {
  auto request = film.moon.light;
  if (!wants_photons(request) || !request.photons)
    throw algebra::Error(
        fmt::format("shard = {}/{} of the light, allowed where a number of photons is given",
                    shard.part, shard.parts));
  if (request.solver == Solver::automatic) request.solver = Solver::table;
  request.photon_files.shard = shard;
  request.photon_files.keep = sums_file(film, shard);
  files::require_no_link(request.photon_files.keep);
  light_on_the_way(request, moon_of(film, request), {}, progress);
}

}  // namespace coppermoon::uses
