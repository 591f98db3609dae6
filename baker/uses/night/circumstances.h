// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "almanac/observer.h"
#include "eclipse/contacts.h"
#include "povray_scenes/camera.h"

namespace coppermoon::uses {

/// Contact, moonrise or moonset, and the Moon then.
struct NightMoment {
  std::string name;  ///< "P1" … "greatest" … "P4", "moonrise", "moonset"
  almanac::Instant when;
  povray_scenes::HorizonPlace moon;  ///< apparent place of its centre, with refraction
  bool up;                           ///< whether some of its disc is above the horizon
};

/// Local circumstances of an eclipse.
struct Circumstances {
  eclipse::Eclipse eclipse;
  almanac::Observer place;
  std::vector<NightMoment> moments;  ///< in order of time
};

/// Contacts of an eclipse, and moonrise and moonset within 13 hours of the greatest phase: zeros of above_horizon,
/// which has parallax.
///
/// Accuracy  0.1 s of rise and set, by the Moon's place; weather changes refraction, and so the time by a
///           minute or more
/// Throws    Error  as require_on_earth
Circumstances circumstances(const eclipse::Eclipse& eclipse, const almanac::Observer& place);

/// Sentence about how much of the eclipse is seen: "All of the eclipse is seen.", "The Moon rises 12 min
/// after U1; all of totality is seen.", "Nothing of the eclipse is seen: the Moon is below the horizon."
std::string what_is_seen(const Circumstances& night);

/// Contacts between which a place sees some of the Moon: "all", "none", "U2 to P4", "between U1 and U2", "P1 to U1 and
/// U4 to P4".
///
/// Throws  Error  as require_on_earth
std::string contacts_seen(const eclipse::Eclipse& eclipse, const almanac::Observer& place);

}  // namespace coppermoon::uses
