// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "almanac/observer.h"
#include "povray_scenes/scene_camera.h"

namespace coppermoon::uses {

/// A place on the Earth: a city's name (almanac::city_named), or "LAT,LON" or "LAT,LON,ELEVATION" in degrees and
/// metres, such as "42.86,-73.77", "42.86N, 73.77W" or "42°51′36″N 73°46′12″W" (' and " may stand for ′ and ″).
///
/// Throws Error when the text names no place. The message names the regions that have a city of that name, or the
///              city with the most similar name
almanac::Observer observer_from(const std::string& text);

/// "LAT,LON" or "LAT,LON,ELEVATION" in degrees and metres, with enough digits to read back the same place.
std::string exact_text(const almanac::Observer& place);

/// A place on the Moon: a feature's name (almanac::lunar_feature_named), or "LAT,LON" in degrees.
///
/// Throws Error when the text names no such place; the message suggests the feature with the most similar name
almanac::SelenographicPoint feature_from(const std::string& text);

/// Reads "ALTITUDE,AZIMUTH" in degrees. Altitude counts from the horizon, azimuth from north through east.
///
/// Throws Error when the text is not of this form
povray_scenes::HorizonPlace aim_from(const std::string& text);

}  // namespace coppermoon::uses
