// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>
#include <vector>

#include "algebra/grid.h"
#include "photons/limb_darkening.h"

namespace coppermoon::shadow {

/// A stretch of distances from the axis, in whole bins. Over it the light that the Sun's disc about
/// a place sheds along arcs is a square of the distance, through Gauss's three nodes.
struct Stretch {
  int from, to;
  /// [node](term of the disc, harmonic m) ∫ f(μ) cos mψ dψ over the arc [rad], ψ from the place's
  /// position angle, lowest distance first
  std::array<algebra::Grid<double>, 3> light;
};

/// The polynomial in r, powers 0 to 2, through three values at Gauss's nodes between two ends.
std::array<double, 3> square_through(double from, double to, const std::array<double, 3>& values);

/// The arcs that the Sun's disc about a place takes in, about the axis, by stretches from the
/// innermost to the outermost: narrow towards the disc's edges, where an arc goes as the root of the
/// distance; one bin wide there, and of the mean over it.
class DiscArcs {
 public:
  /// Given  gamma, a  of the place and of the disc's radius, in bins
  ///        highest   harmonic
  DiscArcs(const photons::DiscTerms& sun, double gamma, double a, int highest);

  /// Stretches between two distances, in bins.
  std::vector<Stretch> stretches(int from, int to) const;

 private:
  double half_arc(double r) const;
  algebra::Grid<double> darkness() const;
  void add_arc(double r, double weight, algebra::Grid<double>& light) const;
  algebra::Grid<double> mean_over(int from, int to) const;

  const photons::DiscTerms& sun_;
  double gamma_, a_;
  int highest_;
  std::array<double, 2> edges_;  ///< of the disc, towards the axis and away
  std::vector<int> ends_;
};

}  // namespace coppermoon::shadow
