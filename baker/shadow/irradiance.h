// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "algebra/grid.h"
#include "atmosphere/atmosphere.h"

namespace coppermoon::shadow {

/// How Sun and shadow planes stand: distances from the Earth's centre along the shadow axis.
struct Arrangement {
  double sun_distance_m;         ///< 0.3 to 3 au
  std::vector<double> depths_m;  ///< planes behind the Earth, increasing, 1e8 to 1e9 m
};

/// Throws Error when a distance is outside its range
void require_valid(const Arrangement& arrangement);

/// Light that came through the Earth's air, over what an unshaded surface there would receive: a
/// function of place in the shadow and wavelength.
struct RefractedLight {
  Arrangement arrangement;
  std::vector<double> wavelengths_nm;
  std::vector<double> axis_distances_m;  ///< increasing
  /// equal parts of the position angle about the axis; 1: all around alike
  std::size_t sectors = 1;
  /// [plane × sectors + sector](axis distance, wavelength); sector s is centred at 2π s / sectors
  std::vector<algebra::Grid<double>> ratio, standard_error;
};

/// Radius of the Sun's image that a point of the limb throws on a plane: the projected solar disc
/// [m].
double projected_solar_radius_m(const Arrangement& arrangement, double depth_m);

/// Where a ray from the Sun's centre lands that passed the limb: signed distance from the axis.
///
///     r = b / cos ε + z tan ε       ε = asin(b/D) − δ
///
/// Given  impact_parameter_m  b; bending_rad: δ; depth_m: z
double landing_m(double impact_parameter_m, double bending_rad, double sun_distance_m,
                 double depth_m);

/// Largest axis distance that refracted light reaches on a plane [m].
double refracted_reach_m(const Arrangement& arrangement, const atmosphere::Atmosphere& atmosphere,
                         double depth_m);

/// Area common to two circles of radii r and s whose centres stand that far apart.
double lens_area(double apart, double r, double s);

/// The part of the Sun's uniform disc that stands clear of the Earth and its air, seen from the
/// shadow: the area of the projected disc outside the circle that the air's top throws.
///
/// Given     axis_distance_m, depth_m  the place; opaque_radius_m: of the Earth with its air
/// Returned  0 in the umbra to 1 in full sunlight
/// Accuracy  1e-5: the planes of Sun, limb and shadow are taken as parallel
/// Source    area of a lens between two circles
double direct_ratio(double axis_distance_m, double depth_m, double sun_distance_m,
                    double opaque_radius_m);

}  // namespace coppermoon::shadow
