// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "algebra/progress.h"
#include "shadow/irradiance.h"

namespace coppermoon::shadow {

/// Ratio to unshaded sunlight of light that nobody can see: a thousandth of what the smallest half float
/// above 0 stands for on the Moon.
inline constexpr double darkness_ratio = 1e-14;

/// How finely the quadrature goes.
struct QuadratureSettings {
  /// rays from the one that grazes the ground to the air's top, 2 to 1e7; the bins of landing distance
  /// are 4 km wide at 300 rays, and in proportion
  int rays = 300;
  int sun_terms = 6;  ///< of a limb-darkened disc (photons::disc_terms), 1 to 6
  /// sectors that are computed, 4 to 360 around; the others stay dark. All are computed at once where the
  /// air has one column
  Sectors sectors{sectors_around};
  /// highest harmonic of the position angle that light is computed to, 2 to 160; some air needs fewer
  int harmonics = 160;
  /// relative error of a cubic through four axis distances above which one more is put between the
  /// middle two; the error counts against all light there, over all wavelengths, with direct light
  /// taken as dark_ratio where there is less; 0: none is added
  double place_error = 0;
  /// ratio to unshaded sunlight below which light is treated as dark, 1e-14 or more: no more rings are
  /// computed for its sake
  double dark_ratio = darkness_ratio;
};

/// Refracted light without noise.
///
///     E(γ, θ)/E₀ = (1 + z/D)² / (π a²) ∫∫ T(b) b Φ db
///
/// with b the impact parameter, T the transmittance, r(b) the signed distance from the axis at which
/// the ray from the Sun's centre lands, a the radius of the projected solar disc and Φ the angle, as
/// seen from the axis, of the arc of radius |r| inside the disc about the place: every stretch of
/// the limb sends its light along lines through the axis, to its own side (r > 0) or across (r < 0).
/// Focus on the axis and caustics integrate away. T b db is summed over bins of r, with its first
/// and second moments (LandedLight); Φ is a square in r over stretches of bins that narrow towards
/// the disc's ends, and there its mean, from the area that the disc shares with circles: dA/dr =
/// |r| Φ. So a place costs some forty stretches, whatever the bins. A limb-darkened disc is a sum of
/// uniform ones.
///
/// Light from a part of the limb (photons::WholeLimb), as a region, a belt, the equator or the pole
/// of an ellipsoid, counts by that part's share w of the limb at the position angle ψ it comes from:
///
///     w(ψ) = Σ c_m cos mψ + s_m sin mψ        E = Σ (c_m cos mθ + s_m sin mθ) E_m
///
/// with cos mψ in the integral for E_m, ψ from the place's own angle: one cut of the disc serves all
/// angles. Farther out than the Sun's radius an angle counts no part but those that the disc covers. On an
/// ellipsoid m is 0 and 2; up to 48 between belts and 160 between regions, fewer near the axis.
///
/// Given     wavelengths_nm  380 to 780; axis_distances_m: increasing, 0 or more
/// Returned  at those distances, and more; one sector for air that is alike all around, else as many
///           as asked for
/// Accuracy  against 8000 rays, any wavelength, up to 4500 km from the axis, worst and at 550 nm:
///           at 300 rays 1.3e-3 and 3e-4, at 1000 1.5e-4 and 8e-5; beyond, 1e-5 of unshaded
///           sunlight. Harmonics left out: of air in belts 4e-4; in regions 1e-4 in the mean, and
///           2e-2 where light of one is dim beside the neighbour's
/// Omits     that rays bend along the ellipsoid's vertical, not towards the axis: 21 km sideways at
///           most, of the 3600 km over which the Sun's disc blurs
/// Throws    Error           when an argument is outside its range
RefractedLight by_quadrature(const atmosphere::Atmosphere& atmosphere,
                             const Arrangement& arrangement, std::span<const double> wavelengths_nm,
                             std::span<const double> axis_distances_m,
                             const QuadratureSettings& settings = {},
                             const algebra::Progress& progress = {});

/// Refracted light in several airs at once, in less time than one after the other: rays are followed once,
/// and light is cut into arcs once for all of them.
///
/// Given     airs   one or more, that differ in amounts of dust, ozone and cloud cover alone
/// Returned  light in each, at the same distances
/// Throws    Error  when airs differ in anything else (atmosphere::richest), and as by_quadrature
std::vector<RefractedLight> by_quadrature_in(std::span<const atmosphere::Atmosphere> airs,
                                             const Arrangement& arrangement,
                                             std::span<const double> wavelengths_nm,
                                             std::span<const double> axis_distances_m,
                                             const QuadratureSettings& settings = {},
                                             const algebra::Progress& progress = {});

}  // namespace coppermoon::shadow
