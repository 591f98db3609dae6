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
  std::string name;  ///< "P1" … "greatest" … "P4", "moonrise", "moonset", "first seen", "last seen"
  almanac::Instant when;
  povray_scenes::HorizonPlace moon;  ///< apparent place of the Moon's centre, with refraction
  algebra::Angle sun_altitude;       ///< of the Sun's centre, airless
  bool up;                           ///< whether any of the Moon is above the horizon
  /// Where a contact happens on the Moon's limb, from celestial north through east.
  std::optional<algebra::Angle> position_angle = {};
};

using Span = std::pair<almanac::Instant, almanac::Instant>;

/// Whether a span contains a moment; its ends are included.
bool holds(const Span& span, const almanac::Instant& when);

/// Local circumstances of an eclipse.
struct Circumstances {
  eclipse::Eclipse eclipse;
  almanac::Observer place;
  std::vector<NightMoment> moments;  ///< in order of time
  /// Times between P1 and P4 when the Moon is above the horizon, and when it is seen.
  std::vector<Span> up = {}, seen = {};
};

/// Contacts of an eclipse, and moonrise and moonset within 13 hours of the greatest phase: zeros of above_horizon,
/// which includes parallax. The Moon counts as seen when it is up; as_seen (eclipse_light.h) applies the eye's limit.
///
/// Accuracy  0.1 s in rise and set, from the Moon's place; weather changes refraction, and so the times by a
///           minute or more; 0.3° in position angles, as the shadow's edge is not quite round
/// Throws    Error  as require_on_earth
Circumstances circumstances(const eclipse::Eclipse& eclipse, const almanac::Observer& place,
                            double hours = 13);

/// A moment of a night, with its Moon and Sun.
NightMoment moment_at(const almanac::Observer& place, std::string name,
                      const almanac::SkyState& sky);

/// Name of the sky's light by the Sun's altitude: "day" down to −0.83 degrees, "civil", "nautical" or "astronomical
/// twilight" down to −6, −12 and −18, then "night".
const char* twilight_name(algebra::Angle sun_altitude);

bool is_seen(const Circumstances& night, const almanac::Instant& when);

/// A sentence on how much of the eclipse is seen: "All of the eclipse is seen.", "The Moon rises 12 min
/// after U1; all of totality is seen.", "Nothing of the eclipse is seen: the Moon is below the horizon."
std::string what_is_seen(const Circumstances& night);

/// Contacts between which a place sees the Moon: "all", "none", "U2 to P4", "between U1 and U2", "P1 to U1 and
/// U4 to P4".
std::string contacts_seen(const Circumstances& night);

}  // namespace coppermoon::uses
