// SPDX-License-Identifier: MIT
#include "uses/study/ground_in_shadow.h"

#include <glm/matrix.hpp>

namespace coppermoon::uses {

eclipse::ShadowPlace place_of_ground(const eclipse::ShadowAxis& axis, const almanac::SkyState& sky,
                                     const glm::dvec3& ground) {
  return eclipse::place_in_shadow(
      axis, sky.moon_m + glm::transpose(sky.selenographic_from_gcrs) *
                             (algebra::in_metres(almanac::lunar_radius) * ground));
}

}  // namespace coppermoon::uses
