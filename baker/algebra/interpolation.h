// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace coppermoon::algebra {

/// Where a value lies among increasing ones: the indices of its neighbours below and above, and the fraction of the way
/// from one to the other. Beyond either end, both indices are that end.
struct OnLine {
  std::size_t below, above;
  double further;  ///< 0 to 1
};

/// Given  x  increasing, one or more
OnLine on_line(std::span<const double> x, double at);

/// Linear interpolation between points (x, y). Beyond the ends, the end values hold.
///
/// Given  x  increasing
double interpolated(std::span<const double> x, std::span<const double> y, double at);

/// Mean over [from, to] of the piecewise linear function through points (x, y). Beyond the ends, the end values hold.
double mean_between(std::span<const double> x, std::span<const double> y, double from, double to);

/// Lagrange weights of the nodes: they give the value at x of the polynomial through all of the nodes.
///
///     c_i = Π_{j≠i} (x − x_j) / (x_i − x_j)
///
/// Given     nodes  x_i, all different
///           at     x
/// Returned  [node], with a sum of 1
std::vector<double> on_polynomial(std::span<const double> nodes, double at);

/// Writes the same weights into a span as long as `nodes`.
void on_polynomial(std::span<const double> nodes, double at, std::span<double> weights);

/// The same weights for a number of nodes that is known at compile time.
template <std::size_t size>
std::array<double, size> on_polynomial(std::span<const double, size> nodes, double at) {
  std::array<double, size> weights;
  on_polynomial(nodes, at, weights);
  return weights;
}

/// Indices and weights of four of the values that are spaced evenly around a circle.
struct OnCircle {
  std::array<std::size_t, 4> at;
  std::array<double, 4> share;  ///< their sum is 1
};

/// Cubic interpolation between the two values on either side; constant if the circle has only one value.
///
/// Given  count  number of values around the circle
///        turn   position on the circle: 0 at the first value, `count` after a full turn
OnCircle on_circle(std::size_t count, double turn);

/// Monotone piecewise cubic interpolation with continuous slope; between two points it stays between their values.
/// Beyond the ends it continues linearly.
///
/// Source  Fritsch & Butland (1984), SIAM J. Sci. Stat. Comput. 5, 300; slopes at the ends are those to
///         the neighbouring point
class MonotoneCubic {
 public:
  /// Given  x  increasing, two or more
  ///        y  as many values
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
