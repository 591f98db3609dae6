// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>

#include "algebra/progress.h"
#include "uses/film/film.h"
#include "uses/light/shard.h"

namespace coppermoon::uses {

/// Name of the file, in a film's folder, with the light in the Earth's shadow that all frames of the film share.
inline constexpr const char* light_file = "eclipse.light";

struct FilmLight {
  Moonlight light;
  bool kept = false;  ///< whether the light was read from the film's folder
};

/// Light in the Earth's shadow, read from `eclipse.light` in the film's folder if complete, otherwise computed and
/// written there. Only one process computes the light; others wait for it. Photons that shards have traced are used.
///
/// Given   film      `light`, `albedo` and `ground` may be empty; the folder must exist
///         replace   whether a file of another film may be replaced
/// Throws  Error     as moon_on_its_way, read_light, write_light; if the file is another film's and `replace` is false
FilmLight film_light(const Film& film, bool replace = false,
                     const algebra::Progress& progress = {});

/// The light that `film_light` would read from the folder; nothing if `film_light` would have to compute it.
///
/// Throws  Error  as film_light
std::optional<Moonlight> kept_light(const Film& film, bool replace = false);

/// File in the film's folder for the summed light of one shard of its photons, such as "eclipse.2-of-8.sums".
std::filesystem::path sums_file(const Film& film, const Shard& shard);

/// Traces one shard of a film's photons, and writes the sums of their light to sums_file, for film_light to read.
///
/// Throws  Error  as film_light; when the film's request does not give the number of photons
void trace_shard(const Film& film, const Shard& shard, const algebra::Progress& progress = {});

}  // namespace coppermoon::uses
