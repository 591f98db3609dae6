// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "uses/picture/moon.h"
#include "verbs/flags/flags.h"
#include "verbs/flags/light_options.h"
#include "verbs/flags/moments.h"

namespace coppermoon::verbs {

/// What flags say of a Moon; `moon_request` is what they mean.
struct MoonOptions {
  MomentOptions moment;
  uses::MoonRequest request;
  LightOptions light;
};

/// Flags of the map and the ground; says on stderr when a map seems to be turned by half a circle.
void add_map_options(CLI::App& verb, uses::MoonRequest& request);

/// All of a Moon of one moment: the instant, the map, the texture's width, its light, and whether it is
/// unshadowed.
void add_moon_options(CLI::App& verb, MoonOptions& options);

/// All of a Moon whose moments are told otherwise, a film's: without photons' files.
void add_film_moon_options(CLI::App& verb, MoonOptions& options);

/// The request that flags make, with its light. A draft has half as many texels for each pixel.
///
/// Throws  Error  as light_request
uses::MoonRequest moon_request(const MoonOptions& options);

/// The sky of the Moon's instant, at which an eclipse is under way unless the Moon is unshadowed.
///
/// Throws  Error  when the text is no instant, or no eclipse is under way
almanac::SkyState eclipsed_sky(const MoonOptions& options);

}  // namespace coppermoon::verbs
