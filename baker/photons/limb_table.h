// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "photons/bending.h"

namespace coppermoon::photons {

/// Rays of one wavelength that pass one part of the limb, from the ground up.
struct Fan {
  std::vector<double> tangent_height_m, impact_height_m, bending_rad;
  std::vector<double> optical_depth;  ///< [ray], due to all absorbers along the path
  std::vector<double> filter;         ///< [interval between rays], from atmosphere::limb_filter
};

/// Refractivities at which rays are traced, so that rays of all wavelengths can be interpolated between them.
///
/// Given     count  3 or more
/// Returned  Chebyshev nodes; a single node if all refractivities are equal, or a single 0 if refraction is off
std::vector<double> refractivity_nodes(const atmosphere::Column& column,
                                       std::span<const atmosphere::Optics> optics, int count);

/// Interpolates a ray at one wavelength from rays that were traced at refractivity_nodes with the same tangent height.
///
///     δ = Σ s_k δ_k        τ = Σ s_k β · a_k
///
/// where s_k are the Lagrange weights, β the spectra of the absorbers and a_k their amounts along the path.
struct Blend {
  double refractivity;                          ///< n₀ − 1; 0 if refraction is off
  std::vector<double> shares;                   ///< Lagrange weights s_k
  std::vector<atmosphere::Amounts> extinction;  ///< s_k β
  double cloudy, clear;  ///< limb_filter for paths below and above the cloud's top
};

Blend blend(const atmosphere::Column& column, const atmosphere::Optics& optics,
            std::span<const double> nodes);

/// Optical excess e = (ρ/ρ₀) r and its derivative with respect to altitude. b − R = h + (n₀ − 1) e at the tangent
/// height h.
///
/// Given  earth_radius_m  radius of curvature of the ground along the path
atmosphere::ValueAndSlope optical_excess_m(const atmosphere::Column& column, double earth_radius_m,
                                           double tangent_height_m);

/// Table of limb rays through a column of air, computed once for all wavelengths. Bending and amounts are smooth in
/// refractivity and, between breaks of the air, in √(h_b − h), with h_b the next break above the tangent height h. They
/// are interpolated in both variables by polynomials through Chebyshev points. The tolerance determines how many rays
/// are traced between two breaks.
///
/// Given     earth_radius_m  radius of curvature of the ground along the path
///           optics          for all wavelengths that will be requested
///           top_m           altitude up to which a fan has rays, if that is above the top of this air
///           rays            number of rays in a fan; they are densest just below breaks, and where bending and optical
///                           depth curve most
/// Accuracy  compared with limb_path at the same tangent height, with e = 10/rays²: e × 1e-3 rad for bending; e for
///           optical depths up to 4, and e/4 relative for larger ones. If the path has ozone or aerosol, whose profiles
///           have kinks, no better than 1e-3 at single heights
class LimbTable {
 public:
  LimbTable(const atmosphere::Column& column, double earth_radius_m,
            std::span<const atmosphere::Optics> optics, int rays, double top_m = 0);

  /// Fan of rays at one wavelength.
  ///
  /// Given  optics  its refractivity must lie between those for which the table was made
  ///        column  may differ from the table's column only in amounts, and must have no absorber that it lacks
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
