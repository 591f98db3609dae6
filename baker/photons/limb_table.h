// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "photons/bending.h"

namespace coppermoon::photons {

/// The rays of one wavelength over one part of the limb, from the ground up.
struct Fan {
  std::vector<double> tangent_height_m, impact_height_m, bending_rad;
  std::vector<double> optical_depth;  ///< of all that stands along the path, at each ray
  std::vector<double> filter;         ///< of cloud and filters, between each ray and the next
};

/// Refractivities that rays are followed at, for all of some wavelengths: between them a ray
/// changes smoothly.
///
/// Given     count  3 or more
/// Returned  Chebyshev's nodes; one alone where all are the same, 0 where the air does not bend
std::vector<double> refractivity_nodes(const atmosphere::Column& column,
                                       std::span<const atmosphere::Optics> optics, int count);

/// Weights that make a wavelength's ray of the same ray at such nodes.
///
///     δ = Σ s_k δ_k        τ = Σ s_k β · a_k
///
/// s_k Lagrange's weights, β the spectra of what stands along the path, a_k its amounts.
struct Blend {
  double refractivity;                          ///< n₀ − 1; 0 where the air does not bend
  std::vector<double> shares;                   ///< s_k
  std::vector<atmosphere::Amounts> extinction;  ///< s_k β
  double cloudy, clear;  ///< limb_filter of paths below the cloud's top, and above
};

Blend blend(const atmosphere::Column& column, const atmosphere::Optics& optics,
            std::span<const double> nodes);

/// (ρ/ρ₀) r and its slope over altitude: b − R is h and the refractivity times that.
///
/// Given  earth_radius_m  of the ground's curvature along the path
atmosphere::ValueAndSlope optical_excess_m(const atmosphere::Column& column, double earth_radius_m,
                                           double tangent_height_m);

/// Limb rays of a column of air, computed once for all wavelengths: path and amounts are smooth in
/// refractivity, and between the breaks of the air in √(h_b − h), h_b the next break above the
/// tangent height h. In both they are polynomials through Chebyshev's points; between two breaks as
/// many rays are followed as the error asks for.
///
/// Given     earth_radius_m  of the ground's curvature along the path
///           optics          of all wavelengths that will be asked for
///           top_m           altitude up to which a fan has rays, where that is above this air
///           rays            of a fan: closest below the breaks, and most where bending and optical
///                           depth are least like straight lines
/// Accuracy  against limb_path at the same tangent height, with e = 10/rays²: of bending e times
///           1e-3 rad, of optical depth e, and from 4 up a quarter of e of it; where ozone or
///           aerosol stand along the path, whose profiles have knees, no better than 1e-3 at one
///           height
class LimbTable {
 public:
  LimbTable(const atmosphere::Column& column, double earth_radius_m,
            std::span<const atmosphere::Optics> optics, int rays, double top_m = 0);

  /// Given  optics  within those the table was made for
  ///        column  of the same profiles as the table's, and of its cloud's top, with as much of each as there
  ///                is; the table's has some of all that it has
  Fan fan(const atmosphere::Optics& optics, const atmosphere::Column& column) const;

  /// How many rays were followed through the air.
  std::size_t followed() const { return followed_; }

 private:
  std::vector<double> tangent_heights_m_, refractivities_;
  std::vector<double> optical_excess_m_;      // of each ray, ρ/ρ₀ r
  std::vector<std::vector<LimbPath>> paths_;  // [refractivity][ray]
  std::size_t followed_ = 0;
};

}  // namespace coppermoon::photons
