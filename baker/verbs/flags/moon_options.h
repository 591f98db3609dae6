// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "uses/picture/moon.h"
#include "verbs/flags/flags.h"
#include "verbs/flags/light_options.h"
#include "verbs/flags/moments.h"

namespace coppermoon::verbs {

/// Fields that the flags for a Moon fill in; `moon_request` turns them into a request.
struct MoonOptions {
  MomentOptions moment;
  uses::MoonRequest request;
  LightOptions light;
};

/// Adds the flags for the map and the ground. A map that seems to be turned by half a circle is reported on stderr.
void add_map_options(Verb& verb, uses::MoonRequest& request);

/// Adds all flags for the Moon at one moment.
void add_moon_options(Verb& verb, MoonOptions& options);

/// Adds the flags for the Moon in a film, which has neither a single moment nor files of photons.
void add_film_moon_options(Verb& verb, MoonOptions& options);

/// Request that the flags describe, including its light. A draft has half as many texels per pixel.
///
/// Throws  Error  as light_request
uses::MoonRequest moon_request(const MoonOptions& options);

/// Sky at the moment that the options give, as the observer means it. An eclipse is under way then, unless the Moon is
/// unshadowed.
///
/// Throws  Error  if the text is not a moment, or no eclipse is under way
almanac::SkyState eclipsed_sky(const MoonOptions& options,
                               const std::optional<almanac::Observer>& observer);

}  // namespace coppermoon::verbs
