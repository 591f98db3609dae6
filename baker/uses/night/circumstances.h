// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "almanac/observer.h"
#include "eclipse/contacts.h"
#include "povray_scenes/camera.h"

namespace coppermoon::uses {

/// Contact, moonrise or moonset, and the sky then.
struct NightMoment {
  std::string name;  ///< "P1" … "greatest" … "P4", "moonrise", "moonset", "first seen", "last seen"
  almanac::Instant when;
  povray_scenes::HorizonPlace moon;  ///< apparent place of its centre, with refraction
  algebra::Angle sun_altitude;       ///< of its centre, airless
  bool up;                           ///< whether some of the Moon is above the horizon
  /// Of a contact, at the Moon's limb, from celestial north through east.
  std::optional<algebra::Angle> position_angle = {};
};

using Span = std::pair<almanac::Instant, almanac::Instant>;

/// Whether a moment is in a span, its ends included.
bool holds(const Span& span, const almanac::Instant& when);

/// Local circumstances of an eclipse.
struct Circumstances {
  eclipse::Eclipse eclipse;
  almanac::Observer place;
  std::vector<NightMoment> moments;  ///< in order of time
  /// Times between P1 and P4 in which the Moon is above the horizon, and in which it is seen.
  std::vector<Span> up = {}, seen = {};
};

/// Contacts of an eclipse, and moonrise and moonset within 13 hours of the greatest phase: zeros of above_horizon,
/// which has parallax. A Moon that is up is taken as seen: see (eclipse_light.h) asks the eye.
///
/// Accuracy  0.1 s of rise and set, by the Moon's place; weather changes refraction, and so the time by a
///           minute or more; position angles 0.3° of the shadow's edge, which is not quite round
/// Throws    Error  as require_on_earth
Circumstances circumstances(const eclipse::Eclipse& eclipse, const almanac::Observer& place,
                            double hours = 13);

/// Moment of a night.
NightMoment moment_at(const almanac::Observer& place, std::string name,
                      const almanac::SkyState& sky);

/// Light of the sky by the Sun's altitude: "day" to −0.83 degrees, "civil", "nautical" or "astronomical twilight" to −6,
/// −12 and −18, "night".
const char* twilight_name(algebra::Angle sun_altitude);

bool is_seen(const Circumstances& night, const almanac::Instant& when);

/// Sentence about how much of the eclipse is seen: "All of the eclipse is seen.", "The Moon rises 12 min
/// after U1; all of totality is seen.", "Nothing of the eclipse is seen: the Moon is below the horizon."
std::string what_is_seen(const Circumstances& night);

/// Contacts between which a place sees the Moon: "all", "none", "U2 to P4", "between U1 and U2", "P1 to U1 and
/// U4 to P4".
std::string contacts_seen(const Circumstances& night);

}  // namespace coppermoon::uses
