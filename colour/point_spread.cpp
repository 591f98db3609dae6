// SPDX-License-Identifier: MIT
#include "colour/point_spread.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "algebra/error.h"
#include "algebra/interpolation.h"
#include "colour/fourier.h"

namespace coppermoon::colour {
namespace {

using std::numbers::pi;

/// The jinc function, 2 J₁(x)/x.
double jinc(double x) { return std::abs(x) < 1e-4 ? 1 - x * x / 8 : 2 * ::j1(x) / x; }

/// Distance of index `i` from index 0 on a line of the given length that wraps around.
double from_first(std::size_t i, std::size_t length) {
  return static_cast<double>(std::min(i, length - i));
}

/// A pixel's width in units of λ/D.
double spreads_a_pixel(const Blur& blur, double pixel_rad) {
  return pixel_rad * blur.aperture.diameter_m / (blur.wavelength_nm * 1e-9);
}

/// Mean of the diffraction pattern over a pixel whose offset from the centre is given in pixels. Where the pattern is
/// steep, it is sampled four times per λ/D.
double over_a_pixel(const Blur& blur, double pixel_rad, double x, double y) {
  const double away = std::hypot(x, y), most = away < 2 ? 128 : away < 8 ? 16 : 1;
  const double wanted = std::max(4., 4 * spreads_a_pixel(blur, pixel_rad));
  const int parts = static_cast<int>(std::ceil(std::min(wanted, most)));
  double sum = 0;
  for (int i = 0; i < parts; ++i)
    for (int j = 0; j < parts; ++j) {
      const auto at = [&](double middle, int k) { return middle + (k + 0.5) / parts - 0.5; };
      sum += diffraction_spread_per_sr(blur.aperture, blur.wavelength_nm,
                                       pixel_rad * std::hypot(at(x, i), at(y, j)));
    }
  return sum / (parts * parts);
}

/// Transfer function of diffraction.
Spectrum diffraction_transfer(const Blur& blur, double pixel_rad, std::size_t rows,
                              std::size_t columns) {
  Spectrum spread(rows, columns);
  tbb::parallel_for(std::size_t{0}, rows / 2 + 1, [&](std::size_t r) {
    for (std::size_t c = 0; c <= columns / 2; ++c) {
      const double value =
          over_a_pixel(blur, pixel_rad, from_first(c, columns), from_first(r, rows));
      for (const std::size_t row : {r, (rows - r) % rows})
        for (const std::size_t column : {c, (columns - c) % columns}) spread(row, column) = value;
    }
  });
  double sum = 0;
  for (const auto& value : spread.values()) sum += value.real();
  for (auto& value : spread.values()) value /= sum;
  fourier_transform(spread, Direction::forward);
  return spread;
}

/// Seeing below this width is left out, because it spreads less than 1e-5 of the light beyond a pixel.
constexpr double least_seeing_px = 1 / 32.;

/// Transfer function of seeing as sampled by pixels: the sum over a frequency (cycles per pixel) and all its aliases.
///
/// The part of the sum that is due to aliases is smooth in the squares of the frequency's components, so it is
/// interpolated with a polynomial through Chebyshev nodes.
///
/// Accuracy  1e-9
class SampledSeeing {
 public:
  static constexpr std::size_t count = 9;
  using Counts = std::array<double, count>;

  explicit SampledSeeing(double width_px) : width_px_(width_px), others_(count, count) {
    for (std::size_t i = 0; i < count; ++i)
      squares_[i] = (1 - std::cos(pi * (static_cast<double>(i) + 0.5) / count)) / 8;  // in [0, 1/4]
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = 0; j <= i; ++j)
        others_(i, j) = others_(j, i) =
            of_others(std::sqrt(squares_[i]), std::sqrt(squares_[j]), width_px);
    whole_ = 1 + summed(along(counts(0)), counts(0));
  }

  /// Weight of each interpolation node, given one component of a frequency (-1/2 to 1/2).
  Counts counts(double frequency) const {
    return algebra::on_polynomial<count>(squares_, frequency * frequency);
  }

  /// Sums over aliases at each node in x, interpolated in y with the given weights.
  Counts along(const Counts& of_y) const {
    Counts line{};
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = 0; j < count; ++j) line[j] += of_y[i] * others_(i, j);
    return line;
  }

  double left(double frequency, const Counts& along_x, const Counts& of_x) const {
    return (seeing_transfer(frequency, width_px_) + summed(along_x, of_x)) / whole_;
  }

 private:
  static double summed(const Counts& line, const Counts& of_x) {
    return std::inner_product(line.begin(), line.end(), of_x.begin(), 0.);
  }

  static double of_others(double x, double y, double width_px) {
    constexpr double last = 3;  // frequency [cycles per seeing width] at which only 2e-10 is left
    const int folds = static_cast<int>(std::ceil(last / width_px));
    double sum = 0;
    for (int i = -folds; i <= folds; ++i)
      for (int j = -folds; j <= folds; ++j)
        if (i != 0 || j != 0) sum += seeing_transfer(std::hypot(x + i, y + j), width_px);
    return sum;
  }

  double width_px_, whole_ = 1;
  Counts squares_{};
  algebra::Grid<double> others_;
};

void multiply_by_seeing(Spectrum& spectrum, double width_px) {
  const std::size_t rows = spectrum.rows(), columns = spectrum.columns();
  const SampledSeeing seeing(width_px);
  const auto frequency = [](std::size_t i, std::size_t length) {
    return static_cast<double>(i) / static_cast<double>(length);
  };
  std::vector<SampledSeeing::Counts> counts;
  for (std::size_t c = 0; c <= columns / 2; ++c)
    counts.push_back(seeing.counts(frequency(c, columns)));
  tbb::parallel_for(std::size_t{0}, rows / 2 + 1, [&](std::size_t r) {
    const double y = frequency(r, rows);
    const auto along = seeing.along(seeing.counts(y));
    for (std::size_t c = 0; c <= columns / 2; ++c) {
      const double left = seeing.left(std::hypot(frequency(c, columns), y), along, counts[c]);
      const std::size_t below = (rows - r) % rows, beyond = (columns - c) % columns;
      spectrum(r, c) *= left;
      if (below != r) spectrum(below, c) *= left;
      if (beyond != c) spectrum(r, beyond) *= left;
      if (below != r && beyond != c) spectrum(below, beyond) *= left;
    }
  });
}

/// Converts an index in the padded picture to one in the picture. The first half of the padding repeats the last row or
/// column, and the second half repeats the first.
std::size_t inside(std::size_t i, std::size_t length, std::size_t padded) {
  if (i < length) return i;
  return i < (length + padded) / 2 ? length - 1 : 0;
}

Spectrum padded(const algebra::Grid<double>& picture) {
  const auto length = [](std::size_t n) {
    return quick_length(n + std::max<std::size_t>(32, n / 8));
  };
  Spectrum all(length(picture.rows()), length(picture.columns()));
  for (std::size_t r = 0; r < all.rows(); ++r)
    for (std::size_t c = 0; c < all.columns(); ++c)
      all(r, c) = picture(inside(r, picture.rows(), all.rows()),
                          inside(c, picture.columns(), all.columns()));
  return all;
}

/// Cuts off the padding. Values that rounding took below the picture's minimum are raised to it.
algebra::Grid<double> cut_out(const Spectrum& all, const algebra::Grid<double>& picture) {
  const double count = static_cast<double>(all.rows() * all.columns());
  const double least = *std::ranges::min_element(picture.values());
  algebra::Grid<double> result(picture.rows(), picture.columns());
  for (std::size_t r = 0; r < result.rows(); ++r)
    for (std::size_t c = 0; c < result.columns(); ++c)
      result(r, c) = std::max(least, all(r, c).real() / count);
  return result;
}

void require_sound(const Blur& blur, double pixel_rad) {
  algebra::require_within("aperture [m]", blur.aperture.diameter_m, 1e-5, 100);
  algebra::require_within("obstruction", blur.aperture.obstruction, 0, 0.9);
  if (blur.wavelength_nm != 0)
    algebra::require_within("wavelength [nm]", blur.wavelength_nm, 100, 1e5);
  algebra::require_within("seeing [rad]", blur.seeing_rad, 0, 1e-2);
  algebra::require_within("pixel [rad]", pixel_rad, 1e-12, 1);
}

}  // namespace

double diffraction_spread_per_sr(const Aperture& aperture, double wavelength_nm, double angle_rad) {
  const double diameter = aperture.diameter_m / (wavelength_nm * 1e-9),  // diameter in wavelengths
      x = pi * diameter * angle_rad, epsilon = aperture.obstruction, open = 1 - epsilon * epsilon;
  const double amplitude = (jinc(x) - epsilon * epsilon * jinc(epsilon * x)) / open;
  return pi / 4 * diameter * diameter * open * amplitude * amplitude;
}

double seeing_transfer(double cycles_per_rad, double width_rad) {
  return std::exp(-3.44 * std::pow(cycles_per_rad * width_rad / 0.976, 5. / 3));
}

algebra::Grid<double> blurred(const algebra::Grid<double>& picture, const Blur& blur,
                              double pixel_rad) {
  require_sound(blur, pixel_rad);
  constexpr double unseen = 32;  // diffraction is invisible in pixels this wide or wider [λ/D]
  const bool diffracts = blur.wavelength_nm != 0 && spreads_a_pixel(blur, pixel_rad) < unseen;
  const double seeing_px = blur.seeing_rad / pixel_rad;
  const bool seethes = seeing_px >= least_seeing_px;
  if (picture.empty() || (!diffracts && !seethes)) return picture;
  auto all = padded(picture);
  fourier_transform(all, Direction::forward);
  if (diffracts) {
    const auto transfer = diffraction_transfer(blur, pixel_rad, all.rows(), all.columns());
    for (std::size_t i = 0; i < all.values().size(); ++i)
      all.values()[i] *= transfer.values()[i].real();
  }
  if (seethes) multiply_by_seeing(all, seeing_px);
  fourier_transform(all, Direction::back);
  return cut_out(all, picture);
}

}  // namespace coppermoon::colour
