// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <glm/vec3.hpp>

#include "almanac/ephemeris.h"
#include "almanac/instant.h"
#include "eclipse/shadow_axis.h"

namespace coppermoon::eclipse {

/// Number of the full Moon nearest in time to a moment. The full Moon of 21 January 2000 has the number 0.
int full_moon_number(const almanac::Instant& instant);

/// Whether the Moon may touch the penumbra at the full Moon with the given number. For this, its mean argument of
/// latitude must be within 21° of a node.
///
/// Source  Meeus (1998), Astronomical Algorithms, chapter 54
bool eclipse_is_possible(int number);

/// Moment at which the full Moon with the given number is nearest to the shadow axis, by moon98, accurate to a minute.
almanac::Instant nearest_to_axis(int number);

/// Fast ephemeris for the hours around a full Moon. The Sun follows a parabola through three samples. The Moon follows
/// moon98; for elp_2000_82b, a parabola through three samples of the two theories' difference is added.
struct Lunation {
  almanac::Instant middle;
  glm::dvec3 celestial_pole;
  std::array<glm::dvec3, 3> sun_m, added_to_moon98_m;  ///< samples at −3, 0 and 3 h from the middle
};

/// Accuracy  0.05″ in the positions of Sun and Moon, within 3 h of the middle
Lunation lunation_around(const almanac::Instant& middle, almanac::LunarTheory theory);

/// Position of the Moon in the shadow at one moment.
struct Sighting {
  ShadowAxis axis;
  ShadowPlace moon;
  glm::dvec3 moon_m;  ///< geocentric position of the Moon, GCRS axes
};

Sighting sighting_at(const Lunation& lunation, double seconds_after_middle);

/// Time at which the Moon's angle from the axis, seen from the Earth, is smallest [s after `lunation.middle`].
double least_axis_angle_s(const Lunation& lunation);

}  // namespace coppermoon::eclipse
