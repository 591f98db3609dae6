// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "uses/picture/moon.h"
#include "verbs/flags/flags.h"
#include "verbs/flags/light_options.h"
#include "verbs/flags/moments.h"

namespace coppermoon::verbs {

/// Values of the flags for the Moon, from which moon_request makes a request.
struct MoonOptions {
  MomentOptions moment;
  uses::MoonRequest request;
  LightOptions light;
};

/// Adds the flags for the Moon's map and ground. A map that seems to be rotated by 180 degrees is reported on stderr.
void add_map_options(Verb& verb, uses::MoonRequest& request);

/// Adds all flags for the Moon at one moment.
void add_moon_options(Verb& verb, MoonOptions& options);

/// Adds the flags for the Moon in a film. They do not include flags for a single moment or for sharing photons.
void add_film_moon_options(Verb& verb, MoonOptions& options);

/// Makes a request for the Moon and its light from the flags. A draft has half as many texels per pixel as usual.
///
/// Throws  Error  like light_request
uses::MoonRequest moon_request(const MoonOptions& options);

/// Sky at the moment that the options mean for this observer.
///
/// Throws  Error  if the text is not a moment; if no eclipse is under way, unless the Moon is requested unshadowed
almanac::SkyState eclipsed_sky(const MoonOptions& options,
                               const std::optional<almanac::Observer>& observer);

}  // namespace coppermoon::verbs
