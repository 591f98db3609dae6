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
  atmosphere::Amounts amounts{};  ///< profile of each absorber, integrated along the path
};

/// Table of a column's profiles (except dust), sampled every 25 m. Interpolating in the table is ten times as fast as
/// evaluating the profiles.
///
/// Accuracy  1e-5, as a relative error in extinction
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
/// Both integrals run from the tangent radius r_t, where n r = b, to the top of the air; p is any absorber's profile.
/// The variable √(r − r_t) removes the singularity. Gauss–Legendre quadrature is used between the altitudes at which
/// the slopes of the profiles jump. n r − b is computed as h − h_t + (n − 1) r − (n_t − 1) r_t, which loses no digits.
///
/// Given     tangent_height_m  0 or more; above the top of the air the path is straight
///           earth_radius_m    radius of curvature of the ground along the path
///           refractivity      n₀ − 1, at sea level
///           table             profiles of the column; if nullptr, they are evaluated without a table
/// Accuracy  relative errors: 1e-8 for bending, air, dust and tropospheric aerosol; 5e-5 for ozone and 2e-4 (at most
///           1e-3) for stratospheric aerosol, because their profiles have kinks; 5e-5 for the optical depth. If the air
///           depends on the season (SeasonalAir), 2e-5 for bending (2e-4 above 25 km) and 2e-4 for the optical depth.
///           Errors are larger in the last micrometre below a break or the top of the air, because altitudes are
///           rounded. They reach 6 % in the last metre below 86 km, because US 1976 ends 5 cm below 86 km
/// Throws    Error  if the tangent height is below 0, or the air traps light (atmosphere::critical_refractivity)
/// Source    Auer & Standish (2000), AJ 119, 2472, for the integrals
LimbPath limb_path(double tangent_height_m, double earth_radius_m, const atmosphere::Column& column,
                   double refractivity, const ProfileTable* table = nullptr);

/// Paths of rays with the same tangent height at several refractivities. The results are those of limb_path, but the
/// air, which takes most of the time, is evaluated only once.
std::vector<LimbPath> limb_paths(double tangent_height_m, double earth_radius_m,
                                 const atmosphere::Column& column,
                                 std::span<const double> refractivities,
                                 const ProfileTable* table = nullptr);

/// Refraction and extinction of a ray past the limb, at one wavelength.
struct LimbRay {
  double tangent_height_m, bending_rad;
  double transmittance;  ///< exp(−optical depth), times transmittance of cloud and ozone filter
  double optical_depth;  ///< sum over all absorbers along the path
};

/// Ray past the limb with the given impact parameter, at one wavelength.
///
/// Given     impact_height_m  b − R: impact parameter minus radius of the ground
/// Returned  nothing if the ray meets the ground
/// Throws    Error  if the impact height is above the air's top or more than 10 km below the ground, or the air traps
///                  light
std::optional<LimbRay> limb_ray(double impact_height_m, double earth_radius_m,
                                const atmosphere::Column& column, const atmosphere::Optics& optics);

}  // namespace coppermoon::photons
