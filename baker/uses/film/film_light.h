// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>

#include "algebra/progress.h"
#include "uses/film/film.h"
#include "uses/light/shard.h"

namespace coppermoon::uses {

/// Name of the light's file in a film's folder.
inline constexpr const char* light_file = "eclipse.light";

/// Light of a whole film.
struct FilmLight {
  Moonlight light;
  bool kept = false;  ///< read from the folder
};

/// Light of a film, read from `eclipse.light` in its folder, or computed and written there. One of several processes
/// computes; the others wait. Photons are added from the shards in the folder.
///
/// Given   film      all but its light and albedo; its folder is there
///         replace   another film's light may be replaced
/// Throws  Error     as moon_on_its_way, read_light, write_light; for light of other moments or of another `light_key`
FilmLight film_light(const Film& film, bool replace = false,
                     const algebra::Progress& progress = {});

/// Light that `film_light` would keep; none where it would compute.
///
/// Throws  Error  as film_light
std::optional<Moonlight> kept_light(const Film& film, bool replace = false);

/// File in the film's folder for the sums of one part of its photons: "eclipse.2-of-8.sums".
std::filesystem::path sums_file(const Film& film, const Shard& shard);

/// Traces one part of a film's photons, and writes their sums into its folder (sums_file) for film_light to add.
///
/// Throws  Error  as film_light; when no number of photons is given
void trace_shard(const Film& film, const Shard& shard, const algebra::Progress& progress = {});

}  // namespace coppermoon::uses
