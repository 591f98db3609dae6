// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "photons/bending.h"

namespace coppermoon::photons {

/// Rays of one wavelength past one part of the limb, from the ground up.
struct Fan {
  std::vector<double> tangent_height_m, impact_height_m, bending_rad;
  std::vector<double> optical_depth;  ///< [ray], due to all absorbers along the path
  std::vector<double> filter;         ///< [interval between rays], by atmosphere::limb_filter
};

/// Refractivities at which rays are traced, so that rays of all wavelengths can be interpolated between them.
///
/// Given     count  3 or more
/// Returned  Chebyshev nodes; a single node if all refractivities are equal, as they are (0) if refraction is off
std::vector<double> refractivity_nodes(const atmosphere::Column& column,
                                       std::span<const atmosphere::Optics> optics, int count);

/// Interpolates a ray at one wavelength from rays at refractivity_nodes with the same tangent height.
///
///     δ = Σ s_k δ_k        τ = Σ s_k β · a_k
///
/// with s_k the Lagrange weights, β the spectra of the absorbers, a_k their amounts along the path.
struct Blend {
  double refractivity;                          ///< n₀ − 1; 0 if refraction is off
  std::vector<double> shares;                   ///< s_k
  std::vector<atmosphere::Amounts> extinction;  ///< s_k β
  double cloudy, clear;  ///< limb_filter of paths below and above the cloud's top
};

Blend blend(const atmosphere::Column& column, const atmosphere::Optics& optics,
            std::span<const double> nodes);

/// Optical excess e = (ρ/ρ₀) r and its derivative by altitude; b − R = h + (n₀ − 1) e at the tangent height h.
///
/// Given  earth_radius_m  radius of curvature of the ground along the path
atmosphere::ValueAndSlope optical_excess_m(const atmosphere::Column& column, double earth_radius_m,
                                           double tangent_height_m);

/// Table of limb rays through a column of air, computed once for all wavelengths. Bending and amounts are smooth
/// in refractivity and, between breaks of the air, in √(h_b − h), with h_b the next break above the tangent height h.
/// They are interpolated in both variables by polynomials through Chebyshev points; the number of rays traced
/// between two breaks follows from the tolerance.
///
/// Given     earth_radius_m  radius of curvature of the ground along the path
///           optics          for all wavelengths that will be requested
///           top_m           altitude up to which a fan has rays, if that is above the top of this air
///           rays            number of rays in a fan; densest just below breaks, and where bending and optical
///                           depth curve most
/// Accuracy  against limb_path at the same tangent height, with e = 10/rays²: bending e × 1e-3 rad; optical
///           depth e, or e/4 relative where it exceeds 4. If the path has ozone or aerosol, whose profiles have knees,
///           no better than 1e-3 at single heights
class LimbTable {
 public:
  LimbTable(const atmosphere::Column& column, double earth_radius_m,
            std::span<const atmosphere::Optics> optics, int rays, double top_m = 0);

  /// Fan of rays at one wavelength.
  ///
  /// Given  optics  with a refractivity between those for which the table was made
  ///        column  may differ from the table's only in the amounts of absorbers, and has no absorber that the
  ///                table's column lacks
  Fan fan(const atmosphere::Optics& optics, const atmosphere::Column& column) const;

  /// Number of rays traced through the air.
  std::size_t followed() const { return followed_; }

 private:
  std::vector<double> tangent_heights_m_, refractivities_;
  std::vector<double> optical_excess_m_;      // [ray] ρ/ρ₀ r
  std::vector<std::vector<LimbPath>> paths_;  // [refractivity][ray]
  std::size_t followed_ = 0;
};

}  // namespace coppermoon::photons
