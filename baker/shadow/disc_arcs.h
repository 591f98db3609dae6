// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>
#include <vector>

#include "algebra/grid.h"
#include "photons/limb_darkening.h"

namespace coppermoon::shadow {

/// Interval of axis distance that consists of whole bins. In it, the integral along an arc within the projected Sun's
/// disc is approximated by a quadratic in the arc's radius, which is given by its values at three Gauss nodes.
struct Stretch {
  int from, to;
  /// the integrals ∫ f(μ) cos mψ dψ [rad] along the arcs at the three Gauss nodes, nearest to the axis first, indexed
  /// by (limb-darkening term f, harmonic m); ψ is counted from the position angle of the place
  std::array<algebra::Grid<double>, 3> light;
};

/// Coefficients of r⁰, r¹ and r² in the quadratic through the given values at three Gauss nodes of an interval of r.
std::array<double, 3> square_through(double from, double to, const std::array<double, 3>& values);

/// Divides the Sun's projected disc, centred on a place in the shadow, into intervals of distance from the axis. Such a
/// Stretch is narrower near the disc's edges, because an arc's length varies there as the square root of the distance
/// from the edge. At the edges, stretches are one bin wide and hold the mean over the bin.
///
/// Given     gamma    axis distance of the place, in bin widths
///           a        radius of the disc, in bin widths
///           highest  highest harmonic to integrate
///           from, to  axis distances, in bin widths, between which results are wanted
std::vector<Stretch> disc_stretches(const photons::DiscTerms& sun, double gamma, double a,
                                    int highest, int from, int to);

}  // namespace coppermoon::shadow
