// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace coppermoon::algebra {

/// Position of a value in an increasing sequence: the indices of its neighbours below and above, and the fraction of
/// the way from the lower to the upper one. Outside the sequence, both indices are that of the nearest end.
struct OnLine {
  std::size_t below, above;
  double further;  ///< fraction of the way from `below` to `above`, 0 to 1
};

/// Finds the position of the value `at` in x, which holds one or more increasing values.
OnLine on_line(std::span<const double> x, double at);

/// Interpolates linearly between the points (x, y). Outside the range of x, the result is the y of the nearest end.
///
/// Given  x  values in increasing order
double interpolated(std::span<const double> x, std::span<const double> y, double at);

/// Mean over [from, to] of the piecewise linear function through the points (x, y), which is constant beyond them.
double mean_between(std::span<const double> x, std::span<const double> y, double from, double to);

/// Lagrange weights c_i. The polynomial through the values y_i at the nodes x_i has the value Σ c_i y_i at x.
///
///     c_i = Π_{j≠i} (x − x_j) / (x_i − x_j)
///
/// Given     nodes  x_i, all different
///           at     x
/// Returned  one weight for each node; the weights add up to 1
std::vector<double> on_polynomial(std::span<const double> nodes, double at);

/// Writes the Lagrange weights of the nodes into `weights`, which has the same length.
void on_polynomial(std::span<const double> nodes, double at, std::span<double> weights);

/// Lagrange weights for a number of nodes that is known at compile time.
template <std::size_t size>
std::array<double, size> on_polynomial(std::span<const double, size> nodes, double at) {
  std::array<double, size> weights;
  on_polynomial(nodes, at, weights);
  return weights;
}

/// Indices and weights for interpolation between values that are spaced evenly around a circle.
struct OnCircle {
  std::array<std::size_t, 4> at;
  std::array<double, 4> share;  ///< weights, which add up to 1
};

/// Weights for cubic interpolation around a circle, from two values on either side. A single value gets the weight 1.
///
/// Given  count  number of values around the circle
///        turn   position on the circle: 0 at the first value, `count` after a full turn
OnCircle on_circle(std::size_t count, double turn);

/// Piecewise cubic interpolation with continuous slope. It is monotone between two points, and so stays between their
/// values. Beyond the ends, it continues as a straight line.
///
/// Source  Fritsch & Butland (1984), SIAM J. Sci. Stat. Comput. 5, 300; the slope at either end is that of the
///         line to the neighbouring point
class MonotoneCubic {
 public:
  /// Given  x  two or more increasing values
  ///        y  one value for each x
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
