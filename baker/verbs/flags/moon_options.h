// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "uses/picture/moon.h"
#include "verbs/flags/flags.h"
#include "verbs/flags/light_options.h"
#include "verbs/flags/moments.h"

namespace coppermoon::verbs {

/// Fields that the flags of a Moon fill; `moon_request` makes a request of them.
struct MoonOptions {
  MomentOptions moment;
  uses::MoonRequest request;
  LightOptions light;
};

/// Adds the flags of the map and the ground; a map that seems to be turned by half a circle is said on stderr.
void add_map_options(Verb& verb, uses::MoonRequest& request);

/// Adds all flags of the Moon of one moment.
void add_moon_options(Verb& verb, MoonOptions& options);

/// Adds the flags of a film's Moon: without a moment, and without files of photons.
void add_film_moon_options(Verb& verb, MoonOptions& options);

/// Request that the flags make, with its light. A draft has half as many texels per pixel.
///
/// Throws  Error  as light_request
uses::MoonRequest moon_request(const MoonOptions& options);

/// Sky at the Moon's instant, as an observer means it; an eclipse is under way then, unless the Moon is unshadowed.
///
/// Throws  Error  when the text is no instant, or no eclipse is under way
almanac::SkyState eclipsed_sky(const MoonOptions& options,
                               const std::optional<almanac::Observer>& observer);

}  // namespace coppermoon::verbs
