// SPDX-License-Identifier: MIT
#include "colour/moon_limb.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <numbers>
#include <numeric>
#include <span>
#include <vector>

#include "algebra/error.h"
#include "colour/circles.h"
#include "colour/picture_part.h"
#include "colour/quantile.h"
#include "colour/similarity.h"

namespace coppermoon::colour {
namespace {

using Luminance = algebra::Grid<float>;

constexpr double least_radius_px = 6;

void require_luminance(const Luminance& image) {
  algebra::require_within("width of a picture [pixels]", static_cast<double>(image.columns()),
                          least_side_px, most_side_px);
  algebra::require_within("height of a picture [pixels]", static_cast<double>(image.rows()),
                          least_side_px, most_side_px);
  tbb::parallel_for(std::size_t{0}, image.rows(), [&](std::size_t r) {
    for (const float value : image.row(r))
      if (!std::isfinite(value))
        throw algebra::Error("luminance that is not finite, allowed finite");
  });
}

/// A point of the limb, found along a radius.
struct LimbPlace {
  glm::dvec2 outward;
  double offset_px;  ///< distance outward from the trial circle
  double weight;     ///< weight in the fit of the circle
  double seen;       ///< square root of the drop in light at the limb
};

/// Light along part of a radius, averaged over 2/3 degree in angle. Empty if that part leaves the picture.
std::vector<double> profile(const Luminance& image, const Disc& disc, double angle,
                            double half_width_px) {
  constexpr int steps = 32;
  std::vector<double> light;
  for (int i = 0; i < steps; ++i) {
    const double radius = disc.radius_px + half_width_px * ((2 * i + 1.) / steps - 1);
    double sum = 0;
    for (const double aside : {-1. / 3, 0., 1. / 3}) {
      const double turn = angle + aside * std::numbers::pi / 180;
      const glm::dvec2 at(disc.x_px + radius * std::cos(turn), disc.y_px + radius * std::sin(turn));
      if (at.x < 0.5 || at.y < 0.5 || at.x > static_cast<double>(image.columns()) - 0.5 ||
          at.y > static_cast<double>(image.rows()) - 0.5)
        return {};
      sum += between_pixels(image, at) / 3;
    }
    light.push_back(sum);
  }
  return light;
}

struct Spread {
  double mean, error;
};

Spread spread_of(std::span<const double> values) {
  const double n = static_cast<double>(values.size());
  double mean = 0, squares = 0;
  for (const double v : values) mean += v / n;
  for (const double v : values) squares += (v - mean) * (v - mean) / n;
  return {mean, std::sqrt(squares) / n};
}

/// A picture and the light level above which it is clipped.
struct Picture {
  const Luminance& image;
  double clipped;
};

/// The outer part of a light profile, from the inner end of its brightest stretch (above three quarters of the
/// maximum). Light further in is left out, because a thin crescent may end there.
std::span<const double> ground_and_sky(std::span<const double> light) {
  constexpr double of_brightest = 0.75;
  const auto quarter = light.size() / 4;
  const auto ground = light.first(light.size() - quarter);
  const double sky = spread_of(light.last(quarter)).mean;
  auto begin = std::ranges::max_element(ground);
  const double least = sky + of_brightest * (*begin - sky);
  while (begin != ground.begin() && *(begin - 1) > least) --begin;
  return light.subspan(static_cast<std::size_t>(begin - ground.begin()));
}

/// Locates the limb on a radius, where a sharp edge would have the same area under its light profile as the real edge.
std::optional<LimbPlace> limb_place(const Picture& picture, const Disc& disc, double angle,
                                    double half_width_px) {
  constexpr double clearly = 4, of_clipped = 0.3;
  const auto light = profile(picture.image, disc, angle, half_width_px);
  if (light.empty()) return std::nullopt;
  const auto all = ground_and_sky(light);
  const double inner_px =
      half_width_px * (1 - 2 * static_cast<double>(all.size()) / static_cast<double>(light.size()));
  const auto inside = spread_of(all.first(all.size() / 4)),
             outside = spread_of(all.last(all.size() / 4));
  const double step = inside.mean - outside.mean;
  if (!(step > clearly * std::hypot(inside.error, outside.error)) || step <= 0) return std::nullopt;
  const double filled = (spread_of(all).mean - outside.mean) / step;
  const bool clipped = inside.mean > picture.clipped;
  return LimbPlace{
      {std::cos(angle), std::sin(angle)},
      std::clamp(inner_px + filled * (half_width_px - inner_px), -half_width_px, half_width_px),
      clipped ? of_clipped : 1,
      std::sqrt(step)};
}

std::vector<LimbPlace> limb_places(const Picture& picture, const Disc& disc, double half_width_px) {
  std::vector<LimbPlace> places;
  for (int degree = 0; degree < 360; ++degree)
    if (const auto place =
            limb_place(picture, disc, degree * std::numbers::pi / 180, half_width_px))
      places.push_back(*place);
  return places;
}

double residual(const LimbPlace& place, const glm::dvec3& shift) {
  return place.offset_px - glm::dot(place.outward, glm::dvec2(shift)) - shift.z;
}

/// Correction to a circle's x, y and radius, fitted to points of the limb by least squares with Tukey's biweight.
glm::dvec3 shift_onto(const std::vector<LimbPlace>& places) {
  glm::dvec3 shift(0);
  for (int pass = 0; pass < 12; ++pass) {
    std::vector<double> off;
    for (const auto& place : places) off.push_back(std::abs(residual(place, shift)));
    const double wide = 4.685 * std::max(1.4826 * quantile(off, 0.5), 0.05);
    glm::dmat3 normal(1e-9);
    glm::dvec3 right(0);
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (off[i] >= wide) continue;
      const double inner = 1 - off[i] * off[i] / (wide * wide);
      const double weight = places[i].weight * inner * inner;
      const glm::dvec3 row(places[i].outward, 1);
      normal += weight * glm::outerProduct(row, row);
      right += weight * places[i].offset_px * row;
    }
    shift = glm::inverse(normal) * right;
  }
  return shift;
}

/// A circle and the strength of the evidence that it is the Moon's limb.
struct Found {
  Disc disc;
  double evidence;
};

/// Evidence that a circle is a limb: the sum of the square roots of the drops in light along it, times its radius. It
/// is 0 if less than a quarter of the circle is limb, or if more than a quarter of these drops are off the circle.
double evidence_of(const std::vector<LimbPlace>& places, const Disc& disc) {
  const double near_px = std::max(0.7, 0.03 * disc.radius_px);
  int degrees = 0;
  double on_it = 0, all = 0, evidence = 0;
  for (const auto& place : places) {
    all += place.seen * place.seen;
    const double off = place.offset_px / near_px;
    if (std::abs(off) >= 1) continue;
    ++degrees;
    on_it += place.seen * place.seen;
    evidence += place.seen * (1 - off * off);
  }
  return degrees >= 85 && on_it >= 0.75 * all ? disc.radius_px * evidence : 0;
}

/// Fits a circle to the limb in five passes. Later passes search shorter parts of the radii.
Found measured(const Picture& picture, Disc disc, double last_share) {
  std::vector<LimbPlace> places;
  for (const double wider : {1.6, 1.2, 1., 1., 1.}) {
    const double half_width_px = std::max(2., wider * last_share * disc.radius_px);
    places = limb_places(picture, disc, half_width_px);
    if (places.size() < 45) return {disc, 0};
    const auto shift = shift_onto(places);
    disc = {disc.x_px + shift.x, disc.y_px + shift.y, disc.radius_px + shift.z};
    if (!(disc.radius_px >= least_radius_px)) return {disc, 0};
    for (auto& place : places) place.offset_px = residual(place, shift);
  }
  return {disc, evidence_of(places, disc)};
}

/// Unevenness of the sky beside a disc, relative to the drop in light from disc to sky. It is the sum of the sky's
/// changes along radii and its differences from the 20th percentile of the sky. A value above 0.5 means that the edge
/// goes on beyond the circle (corner, horizon) or that light falls steadily. It is infinite if no contrast is visible.
double unevenness(const Luminance& image, const Disc& disc) {
  constexpr double band = 0.1;
  const double wide_px = std::max(2., band * disc.radius_px);
  double uneven = 0, limb = 0;
  std::vector<double> beyond;
  for (int degree = 0; degree < 360; ++degree) {
    const auto light = profile(image, disc, degree * std::numbers::pi / 180, 2 * wide_px);
    if (light.empty()) continue;
    const std::span all(light);
    const auto mean = [&](std::size_t quarter) {
      return spread_of(all.subspan(quarter * all.size() / 4, all.size() / 4)).mean;
    };
    uneven += std::abs(mean(2) - mean(3));
    limb += std::max(0., std::max(mean(0), mean(1)) - mean(2));
    beyond.push_back(mean(3));
  }
  constexpr double least_contrast = 0.02;  // below the contrast of four 8-bit sRGB steps (0.036+)
  const double sky = std::reduce(beyond.begin(), beyond.end());
  if (limb <= 0 || limb < least_contrast * sky) return std::numeric_limits<double>::infinity();
  const double dark = quantile(beyond, 0.2);
  for (const double light : beyond) uneven += std::abs(light - dark);
  return uneven / limb;
}

/// Share of the drops in light near a disc's edge that lie on the edge itself.
double roundness(const Picture& picture, const Disc& disc) {
  const double near_px = std::max(0.6, 0.05 * disc.radius_px);
  double on_it = 0, all = 0;
  for (const auto& place : limb_places(picture, disc, std::max(3., 0.25 * disc.radius_px))) {
    all += place.seen * place.seen;
    if (std::abs(place.offset_px) < near_px) on_it += place.seen * place.seen;
  }
  return all > 0 ? on_it / all : 0;
}

/// Whether a disc is round and surrounded by an even sky.
bool stands_alone(const Picture& picture, const Disc& disc) {
  return unevenness(picture.image, disc) <= 0.5 && roundness(picture, disc) >= 0.75;
}

bool alike(const Disc& a, const Disc& b) {
  const double near_px = std::max(0.5, 0.01 * a.radius_px);
  return std::hypot(a.x_px - b.x_px, a.y_px - b.y_px) < near_px &&
         std::abs(a.radius_px - b.radius_px) < near_px;
}

/// Of the likely circles in a picture, the one with the strongest evidence.
Found found_in(const Luminance& image) {
  const Picture picture{image, 0.98 * *std::ranges::max_element(image.values())};
  std::vector<Disc> tried;
  Found best{{}, 0};
  for (const auto& circle : likely_circles(image)) {
    if (std::ranges::any_of(tried, [&](const Disc& disc) { return alike(disc, circle); })) continue;
    tried.push_back(circle);
    const auto found = measured(picture, circle, 0.1);
    if (found.evidence > best.evidence && stands_alone(picture, found.disc)) best = found;
  }
  if (best.evidence > 0)
    for (const double share : {0.05, 0.2}) {
      const auto found = measured(picture, best.disc, share);
      if (found.evidence > best.evidence && stands_alone(picture, found.disc)) best = found;
    }
  return best;
}

std::size_t reduction_of(std::size_t rows, std::size_t columns) {
  constexpr std::size_t longest_px = 400;
  return (std::max(rows, columns) + longest_px - 1) / longest_px;
}

/// The best circle in part of a picture, which is binned to at most 400 pixels, and further if noise hides the limb.
Found found_within(const Luminance& image, const PicturePart& part) {
  constexpr double least_reduced_px = 20;  // a square smaller than this could pass for a disc
  std::size_t by = reduction_of(part.rows, part.columns);
  for (int level = 0; level < 3; ++level, by *= 2) {
    if (std::min(part.rows, part.columns) < 16 * by) break;
    const double scale = static_cast<double>(by);
    const auto [disc, evidence] = found_in(reduced(image, part, by));
    if (evidence > 0 && (level == 0 || disc.radius_px > least_reduced_px))
      return {{static_cast<double>(part.left) + scale * disc.x_px,
               static_cast<double>(part.top) + scale * disc.y_px, scale * disc.radius_px},
              evidence};
  }
  return {{}, 0};
}

/// The part of a picture around its brightest place, where a small Moon may be.
PicturePart about_the_brightest(const Luminance& image) {
  constexpr std::size_t mean_over = 4, reach = 8;
  const auto by = mean_over * reduction_of(image.rows(), image.columns());
  const auto small = reduced(image, {0, 0, image.columns(), image.rows()}, by);
  if (small.empty()) return {0, 0, 0, 0};
  const auto at =
      static_cast<std::size_t>(std::ranges::max_element(small.values()) - small.values().begin());
  const double scale = static_cast<double>(by);
  return window_about({scale * (static_cast<double>(at % small.columns()) + 0.5),
                       scale * (static_cast<double>(at / small.columns()) + 0.5), reach * scale},
                      image.rows(), image.columns());
}

}  // namespace

std::optional<Disc> limb_of(const Luminance& luminance) {
  require_luminance(luminance);
  constexpr double margin = 1.6;
  PicturePart window{0, 0, luminance.columns(), luminance.rows()};
  auto found = found_within(luminance, window);
  if (found.evidence == 0) {
    window = about_the_brightest(luminance);
    found = found_within(luminance, window);
  }
  if (found.evidence == 0) return std::nullopt;
  const auto& [x, y, radius] = found.disc;
  const auto close = window_about({x, y, margin * radius}, luminance.rows(), luminance.columns());
  if (reduction_of(close.rows, close.columns) < reduction_of(window.rows, window.columns))
    if (const auto again = found_within(luminance, close); again.evidence > 0) return again.disc;
  return found.disc;
}

}  // namespace coppermoon::colour
