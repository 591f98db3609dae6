// SPDX-License-Identifier: MIT
#include "colour/glow.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "algebra/error.h"
#include "algebra/quadrature.h"
#include "colour/fourier.h"

namespace coppermoon::colour {
namespace {

using std::numbers::pi;

constexpr double inner_rad = 20 * pi / 180 / 3600, outer_rad = 6 * pi / 180,
                 inner_squared = inner_rad * inner_rad, outer_squared = outer_rad * outer_rad;

double logarithm_of_range() { return std::log(outer_squared / inner_squared); }

/// Share of a point source's glow that stays within the source's own pixel, integrated over directions.
double within_own_pixel(double pixel_rad) {
  double share = 0;
  for (const auto& [x, weight] : algebra::gauss_legendre(24))
    share += weight / 2 * glow_within(pixel_rad / 2 / std::cos(pi / 8 * (1 + x)));
  return share;
}

/// Share of the glow that falls in a pixel the given number of columns and rows away from the source.
double within_pixel(std::size_t columns, std::size_t rows, double pixel_rad) {
  const std::size_t away = std::max(columns, rows);
  if (away == 0) return within_own_pixel(pixel_rad);
  const auto nodes = algebra::gauss_legendre(away < 3 ? 12 : away < 9 ? 4 : 2);
  double share = 0;
  for (const auto& [x, x_weight] : nodes)
    for (const auto& [y, y_weight] : nodes)
      share += x_weight * y_weight / 4 *
               glow_spread_per_sr(pixel_rad * std::hypot(static_cast<double>(columns) + x / 2,
                                                         static_cast<double>(rows) + y / 2));
  return share * pixel_rad * pixel_rad;
}

/// Transfer function of the glow, on a grid large enough that nothing wraps around its edges.
Spectrum transfer(std::size_t rows, std::size_t columns, double share, double pixel_rad) {
  Spectrum spread(quick_length(2 * rows), quick_length(2 * columns));
  tbb::parallel_for(std::size_t{0}, rows, [&](std::size_t r) {
    for (std::size_t c = 0; c < columns; ++c) {
      const double value = share * within_pixel(c, r, pixel_rad);
      for (const std::size_t row : {r, (spread.rows() - r) % spread.rows()})
        for (const std::size_t column : {c, (spread.columns() - c) % spread.columns()})
          spread(row, column) = value;
    }
  });
  spread(0, 0) += 1 - share;
  fourier_transform(spread, Direction::forward);
  return spread;
}

/// Convolves two channels at once, as real and imaginary parts of one grid. The kernel is even; its transform is real.
void spread(Image& picture, const Spectrum& transfer, std::size_t first, std::size_t second) {
  Spectrum all(transfer.rows(), transfer.columns());
  for (std::size_t r = 0; r < picture.rows(); ++r)
    for (std::size_t c = 0; c < picture.columns(); ++c)
      all(r, c) = {picture(r, c)[first], picture(r, c)[second]};
  fourier_transform(all, Direction::forward);
  const double count = static_cast<double>(all.values().size());
  for (std::size_t i = 0; i < all.values().size(); ++i)
    all.values()[i] *= transfer.values()[i].real() / count;
  fourier_transform(all, Direction::back);
  for (std::size_t r = 0; r < picture.rows(); ++r)
    for (std::size_t c = 0; c < picture.columns(); ++c) {
      picture(r, c)[second] = static_cast<float>(all(r, c).imag());
      picture(r, c)[first] = static_cast<float>(all(r, c).real());
    }
}

}  // namespace

double glow_spread_per_sr(double angle_rad) {
  const double squared = angle_rad * angle_rad;
  return (outer_squared - inner_squared) /
         (pi * logarithm_of_range() * (inner_squared + squared) * (outer_squared + squared));
}

double glow_within(double angle_rad) {
  const double squared = angle_rad * angle_rad;
  return (std::log1p(squared / inner_squared) - std::log1p(squared / outer_squared)) /
         logarithm_of_range();
}

Image with_glow(const Image& picture, double share, double pixel_rad) {
  algebra::require_within("share of light in the glow", share, 0, 0.5);
  algebra::require_within("pixel [rad]", pixel_rad, 1e-12, 1);
  if (picture.empty() || share == 0) return picture;
  auto result = picture;
  const auto left = transfer(picture.rows(), picture.columns(), share, pixel_rad);
  spread(result, left, 0, 1);
  spread(result, left, 2, 2);
  return result;
}

}  // namespace coppermoon::colour
