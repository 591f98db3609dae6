// SPDX-License-Identifier: MIT
#include "colour/similarity.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "algebra/error.h"

namespace coppermoon::colour {
namespace {

/// Applies a similarity's mirroring, rotation and scale to a vector, but not its shift.
glm::dvec2 turned(const Similarity& by, const glm::dvec2& v) {
  const double c = by.scale * std::cos(by.rotation_rad), s = by.scale * std::sin(by.rotation_rad);
  const double x = by.mirrored ? -v.x : v.x;
  return {c * x - s * v.y, s * x + c * v.y};
}

}  // namespace

double between_pixels(const algebra::Grid<float>& image, const glm::dvec2& pixel) {
  const double x = pixel.x - 0.5, y = pixel.y - 0.5;
  const auto rows = static_cast<std::ptrdiff_t>(image.rows()),
             columns = static_cast<std::ptrdiff_t>(image.columns());
  if (!(x > -1 && y > -1 && x < static_cast<double>(columns) && y < static_cast<double>(rows)))
    return 0;
  // A cast rounds towards 0; with 1 added first, it rounds down for all x > −1.
  const auto column = static_cast<std::ptrdiff_t>(x + 1) - 1,
             row = static_cast<std::ptrdiff_t>(y + 1) - 1;
  const double across = x - static_cast<double>(column), down = y - static_cast<double>(row);
  const auto between = [&](double a, double b, double c, double d) {
    const double upper = a + across * (b - a), lower = c + across * (d - c);
    return upper + down * (lower - upper);
  };
  if (row >= 0 && column >= 0 && row + 1 < rows && column + 1 < columns) {
    const float* at = image.values().data() + row * columns + column;
    return between(double{at[0]}, double{at[1]}, double{at[columns]}, double{at[columns + 1]});
  }
  const auto value = [&](std::ptrdiff_t r, std::ptrdiff_t c) {
    const bool inside = r >= 0 && c >= 0 && r < rows && c < columns;
    return inside ? double{image(static_cast<std::size_t>(r), static_cast<std::size_t>(c))} : 0;
  };
  return between(value(row, column), value(row, column + 1), value(row + 1, column),
                 value(row + 1, column + 1));
}

namespace {

/// Overlap of two smoothed triangles Λ∗Λ, shifted by `apart`: ∫ (Λ∗Λ)(x) (Λ∗Λ)(x + apart) dx, the B-spline of order 8.
double overlap(double apart) {
  constexpr std::array binomials{1., -8., 28., -56., 70., -56., 28., -8., 1.};
  constexpr double factorial = 5040;
  double sum = 0;
  for (std::size_t k = 0; k < binomials.size(); ++k)
    sum += binomials[k] * std::pow(std::max(0., 4 - std::abs(apart) - static_cast<double>(k)), 7);
  return sum / factorial;
}

}  // namespace

glm::dvec2 moved(const Similarity& similarity, const glm::dvec2& pixel) {
  return turned(similarity, pixel) + glm::dvec2(similarity.x_px, similarity.y_px);
}

Similarity inverse(const Similarity& similarity) {
  Similarity back{1 / similarity.scale,
                  similarity.mirrored ? similarity.rotation_rad : -similarity.rotation_rad, 0, 0,
                  similarity.mirrored};
  const auto corner = turned(back, {similarity.x_px, similarity.y_px});
  back.x_px = -corner.x;
  back.y_px = -corner.y;
  return back;
}

Similarity composed(const Similarity& first, const Similarity& second) {
  const double turn = second.mirrored ? -first.rotation_rad : first.rotation_rad;
  const auto corner = moved(second, {first.x_px, first.y_px});
  return {first.scale * second.scale, second.rotation_rad + turn, corner.x, corner.y,
          first.mirrored != second.mirrored};
}

Resampled::Resampled(const algebra::Grid<float>& image, const Similarity& similarity)
    : image_(&image) {
  algebra::require_within("scale of a picture", similarity.scale, 1e-4, 1e4);
  const auto back = inverse(similarity);
  corner_ = moved(back, {0, 0});
  across_ = moved(back, {1, 0}) - corner_;
  down_ = moved(back, {0, 1}) - corner_;
  side_ = static_cast<int>(std::ceil(back.scale - 1e-9));
}

float Resampled::at(std::size_t row, std::size_t column) const {
  double sum = 0;
  for (int j = 0; j < side_; ++j)
    for (int i = 0; i < side_; ++i)
      sum += between_pixels(*image_,
                            corner_ + (static_cast<double>(column) + (i + 0.5) / side_) * across_ +
                                (static_cast<double>(row) + (j + 0.5) / side_) * down_);
  return static_cast<float>(sum / (side_ * side_));
}

double noise_of_means(double scale) {
  algebra::require_within("scale of a picture", scale, 1e-4, 1e4);
  constexpr double pair = 2;
  const double points = std::ceil(scale - 1e-9), step = scale / points;
  // ∫ h(x) h(x + apart) dx, where h is the weight along one side of a pixel
  const auto overlap_of_pixels = [&](double apart) {
    double sum = points * overlap(apart);
    for (double k = 1; k < points; ++k)  // pairs of points k steps apart
      sum += (points - k) * (overlap(k * step + apart) + overlap(k * step - apart));
    return sum / points / points;
  };
  const double squares = overlap_of_pixels(0), along = 1 / (scale * squares);
  return along * along / (1 - overlap_of_pixels(pair * scale) / squares);
}

algebra::Grid<float> resampled(const algebra::Grid<float>& image, const Similarity& similarity,
                               std::size_t rows, std::size_t columns) {
  const Resampled pixel(image, similarity);
  algebra::Grid<float> other(rows, columns);
  tbb::parallel_for(std::size_t{0}, rows, [&](std::size_t r) {
    for (std::size_t c = 0; c < columns; ++c) other(r, c) = pixel.at(r, c);
  });
  return other;
}

}  // namespace coppermoon::colour
