// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "algebra/grid.h"
#include "atmosphere/atmosphere.h"
#include "photons/limb_darkening.h"
#include "shadow/sectors.h"

namespace coppermoon::shadow {

/// Distances of the Sun and of the shadow planes from the Earth's centre, along the shadow axis.
struct Arrangement {
  double sun_distance_m;         ///< 0.3 to 3 au
  std::vector<double> depths_m;  ///< planes' distances behind the Earth, increasing, 1e8 to 1e9 m
  bool limb_darkening = false;   ///< whether the Sun darkens towards its limb, or is uniform
};

/// Throws Error if a distance is outside its range.
void require_valid(const Arrangement& arrangement);

/// Light refracted by the Earth's air, as a ratio to unshaded sunlight at the same distance from the Sun, for each
/// place in the shadow and each wavelength.
struct RefractedLight {
  Arrangement arrangement;
  std::vector<double> wavelengths_nm;
  std::vector<double> axis_distances_m;  ///< in increasing order
  /// number of equal sectors of position angle about the axis; 1 if light is symmetric about the axis
  std::size_t sectors = 1;
  /// [plane × sectors + sector](axis distance, wavelength); sector s is centred at the position angle 2π s / sectors.
  /// For the mean over sectors, use mean_ratio
  std::vector<algebra::Grid<double>> ratio;
  std::vector<algebra::Grid<double>>
      standard_error;         ///< indexed like ratio; empty if the light has no noise
  std::uint64_t photons = 0;  ///< number of photons traced
  /// whether the errors at a place are correlated between wavelengths, because these share the same photons
  bool errors_correlated = false;
};

/// Light that is 0 on every plane and in every sector, without noise.
RefractedLight darkness(const Arrangement& arrangement, std::span<const double> wavelengths_nm,
                        std::span<const double> axis_distances_m, std::size_t sectors);

/// Mean of the ratio over all position angles on one plane.
///
/// Given     light  must be known in all sectors (QuadratureSettings::sectors may leave some dark)
/// Returned  (axis distance, wavelength)
algebra::Grid<double> mean_ratio(const RefractedLight& light, std::size_t plane = 0);

/// Standard error of a weighted sum over wavelengths, from the standard error at each wavelength. If the errors are
/// correlated, it is an upper bound.
double combined_error(const RefractedLight& light, std::span<const double> errors,
                      std::span<const double> weights);

/// Optical properties of air at sea level, at each wavelength.
std::vector<atmosphere::Optics> optics_of(const atmosphere::Atmosphere& atmosphere,
                                          std::span<const double> wavelengths_nm);

/// Radius of the projected solar disc: the Sun's image that a pinhole at the limb casts on a plane [m].
double projected_solar_radius_m(const Arrangement& arrangement, double depth_m);

/// Signed distance from the axis at which a ray from the Sun's centre lands after passing the limb.
///
///     r = b / cos ε + z tan ε       ε = asin(b/D) − δ
///
/// Given  impact_parameter_m  b
///        bending_rad         δ
///        sun_distance_m      D
///        depth_m             z
double landing_m(double impact_parameter_m, double bending_rad, double sun_distance_m,
                 double depth_m);

/// Largest axis distance that refracted light reaches on a plane [m].
double refracted_reach_m(const Arrangement& arrangement, const atmosphere::Atmosphere& atmosphere,
                         double depth_m);

/// Area of the overlap of two circles with radii r and s, whose centres are the distance `apart` from each other.
double lens_area(double apart, double r, double s);

/// Fraction of a uniform solar disc that the Earth and its air cover, as seen from the shadow. It is the area common to
/// the projected solar disc and the shadow of the top of the air, relative to the area of the disc.
///
/// Given     opaque_radius_m  radius of the Earth with its air
/// Returned  0 in full sunlight, 1 in the umbra
/// Accuracy  1e-5, because the planes of Sun, limb and shadow are assumed to be parallel
double covered_part(double axis_distance_m, double depth_m, double sun_distance_m,
                    double opaque_radius_m);

/// Direct light is sunlight that passes clear of the Earth and its air, as a ratio to unshaded sunlight at each
/// wavelength. For a uniform solar disc there is a closed form. A limb-darkened disc is a sum of such concentric discs.
///
/// Accuracy  1e-3 of unshaded sunlight, because an ellipsoid's limb is treated as a circle with the limb's radius at
///           the position angle of the point in the shadow
class DirectLight {
 public:
  DirectLight(const atmosphere::Atmosphere& atmosphere, const Arrangement& arrangement,
              std::span<const double> wavelengths_nm);

  /// Writes direct light as a ratio to unshaded sunlight at each wavelength: 0 in the umbra, 1 in full sunlight.
  void ratios(double axis_distance_m, double position_angle_rad, double depth_m,
              std::span<double> values) const;

  /// Writes the uncovered area of each layer (concentric uniform disc) of the Sun, the whole disc first, relative to
  /// the area of the whole disc. The number of layers is the number of columns that in_layers returns.
  void clear_parts(double axis_distance_m, double position_angle_rad, double depth_m,
                   std::span<double> parts) const;

  /// Converts weights of wavelengths into equivalent weights of layers: the sum of weight times uncovered area over
  /// layers equals the sum of weight times ratio over wavelengths.
  ///
  /// Given     weights  (channel, wavelength)
  /// Returned  (channel, layer)
  algebra::Grid<double> in_layers(const algebra::Grid<double>& weights) const;

  /// Axis distance beyond which the whole Sun is visible [m].
  double penumbra_m(double depth_m) const;

 private:
  atmosphere::Atmosphere atmosphere_;
  Arrangement arrangement_;
  photons::DiscLayers sun_;
};

}  // namespace coppermoon::shadow
