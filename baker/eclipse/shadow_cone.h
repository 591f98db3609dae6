// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <utility>

#include "algebra/quantity.h"
#include "eclipse/shadow_axis.h"

namespace coppermoon::eclipse {

/// Four published conventions for the enlargement of the shadow by the Earth's air.
///
///     danjon          1.01 πm + πs ∓ s
///     danjon_oblate   (1 + 1/85) πm r / a + πs ∓ s
///     chauvenet       1.02 (0.998340 πm + πs ∓ s)
///     herald_sinnott  (πm + πs) (r + 87 km) / a ∓ s
///
/// πm and πs are the equatorial horizontal parallaxes of the Moon and the Sun, and s is the Sun's semidiameter. The
/// upper sign is for the umbra, the lower for the penumbra. In danjon, the factor 1.01 is 1 + 1/85 − 1/594, which adds
/// 75 km of air to the Earth's mean radius; NASA has used danjon since 2009. In danjon_oblate, the same air is added to
/// the limb itself, as in NASA's timings of craters. Before 2009, NASA and the almanacs used chauvenet, whose umbral
/// magnitudes are larger by 0.005 and penumbral ones by 0.026. In the two oblate conventions, r is the radius of the
/// limb at the Moon's position angle (atmosphere::limb_at), and a is the Earth's equatorial radius.
///
/// Source  Espenak & Meeus (2009), Five Millennium Canon of Lunar Eclipses, NASA/TP-2009-214172;
///         Herald & Sinnott (2014), J. Brit. Astron. Assoc. 124, 247
enum class ShadowConvention { danjon, danjon_oblate, chauvenet, herald_sinnott };

/// Names of the conventions on the command line and in Python.
inline constexpr std::array<std::pair<const char*, ShadowConvention>, 4> convention_words{
    {{"danjon", ShadowConvention::danjon},
     {"danjon-oblate", ShadowConvention::danjon_oblate},
     {"chauvenet", ShadowConvention::chauvenet},
     {"herald-sinnott", ShadowConvention::herald_sinnott}}};

/// Radii of the shadow at the Moon's distance, as angles seen from the Earth's centre. Beyond the tip of the umbra, the
/// umbra's radius is negative.
struct ShadowRadii {
  algebra::Angle umbra, penumbra;
};

/// Given   moon  any place in the shadow; its position angle matters only in the oblate conventions
ShadowRadii shadow_radii(ShadowConvention convention, const ShadowAxis& axis,
                         const ShadowPlace& moon);

/// Converts an angle from the shadow axis into a distance from it, at the Moon's distance from the Earth's centre.
algebra::Length axis_distance_at(algebra::Angle from_axis, const ShadowPlace& moon);

/// Radius of the Moon in equatorial radii of the Earth, the same for every convention.
inline constexpr double lunar_radius_in_earth_radii = 0.2725076;

/// The Moon's semidiameter as seen from the Earth's centre.
algebra::Angle lunar_semidiameter(const ShadowPlace& moon);

}  // namespace coppermoon::eclipse
