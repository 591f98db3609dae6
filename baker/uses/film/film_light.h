// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>

#include "algebra/progress.h"
#include "uses/film/film.h"
#include "uses/light/shard.h"

namespace coppermoon::uses {

/// Name of the file in a film's folder that holds the film's light.
inline constexpr const char* light_file = "eclipse.light";

struct FilmLight {
  Moonlight light;
  bool kept = false;  ///< whether the light was read from the film's folder
};

/// The film's light, read from `eclipse.light` in its folder if complete, otherwise computed and written there. If
/// several processes need the light, one computes it and the others wait. Photons that shards have traced are used.
///
/// Given   film      complete except for its light and albedo; its folder must exist
///         replace   whether another film's light may be replaced
/// Throws  Error     as moon_on_its_way, read_light, write_light; if the file has other moments or another `light_key`
FilmLight film_light(const Film& film, bool replace = false,
                     const algebra::Progress& progress = {});

/// The light that `film_light` would read from the folder; nothing if `film_light` would have to compute it.
///
/// Throws  Error  as film_light
std::optional<Moonlight> kept_light(const Film& film, bool replace = false);

/// File in the film's folder for the sums over one shard of the film's photons, such as "eclipse.2-of-8.sums".
std::filesystem::path sums_file(const Film& film, const Shard& shard);

/// Traces one shard of a film's photons, and writes their sums to sums_file, which film_light will read.
///
/// Throws  Error  as film_light; when the film's request does not give the number of photons
void trace_shard(const Film& film, const Shard& shard, const algebra::Progress& progress = {});

}  // namespace coppermoon::uses
