// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "almanac/observer.h"
#include "uses/picture/view.h"
#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// A place on Earth as written on the command line: a city's name (almanac::city_named), or "LAT,LON" or
/// "LAT,LON,ELEVATION" in degrees and metres, as "42.86,-73.77" or "42.86N,73.77W".
///
/// Where the name leaves a doubt, the program says on stderr which city it takes (almanac::city_taken).
///
/// Throws Error when the text is no such place: names the regions that have such a city, or the city whose
///              name is nearest
almanac::Observer observer_from(const std::string& text);

/// A place on the Moon: a feature's name (almanac::lunar_feature_named), or "LAT,LON" in degrees.
///
/// Throws Error when the text is no such place: names the feature whose name is nearest
almanac::SelenographicPoint feature_from(const std::string& text);

/// "ALTITUDE,AZIMUTH" in degrees, from the horizon up, and from north through east.
///
/// Throws Error when the text is no such place
povray_scenes::HorizonPlace aim_from(const std::string& text);

/// The observer and the air above.
void add_observer_options(CLI::App& verb, uses::ViewRequest& request);

/// The observer, the air above, and the frame: its field, its size, which way is up.
void add_view_options(CLI::App& verb, uses::ViewRequest& request);

}  // namespace coppermoon::verbs
