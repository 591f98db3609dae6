// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "algebra/progress.h"
#include "shadow/irradiance.h"

namespace coppermoon::shadow {

/// Ratio to unshaded sunlight below which light is invisible. It gives the Moon a luminance of about 5e-11 cd/m², a
/// thousandth of the smallest positive half-precision number.
inline constexpr double darkness_ratio = 1e-14;

/// Settings that determine the resolution of the quadrature.
struct QuadratureSettings {
  /// number of rays between the ground and the air's top, 2 to 1e7. Bins of landing distance are 4 km wide with 300
  /// rays, and narrower in proportion with more rays
  int rays = 300;
  int sun_terms = 6;  ///< number of terms for a limb-darkened disc (photons::disc_terms), 1 to 6
  /// sectors to compute, out of 4 to 360 sectors around the axis; the others stay dark. If the air is the same
  /// everywhere, all sectors are computed
  Sectors sectors{sectors_around};
  /// highest harmonic of the position angle, 2 to 160; a lower one is used if it suffices for the air and the rays
  int harmonics = 160;
  /// tolerance for interpolation between axis distances. If cubic interpolation from four of them errs by more, another
  /// one is inserted between the middle two. The error is relative to refracted plus direct light over all wavelengths,
  /// with direct light counted as at least dark_ratio. If the tolerance is 0, no axis distances are inserted
  double place_error = 0;
  /// ratio to unshaded sunlight, 1e-14 or more, below which light counts as dark, so that no axis distances are
  /// inserted to resolve it
  double dark_ratio = darkness_ratio;
};

/// Computes refracted light by quadrature, which is free of noise.
///
///     E(γ, θ)/E₀ = (1 + z/D)² / (π a²) ∫∫ T(b) b Φ db
///
/// where γ and θ are the axis distance and position angle of the place, z its depth, D the distance of the Sun, b the
/// impact parameter, T the transmittance and a the radius of the projected solar disc. A ray from the Sun's centre
/// lands at the signed distance r(b) from the axis. Φ is the angle, seen from the axis, of that part of the circle of
/// radius |r| about the axis that lies inside the solar disc about the place. Every element of the limb sends its light
/// along a line through the axis, to its own side (r > 0) or to the opposite side (r < 0). The focus on the axis and
/// the caustics are integrable. T b db is summed over bins of r, with its first and second moments (LandedLight). Φ is
/// approximated by quadratics in r over stretches of bins. Towards the disc's edges, stretches narrow down to single
/// bins with the mean of Φ. A place needs some forty stretches, however many bins there are. For a limb-darkened disc,
/// Φ is an integral of the disc's radiance along the arc (photons::DiscTerms).
///
/// Light from a part of the limb (photons::WholeLimb: a region, a belt of latitude, an ellipsoid's equator or pole) is
/// weighted by that part's share w of the limb at the position angle ψ from which the light comes:
///
///     w(ψ) = Σ c_m cos mψ + s_m sin mψ        E = Σ (c_m cos mθ + s_m sin mθ) E_m
///
/// The integral for E_m, the light of harmonic m, contains cos mψ. In it, ψ is counted from the position angle θ of the
/// place, so that the arcs for one axis distance serve all θ. Farther from the axis than the projected Sun's radius,
/// only those parts of the limb contribute that the disc covers. An ellipsoid needs m = 0 and 2. Belts need m up to 24
/// with 300 rays and up to 37 with 600 rays; regions need m up to 75 and 150. Near the axis, fewer harmonics suffice.
///
/// Given     wavelengths_nm    380 to 780
///           axis_distances_m  increasing, 0 or more
/// Returned  light at these axis distances and at inserted ones; one sector for symmetric air, otherwise the number of
///           sectors requested
/// Accuracy  compared with 8000 rays, up to 4500 km from the axis, at the worst wavelength and at 550 nm: 1.3e-3 and
///           3e-4 with 300 rays, 1.5e-4 and 8e-5 with 1000 rays; farther out, 1e-5 of unshaded sunlight. Omitted
///           harmonics cause errors of 4e-4 with belts. With regions, they cause errors of 1e-4 on average, but 2e-2 if
///           a region is much dimmer than its neighbour
/// Omits     the difference between bending along the ellipsoid's vertical and towards the axis. The difference
///           displaces light by 21 km at most, which is little beside the 3600 km over which the Sun's disc blurs light
/// Throws    Error             if an argument is outside its range
RefractedLight by_quadrature(const atmosphere::Atmosphere& atmosphere,
                             const Arrangement& arrangement, std::span<const double> wavelengths_nm,
                             std::span<const double> axis_distances_m,
                             const QuadratureSettings& settings = {},
                             const algebra::Progress& progress = {});

/// Computes refracted light in several atmospheres at once, which is faster than one by one, because rays and arcs are
/// computed only once for all of them.
///
/// Given     airs   one or more, which may differ only in their dust, ozone and cloud cover
/// Returned  light in each atmosphere, all at the same axis distances
/// Throws    Error  if the atmospheres differ in anything else (atmosphere::richest), and as for by_quadrature
std::vector<RefractedLight> by_quadrature_in(std::span<const atmosphere::Atmosphere> airs,
                                             const Arrangement& arrangement,
                                             std::span<const double> wavelengths_nm,
                                             std::span<const double> axis_distances_m,
                                             const QuadratureSettings& settings = {},
                                             const algebra::Progress& progress = {});

}  // namespace coppermoon::shadow
