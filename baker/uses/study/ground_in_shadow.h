// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>

#include "almanac/sky.h"
#include "eclipse/shadow_axis.h"

namespace coppermoon::uses {

/// Place of the Moon's ground in the Earth's shadow.
///
/// Given  ground  unit vector, Moon-fixed axes
eclipse::ShadowPlace place_of_ground(const eclipse::ShadowAxis& axis, const almanac::SkyState& sky,
                                     const glm::dvec3& ground);

}  // namespace coppermoon::uses
