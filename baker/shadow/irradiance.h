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

/// How Sun and shadow planes stand: distances from the Earth's centre along the shadow axis.
struct Arrangement {
  double sun_distance_m;         ///< 0.3 to 3 au
  std::vector<double> depths_m;  ///< planes behind the Earth, increasing, 1e8 to 1e9 m
  bool limb_darkening = false;   ///< of the Sun's disc, by wavelength; off: uniform
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
  /// [plane × sectors + sector](axis distance, wavelength); sector s is centred at the position angle
  /// 2π s / sectors, so [0] is the first plane's north alone: see mean_ratio
  std::vector<algebra::Grid<double>> ratio;
  std::vector<algebra::Grid<double>> standard_error;  ///< likewise; none where light has no noise
  std::uint64_t photons = 0;                          ///< traced for it
  /// whether a place's wavelengths share their photons, so that their errors add up; if not, errors
  /// are independent
  bool errors_correlated = false;
};

/// No light at all, on every plane in that many sectors, without noise.
RefractedLight darkness(const Arrangement& arrangement, std::span<const double> wavelengths_nm,
                        std::span<const double> axis_distances_m, std::size_t sectors);

/// The ratio's mean over all position angles on one plane.
///
/// Given     light  with light in all its sectors: those that by_quadrature was not asked for are dark
/// Returned  (axis distance, wavelength)
algebra::Grid<double> mean_ratio(const RefractedLight& light, std::size_t plane = 0);

/// The standard error of a weighted sum over wavelengths, from theirs; an upper bound where they
/// are correlated.
double combined_error(const RefractedLight& light, std::span<const double> errors,
                      std::span<const double> weights);

/// The air at sea level for each wavelength.
std::vector<atmosphere::Optics> optics_of(const atmosphere::Atmosphere& atmosphere,
                                          std::span<const double> wavelengths_nm);

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

/// The part of the Sun's uniform disc that the Earth and its air cover, seen from the shadow: the
/// area that two circles share, the projected disc and the one that the air's top throws.
///
/// Given     axis_distance_m, depth_m  the place; opaque_radius_m: of the Earth with its air
/// Returned  0 in full sunlight, 1 where all is covered
/// Accuracy  1e-5: the planes of Sun, limb and shadow are taken as parallel
double covered_part(double axis_distance_m, double depth_m, double sun_distance_m,
                    double opaque_radius_m);

/// Sunlight that passes clear of the Earth and its air, over unshaded sunlight, by wavelength: the
/// closed form for a uniform disc, summed over the discs that make a limb-darkened one.
///
/// Accuracy  1e-3 of unshaded sunlight: an ellipsoid's edge is taken as a circle of its radius at the
///           place's position angle
class DirectLight {
 public:
  DirectLight(const atmosphere::Atmosphere& atmosphere, const Arrangement& arrangement,
              std::span<const double> wavelengths_nm);

  /// Writes one ratio a wavelength, 0 in the umbra to 1 in full sunlight.
  void ratios(double axis_distance_m, double position_angle_rad, double depth_m,
              std::span<double> values) const;

  /// Writes the clear area of each layer of the Sun's disc, the whole disc first, over the area of
  /// the unit disc; as many values as in_layers has columns.
  void clear_parts(double axis_distance_m, double position_angle_rad, double depth_m,
                   std::span<double> parts) const;

  /// Weights of layers that stand for weights of wavelengths: Σ weight clear_part over layers is Σ
  /// weight ratio over wavelengths.
  ///
  /// Given     weights  (channel, wavelength)
  /// Returned  (channel, layer)
  algebra::Grid<double> in_layers(const algebra::Grid<double>& weights) const;

  /// Axis distance beyond which all sunlight is clear [m].
  double penumbra_m(double depth_m) const;

 private:
  atmosphere::Atmosphere atmosphere_;
  Arrangement arrangement_;
  photons::DiscLayers sun_;
};

}  // namespace coppermoon::shadow
