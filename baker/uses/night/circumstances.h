// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "almanac/observer.h"
#include "eclipse/contacts.h"
#include "povray_scenes/scene_camera.h"

namespace coppermoon::uses {

/// A contact, moonrise or moonset, and the sky at that moment.
struct NightMoment {
  std::string name;  ///< such as "P1", "greatest", "moonrise", "moonset" or "first seen"
  almanac::Instant when;
  povray_scenes::HorizonPlace moon;  ///< apparent place of the Moon's centre, with refraction
  algebra::Angle sun_altitude;       ///< of the Sun's centre, without refraction
  bool up;                           ///< whether any part of the Moon is above the horizon
  /// Position angle on the Moon's limb at which a contact happens, from celestial north through east.
  std::optional<algebra::Angle> position_angle = {};
};

using Span = std::pair<almanac::Instant, almanac::Instant>;

/// Whether a moment lies within a span or at one of its ends.
bool holds(const Span& span, const almanac::Instant& when);

struct Circumstances {
  eclipse::Eclipse eclipse;
  almanac::Observer place;
  std::vector<NightMoment> moments;  ///< in order of time
  /// Spans between P1 and P4 in which the Moon is above the horizon (`up`), and in which it is seen (`seen`).
  std::vector<Span> up = {}, seen = {};
};

/// Contacts of an eclipse, and moonrises and moonsets within `hours` of greatest eclipse. The Moon rises and sets
/// when above_horizon, which includes parallax, is zero. Here the Moon counts as seen whenever it is up. The function
/// as_seen (eclipse_light.h) also requires that the Moon stands out from the sky.
///
/// Accuracy  Rising and setting: 0.1 s from the Moon's position, plus a minute or more because refraction depends on
///           the weather. Position angles: 0.3°, because the shadow's edge is not quite round
/// Throws    Error  if require_on_earth does
Circumstances circumstances(const eclipse::Eclipse& eclipse, const almanac::Observer& place,
                            double hours = 13);

/// Makes a NightMoment, with the positions of the Moon and the Sun as seen from a place.
NightMoment moment_at(const almanac::Observer& place, std::string name,
                      const almanac::SkyState& sky);

/// Name for the time of day by the Sun's altitude: "day" down to −0.83 degrees, "civil twilight" down to −6, "nautical
/// twilight" down to −12, "astronomical twilight" down to −18, then "night".
const char* twilight_name(algebra::Angle sun_altitude);

bool is_seen(const Circumstances& night, const almanac::Instant& when);

/// A sentence that says how much of the eclipse is seen, such as "All of the eclipse is seen.", "The Moon rises 12 min
/// after U1; all of totality is seen." or "Nothing of the eclipse is seen: the Moon is below the horizon."
std::string what_is_seen(const Circumstances& night);

/// Text that says between which contacts the Moon is seen, such as "all", "none", "U2 to P4", "between U1 and U2", or
/// "P1 to U1 and U4 to P4".
std::string contacts_seen(const Circumstances& night);

}  // namespace coppermoon::uses
