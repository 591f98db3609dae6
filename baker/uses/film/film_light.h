// SPDX-License-Identifier: MIT
#pragma once

#include "algebra/progress.h"
#include "uses/film/film.h"
#include "uses/light/shard.h"

namespace coppermoon::uses {

/// The name of a film's light in its folder.
inline constexpr const char* light_file = "eclipse.light";

/// The light of a whole film, and whether a run before this one had computed it.
struct FilmLight {
  Moonlight light;
  bool kept = false;
};

/// Reads a film's light from `eclipse.light` in its folder, or else computes it and leaves it there; of
/// several processes one computes it, and the others wait. Where it is photons, those that shards left
/// in the folder are taken.
///
/// Given   film      all but its light and albedo; its folder is there
///         replace   another film's light may be replaced
///         progress  told how far the computation has come
/// Throws  Error     as moon_on_its_way, read_light, write_light; for another film's light, which is
///                   one with another first or last moment, or another `light_key`
FilmLight film_light(const Film& film, bool replace = false,
                     const algebra::Progress& progress = {});

/// Traces one part of a film's photons, and leaves their sums in its folder, in a file named as
/// "eclipse.2-of-8.sums", for film_light to take.
///
/// Throws  Error  as film_light; when the light is not of a number of photons
void trace_shard(const Film& film, const Shard& shard, const algebra::Progress& progress = {});

}  // namespace coppermoon::uses
