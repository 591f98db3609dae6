// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace coppermoon::algebra {

/// Where a value lies among increasing ones: those on either side, and how far it is from the one below to the one
/// above; outside, the end alone.
struct OnLine {
  std::size_t below, above;
  double further;  ///< 0 to 1
};

/// Given  x  increasing, one or more
OnLine on_line(std::span<const double> x, double at);

/// Straight lines between the points (x, y), the end values held outside.
///
/// Given  x  increasing; y: as many; at: where
double interpolated(std::span<const double> x, std::span<const double> y, double at);

/// The mean of the piecewise linear function through (x, y) over [from, to], the end values held
/// outside.
double mean_between(std::span<const double> x, std::span<const double> y, double from, double to);

/// Weights of some nodes for a value between them: Lagrange's, on the polynomial through all of them.
///
///     c_i = Π_{j≠i} (x − x_j) / (x_i − x_j)
///
/// Given     nodes  all different; at: x
/// Returned  as many, whose sum is 1
std::vector<double> on_polynomial(std::span<const double> nodes, double at);

/// Writes these weights into as many numbers.
void on_polynomial(std::span<const double> nodes, double at, std::span<double> weights);

/// Weights of a number of nodes that is known when it is compiled.
template <std::size_t size>
std::array<double, size> on_polynomial(std::span<const double, size> nodes, double at) {
  std::array<double, size> weights;
  on_polynomial(nodes, at, weights);
  return weights;
}

/// Some of the values that stand evenly around a circle, and how much each counts.
struct OnCircle {
  std::array<std::size_t, 4> at;
  std::array<double, 4> share;  ///< their sum is 1
};

/// The cubic through two values on either side; where all around is one value, that alone.
///
/// Given  count  values around the circle; turn: where between them, 0 at the first, `count` all around
OnCircle on_circle(std::size_t count, double turn);

/// A smooth curve through points: cubics whose slopes agree where they meet, between two points
/// never above the higher nor below the lower one. Outside, straight on with the end slopes.
///
/// Source  Fritsch & Butland (1984), SIAM J. Sci. Stat. Comput. 5, 300; at the ends the slope to
///         the next point
class MonotoneCubic {
 public:
  /// Given  x  increasing, two or more; y: as many
  MonotoneCubic(std::span<const double> x, std::span<const double> y);
  double operator()(double at) const;

 private:
  struct Piece {
    double from, value, slope, second, third;
  };
  std::vector<Piece> pieces_;
  std::vector<std::size_t> first_in_cell_;
  double end_, end_value_, end_slope_, cells_per_unit_;
};

}  // namespace coppermoon::algebra
