// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "photons/bending.h"

namespace coppermoon::photons {

/// Rays at one wavelength past one part of the limb, from the ground upwards.
struct Fan {
  std::vector<double> tangent_height_m, impact_height_m, bending_rad;
  std::vector<double> optical_depth;  ///< [ray], summed over all absorbers along the path
  std::vector<double> filter;         ///< [ray interval], transmittance of cloud and ozone filter
};

/// Refractivities at which rays are traced, so that rays of all wavelengths can be interpolated between them.
///
/// Given     count  number of refractivities, 3 or more
/// Returned  Chebyshev nodes; a single node if all refractivities are equal, or a single 0 if refraction is off
std::vector<double> refractivity_nodes(const atmosphere::Column& column,
                                       std::span<const atmosphere::Optics> optics, int count);

/// Weights for interpolating a ray at one wavelength from rays of the same tangent height, traced at a few
/// refractivities (refractivity_nodes).
///
///     δ = Σ s_k δ_k        τ = Σ s_k β · a_k
///
/// where δ is the bending, τ the optical depth, s_k the Lagrange weights, β the spectra of the absorbers and a_k their
/// amounts along the path.
struct Blend {
  double refractivity;                          ///< n₀ − 1; 0 if refraction is off
  std::vector<double> shares;                   ///< Lagrange weights s_k
  std::vector<atmosphere::Amounts> extinction;  ///< products s_k β
  double cloudy, clear;  ///< transmittance of filters for paths below and above the cloud's top
};

Blend blend(const atmosphere::Column& column, const atmosphere::Optics& optics,
            std::span<const double> nodes);

/// Optical excess e = (ρ/ρ₀) r and its derivative with respect to altitude, with the density ρ and the distance r from
/// the Earth's centre. At the tangent height h, b − R = h + (n₀ − 1) e.
///
/// Given  earth_radius_m  radius of curvature of the ground along the path
atmosphere::ValueAndSlope optical_excess_m(const atmosphere::Column& column, double earth_radius_m,
                                           double tangent_height_m);

/// Table of limb rays through a column of air, computed once for all wavelengths. Bending and amounts are smooth in
/// refractivity and, between breaks of the profiles, in √(h_b − h), with h_b the next break above the tangent height h.
/// They are interpolated in both variables by polynomials through Chebyshev points. The tolerance determines how many
/// rays are traced between two breaks.
///
/// Given     earth_radius_m  radius of curvature of the ground along the path
///           optics          optical properties at all wavelengths that will be requested
///           top_m           altitude up to which a fan has rays, if that is above the top of this column
///           rays            number of rays in a fan; they are densest just below breaks, and where bending and optical
///                           depth curve most
/// Accuracy  compared with limb_path at the same tangent height, with e = 10/rays²: e × 1e-3 rad for bending, e for
///           optical depths up to 4, and a relative error of e/4 for larger ones. If the path contains ozone or
///           aerosol, whose profiles have kinks, errors at single heights may reach 1e-3
class LimbTable {
 public:
  LimbTable(const atmosphere::Column& column, double earth_radius_m,
            std::span<const atmosphere::Optics> optics, int rays, double top_m = 0);

  /// Fan of rays at one wavelength.
  ///
  /// Given  optics  its refractivity must be within the range for which the table was made
  ///        column  the table's column, or one with other amounts of the same absorbers
  Fan fan(const atmosphere::Optics& optics, const atmosphere::Column& column) const;

  /// Number of rays traced through the air.
  std::size_t followed() const { return followed_; }

 private:
  std::vector<double> tangent_heights_m_, refractivities_;
  std::vector<double> optical_excess_m_;      // [ray], (ρ/ρ₀) r
  std::vector<std::vector<LimbPath>> paths_;  // [refractivity][ray]
  std::size_t followed_ = 0;
};

}  // namespace coppermoon::photons
