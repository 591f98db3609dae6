// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>

#include "algebra/progress.h"
#include "uses/film/film.h"
#include "uses/light/shard.h"

namespace coppermoon::uses {

/// Name of the file in a film's folder that holds its light.
inline constexpr const char* light_file = "eclipse.light";

/// Light of a whole film.
struct FilmLight {
  Moonlight light;
  bool kept = false;  ///< read from the folder
};

/// Light of a film, read from `eclipse.light` in its folder, or computed and written there. If several processes need
/// it, one computes and the others wait. Photons are added from the shards in the folder.
///
/// Given   film      complete but for its light and albedo; its folder must exist
///         replace   another film's light may be replaced
/// Throws  Error     as moon_on_its_way, read_light, write_light; for light of other moments or another `light_key`
FilmLight film_light(const Film& film, bool replace = false,
                     const algebra::Progress& progress = {});

/// The light that `film_light` would keep; nothing if it would compute.
///
/// Throws  Error  as film_light
std::optional<Moonlight> kept_light(const Film& film, bool replace = false);

/// File in the film's folder for the sums over one part of its photons: "eclipse.2-of-8.sums".
std::filesystem::path sums_file(const Film& film, const Shard& shard);

/// Traces one part of a film's photons, and writes their sums into its folder (sums_file) for film_light to add.
///
/// Throws  Error  as film_light; when the number of photons is not given
void trace_shard(const Film& film, const Shard& shard, const algebra::Progress& progress = {});

}  // namespace coppermoon::uses
