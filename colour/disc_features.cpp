// SPDX-License-Identifier: MIT
#include "colour/disc_features.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "colour/quantile.h"

namespace coppermoon::colour {
namespace {

using Values = algebra::Grid<float>;

constexpr double beside = 1.12, margin = 1.3;  // [disc radii]; grids extend to `margin`

double away_from(double x_px, double y_px, std::size_t row, std::size_t column) {
  return std::hypot(static_cast<double>(column) + 0.5 - x_px,
                    static_cast<double>(row) + 0.5 - y_px);
}

/// Values of the pixels in a ring around a disc's centre. Both radii are multiples of the disc's radius.
std::vector<float> values_between(const Values& picture, const Disc& disc, double inner,
                                  double outer) {
  const double reach = outer * disc.radius_px;
  const auto first = [&](double centre) {
    return static_cast<std::size_t>(std::max(0., std::floor(centre - reach)));
  };
  const auto last = [&](double centre, std::size_t count) {
    return std::min(count, static_cast<std::size_t>(std::max(0., std::ceil(centre + reach))));
  };
  std::vector<float> values;
  for (std::size_t r = first(disc.y_px); r < last(disc.y_px, picture.rows()); ++r)
    for (std::size_t c = first(disc.x_px); c < last(disc.x_px, picture.columns()); ++c) {
      const double away = away_from(disc.x_px, disc.y_px, r, c);
      if (away >= inner * disc.radius_px && away < reach) values.push_back(picture(r, c));
    }
  return values;
}

/// Replaces each pixel in a line by the mean over 2 reach + 1 pixels. Pixels beyond the line's ends count as 0.
void blur_line(std::span<float> line, std::size_t stride, std::size_t reach) {
  const std::size_t n = (line.size() + stride - 1) / stride;
  std::vector<double> sums(n + 1);
  for (std::size_t i = 0; i < n; ++i) sums[i + 1] = sums[i] + double{line[i * stride]};
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t begin = i > reach ? i - reach : 0, end = std::min(n, i + reach + 1);
    line[i * stride] =
        static_cast<float>((sums[end] - sums[begin]) / static_cast<double>(2 * reach + 1));
  }
}

/// Blurs a grid with three box filters along each axis, which together are nearly a Gaussian of σ² = reach (reach + 1).
Values blurred(Values grid, std::size_t reach) {
  for (int pass = 0; pass < 3; ++pass) {
    for (std::size_t r = 0; r < grid.rows(); ++r) blur_line(grid.row(r), 1, reach);
    for (std::size_t c = 0; c < grid.columns(); ++c)
      blur_line(grid.values().subspan(c), grid.columns(), reach);
  }
  return grid;
}

/// Makes a grid, as large as `like`, that is 1 at pixels whose row and column pass a test, else 0.
template <class PixelTest>
Values where(const Values& like, const PixelTest& so) {
  Values grid(like.rows(), like.columns());
  for (std::size_t r = 0; r < grid.rows(); ++r)
    for (std::size_t c = 0; c < grid.columns(); ++c) grid(r, c) = so(r, c) ? 1.F : 0.F;
  return grid;
}

/// Mean of the light around each pixel, weighted by `counts`.
Values mean_nearby(const Values& light, const Values& counts, std::size_t reach) {
  Values weighted = light;
  for (std::size_t i = 0; i < light.values().size(); ++i)
    weighted.values()[i] *= counts.values()[i];
  auto mean = blurred(std::move(weighted), reach);
  const auto share = blurred(counts, reach);
  for (std::size_t i = 0; i < mean.values().size(); ++i)
    mean.values()[i] /= std::max(share.values()[i], 1e-6F);
  return mean;
}

/// Standard deviation of the noise in the sky beside a disc, from the median difference between diagonal neighbours.
double noise_of(const Values& light, const Disc& disc) {
  Values rough(light.rows(), light.columns());
  for (std::size_t r = 1; r < light.rows(); ++r)
    for (std::size_t c = 1; c < light.columns(); ++c)
      rough(r, c) = std::abs(light(r, c) - light(r - 1, c - 1));
  constexpr double sigma_of_median = 1.0484;  // σ of a pixel / median |difference of two pixels|
  return sigma_of_median * double{quantile(values_between(rough, disc, beside, margin), 0.5)};
}

float brightest_of(const Values& picture, const Disc& disc, double share) {
  return quantile(values_between(picture, disc, 0, 1), 1 - share);
}

/// A picture with the disc in the middle of the grid and the light of the sky subtracted.
struct Centred {
  Disc disc;
  Values light, usable;  ///< `usable` is 1 inside the picture, else 0
  float too_bright;      ///< light level at which pixels are clipped
};

Centred centred(const Values& picture, const Disc& disc, const Similarity& to_grid,
                const Disc& there, double clipped) {
  const auto side = static_cast<std::size_t>(2 * there.x_px);
  const float cap = brightest_of(picture, disc, clipped);
  Values capped = picture;
  if (clipped > 0)
    for (float& value : capped.values()) value = std::min(value, cap);
  auto light = resampled(capped, to_grid, side, side);
  const auto reached = resampled(Values(picture.rows(), picture.columns(), 1), to_grid, side, side);
  const float sky = quantile(values_between(light, there, beside, margin), 0.5);
  for (float& value : light.values()) value -= sky;
  return {there, std::move(light),
          where(reached, [&](std::size_t r, std::size_t c) { return reached(r, c) > 0.999F; }),
          cap - sky};
}

/// A grid that is above 0 at clipped pixels and their neighbours, else 0.
Values clipped_in(const Centred& picture) {
  return blurred(where(picture.light,
                       [&](std::size_t r, std::size_t c) {
                         return picture.light(r, c) > 0.99F * picture.too_bright;
                       }),
                 1);
}

/// Weights of pixels: 0 outside the picture and at a clipped limb, which blur moves outward. If the clipped area ends
/// at a shadow's edge (`deeply`), the weight is 0 at all clipped pixels.
Values weights_of(const Centred& picture, bool deeply) {
  constexpr double inner = 0.92;  // as a share of the disc's radius
  const auto& disc = picture.disc;
  const auto clipped = clipped_in(picture);
  return where(picture.light, [&](std::size_t r, std::size_t c) {
    const bool tells_nothing =
        deeply || away_from(disc.x_px, disc.y_px, r, c) > inner * disc.radius_px;
    return picture.usable(r, c) > 0 && !(tells_nothing && clipped(r, c) > 0);
  });
}

/// Mean light around each disc pixel. Pixels of weight 0 are skipped if clipping ends at a shadow's edge (`deeply`).
Values light_nearby(const Centred& picture, const Values& weights, bool deeply) {
  constexpr double edge = 0.97, reach = 0.25;  // as shares of the disc's radius
  const auto& disc = picture.disc;
  const auto& counts = deeply ? weights : picture.usable;
  const auto on_disc = where(picture.light, [&](std::size_t r, std::size_t c) {
    return counts(r, c) > 0 && away_from(disc.x_px, disc.y_px, r, c) < edge * disc.radius_px;
  });
  return mean_nearby(picture.light, on_disc,
                     static_cast<std::size_t>(std::max(2., std::round(reach * disc.radius_px))));
}

}  // namespace

double clipped_share(const Values& picture, const Disc& disc) {
  const float least = 0.99F * *std::ranges::max_element(picture.values());
  const auto values = values_between(picture, disc, 0, 1);
  if (values.empty()) return 0;
  return static_cast<double>(std::ranges::count_if(values, [&](float v) { return v >= least; })) /
         static_cast<double>(values.size());
}

bool is_deep(const Values& picture, const Disc& disc, double clipped) {
  constexpr float deep = 4;
  return brightest_of(picture, disc, 0.01) > deep * brightest_of(picture, disc, clipped);
}

DiscFeatures features_of(const Values& picture, const Disc& disc, double radius_px,
                         const TonalRange& range) {
  constexpr double sigmas = 3, least = 1e-6;
  const double middle = std::ceil(margin * radius_px), scale = radius_px / disc.radius_px;
  const Similarity to_grid{scale, 0, middle - scale * disc.x_px, middle - scale * disc.y_px};
  const auto here = centred(picture, disc, to_grid, {middle, middle, radius_px}, range.clipped);
  const double bright = std::max(double{brightest_of(here.light, here.disc, 0.01)}, 1e-30);
  const double floor =
      std::max({sigmas * noise_of(here.light, here.disc) / bright, least, range.floor});
  DiscFeatures made{mean_nearby(here.light, here.usable, 1), weights_of(here, range.deeply),
                    to_grid, floor};
  const auto nearby = light_nearby(here, made.weight, range.deeply);
  for (std::size_t i = 0; i < nearby.values().size(); ++i) {
    const double level = std::max(double{nearby.values()[i]}, 0.);
    const double share = level / (level + floor * bright);
    float &contrast = made.contrast.values()[i], &weight = made.weight.values()[i];
    contrast = static_cast<float>(std::clamp(contrast / (level + floor * bright) - 1, -1.5, 3.));
    weight *= static_cast<float>(share * share);
  }
  return made;
}

}  // namespace coppermoon::colour
