// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "almanac/instant.h"
#include "verbs/light_options.h"

namespace coppermoon::verbs {

/// The light of a whole film, and whether a run before this one had computed it.
struct FilmLight {
  Moonlight light;
  bool kept = false;
};

/// Reads it from a folder's `eclipse.light`, or else computes it and leaves it there; of several
/// processes one computes it, and the others wait.
///
/// Given   options   where they are photons, those that shards left in the folder are taken
///         from, to  the first and the last moment
///         key       of all else that it depends on, in lines as a recipe's
///         replace   whether another film's light may be replaced
/// Throws  Error     as moon_on_its_way, read_light, write_light; for another film's light
FilmLight film_light(const LightOptions& options, const almanac::Instant& from,
                     const almanac::Instant& to, const Purpose& purpose, const std::string& key,
                     const std::filesystem::path& folder, bool replace = false);

/// Traces one part of a film's photons, and leaves their sums in the folder, in a file named as
/// "eclipse.2-of-8.sums", for film_light to take.
///
/// Given   part, parts  1 to parts
/// Throws  Error        as film_light; when the light is not of a number of photons
void trace_shard(const LightOptions& options, const almanac::Instant& from,
                 const almanac::Instant& to, std::size_t part, std::size_t parts,
                 const std::filesystem::path& folder);

}  // namespace coppermoon::verbs
