// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "algebra/quantity.h"

namespace coppermoon::atmosphere {

/// The air over one part of the limb: what stands in it. Every term can be switched off.
struct Column {
  bool refraction = true;            ///< off: light goes straight through the air
  bool rayleigh = true;              ///< off: molecules do not scatter
  double ozone_du = 0;               ///< vertical column [DU], as one filter; 0: off
  double dust_extinction_per_m = 0;  ///< grey extinction α of the layer, 0 to 0.01 m⁻¹; 0: off
  double dust_bottom_m = 15e3, dust_top_m = 20e3;
};

/// A part of the limb with air of its own: from one position angle through east to the other.
/// The position angle is measured at the Earth, about the shadow axis, from celestial north through
/// east.
struct Region {
  algebra::Angle from, to;
  Column column{};
};

/// The Earth and its air: a sphere with a shell, alike all around but for its regions (the first
/// that holds a position angle counts).
struct Atmosphere {
  double earth_radius_m = 6.378e6;
  double top_m = 42e3;  ///< where the air ends; 0: no air at all
  Column column{};
  std::vector<Region> regions{};

  bool symmetric() const { return regions.empty(); }
  double top_radius_m() const { return earth_radius_m + top_m; }
  const Column& column_at(double position_angle_rad) const;
};

/// Throws Error when a term is outside its range: names it, its unit and what is allowed.
void require_valid(const Atmosphere& atmosphere);

/// What does not depend on altitude: the air at sea level, for one wavelength.
struct Optics {
  double refractivity;    ///< n₀ − 1
  double rayleigh_per_m;  ///< β₀ = N₀ σ
  double wavelength_nm;
};

/// Throws Error when the wavelength is outside 380 to 780 nm
Optics sea_level_optics(algebra::Wavelength wavelength);

/// n(h, λ) − 1: the sea-level refractivity times the density ratio (Gladstone–Dale).
double refractivity(const Column& column, const Optics& optics, double altitude_m);

/// Extinction α + β(h, λ) [m⁻¹] at an altitude: dust and Rayleigh scattering.
double extinction_per_m(const Column& column, const Optics& optics, double altitude_m);

/// What ozone leaves of light that passed the limb.
double ozone_transmittance(const Column& column, const Optics& optics);

/// Rayleigh optical depth of the whole air above sea level, straight up.
double vertical_rayleigh_optical_depth(const Optics& optics);

}  // namespace coppermoon::atmosphere
