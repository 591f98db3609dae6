// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "atmosphere/atmosphere.h"

namespace coppermoon::photons {

/// The path of a ray that passes the limb, and what stands along it.
struct LimbPath {
  double tangent_height_m;        ///< lowest altitude of the bent ray
  double impact_height_m;         ///< b − R, the impact parameter above the ground's
  double bending_rad;             ///< total refraction, towards the Earth
  atmosphere::Amounts amounts{};  ///< each profile summed along the path
};

/// The profiles of a column every 25 m, dust apart: straight lines between them take a tenth of the time.
///
/// Accuracy  1e-5 of the extinction, relative
class ProfileTable {
 public:
  explicit ProfileTable(const atmosphere::Column& column);

  atmosphere::Amounts operator()(double altitude_m) const;

 private:
  atmosphere::Column column_;
  std::vector<atmosphere::Amounts> rows_;
};

/// The exact path of a ray through a column of air that is alike all around.
///
///     δ = −2 b ∫ (dn/dr) / (n √(n²r² − b²)) dr          a = 2 ∫ p(h) n r / √(n²r² − b²) dr
///
/// from the tangent radius r_t, where n r = b, to the top; p any profile. In the variable
/// √(r − r_t), which has no singularity, by Gauss–Legendre between the altitudes where the air's
/// slope breaks. Refractivity and altitude are carried, not n and r: n r − b = h − h_t + (n − 1) r −
/// (n_t − 1) r_t loses no digits.
///
/// Given     tangent_height_m      0 or more; above the top of the air the path is straight
///           earth_radius_m        of the ground's curvature along the path
///           refractivity          n₀ − 1, at sea level
///           table                 of the column; without: its profiles themselves
/// Accuracy  1e-8 relative, of bending, air, dust and the troposphere's aerosol; where profiles have
///           knees, of ozone 5e-5, of the stratosphere's aerosol 2e-4 up to high, 1e-3 extreme; of
///           all optical depth in standard air 5e-5. In the last micrometre under a break or the top
///           of the air, what the rounding of altitudes leaves; in the last metre under 86 km, where
///           US 1976 ends 5 cm lower, 6 % of what is left
/// Throws    Error  when the tangent height is below 0, or the air would not let light out again
///                  (atmosphere::critical_refractivity)
/// Source    Auer & Standish (2000), AJ 119, 2472, for the integrals
LimbPath limb_path(double tangent_height_m, double earth_radius_m, const atmosphere::Column& column,
                   double refractivity, const ProfileTable* table = nullptr);

/// Refraction and extinction of a ray of one wavelength that passes the limb.
struct LimbRay {
  double tangent_height_m, bending_rad;
  double transmittance;  ///< of all that stands along the path, of cloud, of ozone as a filter
  double optical_depth;  ///< of all that stands along the path
};

/// Ray of one wavelength past the limb, by its impact parameter.
///
/// Given     impact_height_m  b − R, the impact parameter above the Earth's radius
/// Returned  nothing when the ray meets the ground
/// Throws    Error  when the impact height is above the air's top or over 10 km below the ground, or
///                  the air would not let light out again
std::optional<LimbRay> limb_ray(double impact_height_m, double earth_radius_m,
                                const atmosphere::Column& column, const atmosphere::Optics& optics);

}  // namespace coppermoon::photons
