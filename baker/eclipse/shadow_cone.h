// SPDX-License-Identifier: MIT
#pragma once

#include "algebra/quantity.h"
#include "eclipse/shadow_axis.h"

namespace coppermoon::eclipse {

/// How much larger than the solid Earth's the umbra is said to be: three published conventions.
///
///     danjon          1.01 πm + πs ∓ s
///     chauvenet       1.02 (0.998340 πm + πs ∓ s)
///     herald_sinnott  (πm + πs) (r + 87 km) / a ∓ s
///
/// πm and πs are the equatorial horizontal parallaxes of Moon and Sun, s the Sun's semidiameter;
/// upper sign umbra, lower penumbra. danjon's 1.01 is 1 + 1/85 − 1/594: 75 km of air on the Earth's
/// mean radius; NASA's since 2009. chauvenet was the almanacs' and NASA's before; its umbral
/// magnitude is 0.005 larger, its penumbral one 0.026. herald_sinnott alone is oblate: r is the
/// limb's radius under the Moon, a the Earth's equatorial one.
///
/// Source  Espenak & Meeus (2009), Five Millennium Canon of Lunar Eclipses, NASA/TP-2009-214172;
///         Herald & Sinnott (2014), J. Brit. Astron. Assoc. 124, 247
enum class ShadowConvention { danjon, chauvenet, herald_sinnott };

/// Radii of the shadow where the Moon is, as angles seen from the Earth's centre. At the distance D
/// from there an angle ρ is D sin ρ from the axis. The umbra's is negative beyond its tip.
struct ShadowRadii {
  algebra::Angle umbra, penumbra;
};

/// Given   moon  a place in the shadow; its position angle matters to herald_sinnott alone
ShadowRadii shadow_radii(ShadowConvention convention, const ShadowAxis& axis,
                         const ShadowPlace& moon);

/// Equatorial radius and flattening of the Earth; radius of the Moon in Earth radii. Every
/// convention uses the same.
inline constexpr double earth_radius_m = 6378137.0, earth_flattening = 1 / 298.257;
inline constexpr double lunar_radius_in_earth_radii = 0.2725076;

/// The Moon's semidiameter seen from the Earth's centre.
algebra::Angle lunar_semidiameter(const ShadowPlace& moon);

/// Radius of the Earth's limb as the Sun sees it, at the position angle about the shadow axis.
///
///     1/r² = (sin θ / a)² + (cos θ / b')²        b'² = a² (1 − e² cos² δ), δ the Sun's declination
algebra::Length limb_radius(algebra::Angle position_angle, algebra::Angle sun_declination);

}  // namespace coppermoon::eclipse
