// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "almanac/observer.h"
#include "eclipse/contacts.h"
#include "povray_scenes/camera.h"

namespace coppermoon::uses {

/// A moment of a night, and the Moon then.
struct NightMoment {
  std::string name;  ///< "P1" … "greatest" … "P4", "moonrise", "moonset"
  almanac::Instant when;
  povray_scenes::HorizonPlace moon;  ///< its centre as it is seen, refraction counted
  bool up;                           ///< some of its disc is above the horizon
};

/// An eclipse as a place sees it.
struct Circumstances {
  eclipse::Eclipse eclipse;
  almanac::Observer place;
  std::vector<NightMoment> moments;  ///< in order of time
};

/// Contacts, and the Moonrise and Moonset of that night, which are up to 13 hours from the greatest phase.
///
/// The Moon rises and sets when above_horizon is 0; parallax is counted.
///
/// Accuracy  0.1 s of rise and set, of the Moon's place; weather changes refraction, and the time by a
///           minute or more
/// Throws    Error  as require_on_earth
Circumstances circumstances(const eclipse::Eclipse& eclipse, const almanac::Observer& place);

/// What is seen of the eclipse, in one sentence: "All of the eclipse is seen.", "The Moon rises 12 min
/// after U1; all of totality is seen.", "Nothing of the eclipse is seen: the Moon is below the horizon."
std::string what_is_seen(const Circumstances& night);

/// From which contact to which a place sees some of the Moon, which need not be up at any: "all", "none",
/// "U2 to P4", "between U1 and U2", "P1 to U1 and U4 to P4".
///
/// Throws  Error  as require_on_earth
std::string contacts_seen(const eclipse::Eclipse& eclipse, const almanac::Observer& place);

}  // namespace coppermoon::uses
