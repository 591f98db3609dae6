// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "atmosphere/atmosphere.h"

namespace coppermoon::photons {

/// Path of a ray past the limb, and the amounts of absorbers along it.
struct LimbPath {
  double tangent_height_m;        ///< lowest altitude of the bent ray
  double impact_height_m;         ///< b − R: impact parameter minus radius of the ground
  double bending_rad;             ///< total refraction, towards the Earth
  atmosphere::Amounts amounts{};  ///< each profile integrated along the path
};

/// Table of a column's profiles (except dust) every 25 m, interpolated linearly: ten times as fast as the profiles.
///
/// Accuracy  relative error of extinction 1e-5
class ProfileTable {
 public:
  explicit ProfileTable(const atmosphere::Column& column);

  atmosphere::Amounts operator()(double altitude_m) const;

 private:
  atmosphere::Column column_;
  std::vector<atmosphere::Amounts> rows_;
};

/// Path of a ray through spherically symmetric air, by quadrature.
///
///     δ = −2 b ∫ (dn/dr) / (n √(n²r² − b²)) dr          a = 2 ∫ p(h) n r / √(n²r² − b²) dr
///
/// from the tangent radius r_t, where n r = b, to the top, with p any profile. The variable √(r − r_t) removes the
/// singularity. Gauss–Legendre quadrature is used between the altitudes where the slope of the profiles jumps.
/// Refractivity and altitude replace n and r, since n r − b = h − h_t + (n − 1) r − (n_t − 1) r_t loses no digits.
///
/// Given     tangent_height_m      0 or more; above the top of the air the path is straight
///           earth_radius_m        radius of curvature of the ground along the path
///           refractivity          n₀ − 1, at sea level
///           table                 for the column; if null, the profiles themselves are evaluated
/// Accuracy  relative, 1e-8 for bending, air, dust and tropospheric aerosol; 5e-5 for ozone, 2e-4 (extreme
///           1e-3) for stratospheric aerosol, whose profiles have knees; 5e-5 for the optical depth of undated
///           air. In a month's air 2e-5 for bending (above 25 km 2e-4), 2e-4 for the optical depth. Worse in the last
///           micrometre under a break or the top of the air, due to rounding of altitudes; 6 % in the last metre under
///           86 km, as US 1976 ends 5 cm lower
/// Throws    Error  when the tangent height is below 0, or the air traps light
///                  (atmosphere::critical_refractivity)
/// Source    Auer & Standish (2000), AJ 119, 2472, for the integrals
LimbPath limb_path(double tangent_height_m, double earth_radius_m, const atmosphere::Column& column,
                   double refractivity, const ProfileTable* table = nullptr);

/// Paths of rays with the same tangent height at several refractivities. Same result as limb_path for each, but the
/// air, which takes most of the time, is evaluated only once.
std::vector<LimbPath> limb_paths(double tangent_height_m, double earth_radius_m,
                                 const atmosphere::Column& column,
                                 std::span<const double> refractivities,
                                 const ProfileTable* table = nullptr);

/// Refraction and extinction of a ray of one wavelength past the limb.
struct LimbRay {
  double tangent_height_m, bending_rad;
  double transmittance;  ///< due to optical depth, cloud cover, and ozone as a filter
  double optical_depth;  ///< of all absorbers along the path
};

/// Ray of one wavelength past the limb, with the given impact parameter.
///
/// Given     impact_height_m  b − R: impact parameter minus radius of the ground
/// Returned  nothing if the ray meets the ground
/// Throws    Error  when the impact height is above the air's top or more than 10 km below the ground, or
///                  the air traps light
std::optional<LimbRay> limb_ray(double impact_height_m, double earth_radius_m,
                                const atmosphere::Column& column, const atmosphere::Optics& optics);

}  // namespace coppermoon::photons
