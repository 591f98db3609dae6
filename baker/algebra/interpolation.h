// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace coppermoon::algebra {

/// Straight lines between the points (x, y), the end values held outside.
///
/// Given  x  increasing; y: as many; at: where
double interpolated(std::span<const double> x, std::span<const double> y, double at);

/// The mean of the piecewise linear function through (x, y) over [from, to], the end values held
/// outside.
double mean_between(std::span<const double> x, std::span<const double> y, double from, double to);

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
