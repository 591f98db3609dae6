// SPDX-License-Identifier: MIT
#include "colour/limb.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <numbers>
#include <span>
#include <vector>

#include "algebra/error.h"
#include "algebra/random.h"
#include "colour/similarity.h"

namespace coppermoon::colour {
namespace {

using Luminance = algebra::Grid<float>;

constexpr double least_radius_px = 6;

void require_luminance(const Luminance& image) {
  algebra::require_within("width of a picture [pixels]", static_cast<double>(image.columns()), 16,
                          65535);
  algebra::require_within("height of a picture [pixels]", static_cast<double>(image.rows()), 16,
                          65535);
  for (const float value : image.values())
    if (!std::isfinite(value)) throw algebra::Error("luminance that is not finite, allowed finite");
}

double quantile(std::vector<double> values, double share) {
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

/// What is seen where the Moon is not.
struct Sky {
  double level, noise;
};

/// From the darker half of the pixels; noise from how each differs from its neighbours.
Sky sky_of(const Luminance& image) {
  std::vector<double> all(image.values().begin(), image.values().end());
  const double dark = quantile(all, 0.4);
  std::vector<double> rough;
  for (std::size_t r = 1; r + 1 < image.rows(); ++r)
    for (std::size_t c = 1; c + 1 < image.columns(); ++c)
      if (image(r, c) <= dark)
        rough.push_back(std::abs(image(r, c) - 0.25 * (image(r - 1, c) + image(r + 1, c) +
                                                       image(r, c - 1) + image(r, c + 1))));
  constexpr double sigma_of_median = 1.4826, of_difference = 1.118;  // √(1 + 4/16)
  const double noise = rough.empty() ? 0 : sigma_of_median / of_difference * quantile(rough, 0.5);
  return {quantile(std::move(all), 0.2), noise};
}

/// Straight near the sky's noise, logarithmic above.
Luminance toned(Luminance image) {
  const auto sky = sky_of(image);
  const double most = *std::ranges::max_element(image.values());
  const double floor = std::max({3 * sky.noise, 2e-4 * (most - sky.level), 1e-30});
  for (float& value : image.values())
    value = static_cast<float>(std::asinh((double{value} - sky.level) / floor));
  return image;
}

/// Weights 1, 2, 1 both ways, twice.
Luminance softened(const Luminance& image) {
  Luminance soft = image;
  for (int pass = 0; pass < 2; ++pass) {
    const Luminance from = soft;
    for (std::size_t r = 1; r + 1 < image.rows(); ++r)
      for (std::size_t c = 1; c + 1 < image.columns(); ++c) {
        const auto line = [&](std::size_t row) {
          return from(row, c - 1) + 2 * from(row, c) + from(row, c + 1);
        };
        soft(r, c) = (line(r - 1) + 2 * line(r) + line(r + 1)) / 16;
      }
  }
  return soft;
}

/// A place where light changes most, and towards where it grows.
struct Edge {
  glm::dvec2 at, inward;
};

glm::dvec2 slope(const Luminance& image, std::size_t r, std::size_t c) {
  return {0.5 * (image(r, c + 1) - image(r, c - 1)), 0.5 * (image(r + 1, c) - image(r - 1, c))};
}

/// Pixels whose slope is the steepest across the edge.
std::vector<Edge> edges_of(const Luminance& image) {
  Luminance steepness(image.rows(), image.columns());
  for (std::size_t r = 3; r + 3 < image.rows(); ++r)
    for (std::size_t c = 3; c + 3 < image.columns(); ++c)
      steepness(r, c) = static_cast<float>(glm::length(slope(image, r, c)));
  const double least = std::max(0.1 * *std::ranges::max_element(steepness.values()), 0.2);
  std::vector<Edge> edges;
  for (std::size_t r = 3; r + 3 < image.rows(); ++r)
    for (std::size_t c = 3; c + 3 < image.columns(); ++c) {
      const double here = steepness(r, c);
      if (here < least) continue;
      const glm::dvec2 inward = slope(image, r, c) / here;
      const glm::dvec2 at(static_cast<double>(c) + 0.5, static_cast<double>(r) + 0.5);
      const double before = between_pixels(steepness, at - inward),
                   behind = between_pixels(steepness, at + inward);
      if (here < before || here <= behind) continue;
      edges.push_back(
          {at + 0.5 * (behind - before) / (2 * here - before - behind) * inward, inward});
    }
  return edges;
}

std::optional<Disc> circle_through(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  const glm::dvec2 u = b - a, v = c - a;
  const double twice_area = 2 * (u.x * v.y - u.y * v.x);
  if (std::abs(twice_area) < 1e-6) return std::nullopt;
  const double uu = glm::dot(u, u), vv = glm::dot(v, v);
  const glm::dvec2 centre((v.y * uu - u.y * vv) / twice_area, (u.x * vv - v.x * uu) / twice_area);
  return Disc{a.x + centre.x, a.y + centre.y, glm::length(centre)};
}

bool lies_on(const Edge& edge, const Disc& disc) {
  constexpr double aside_px = 1.5, least_cosine = 0.85;
  const glm::dvec2 outward = edge.at - glm::dvec2(disc.x_px, disc.y_px);
  const double away = glm::length(outward);
  return std::abs(away - disc.radius_px) < aside_px &&
         -glm::dot(outward, edge.inward) > least_cosine * away;
}

/// The circle that most edges lie on, of so many through three random ones.
std::optional<Disc> voted(const std::vector<Edge>& edges, double most_radius_px) {
  constexpr int ballots = 3000;
  constexpr double most_edges = 1500;
  if (edges.size() < 12) return std::nullopt;
  algebra::Random random(1, 0);
  const auto any = [&] {
    return edges[static_cast<std::size_t>(random.uniform() * static_cast<double>(edges.size()))];
  };
  std::vector<Edge> voters;
  const double share = most_edges / static_cast<double>(edges.size());
  for (const auto& edge : edges)
    if (random.uniform() < share) voters.push_back(edge);
  std::optional<Disc> best;
  std::ptrdiff_t most = 0;
  for (int ballot = 0; ballot < ballots; ++ballot) {
    const std::array three{any(), any(), any()};
    const auto disc = circle_through(three[0].at, three[1].at, three[2].at);
    if (!disc || disc->radius_px < least_radius_px || disc->radius_px > most_radius_px ||
        !std::ranges::all_of(three, [&](const Edge& edge) { return lies_on(edge, *disc); }))
      continue;
    const auto votes =
        std::ranges::count_if(voters, [&](const Edge& edge) { return lies_on(edge, *disc); });
    if (votes <= most) continue;
    most = votes;
    best = disc;
  }
  return best;
}

/// Where the limb is found along a radius.
struct LimbPlace {
  glm::dvec2 outward;
  double offset_px;  ///< outward from the circle tried
  double weight;
};

/// Light along a radius, the mean over a little of the limb to both sides.
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

/// A picture, and the light of what is clipped in it.
struct Picture {
  const Luminance& image;
  double clipped;
};

/// The step of light at the limb: as much light as there is fills it so far from within.
std::optional<LimbPlace> limb_place(const Picture& picture, const Disc& disc, double angle,
                                    double half_width_px) {
  constexpr double clearly = 4, of_clipped = 0.1;
  const auto light = profile(picture.image, disc, angle, half_width_px);
  if (light.empty()) return std::nullopt;
  const std::span all(light);
  const auto inside = spread_of(all.first(all.size() / 4)),
             outside = spread_of(all.last(all.size() / 4));
  const double step = inside.mean - outside.mean;
  if (!(step > clearly * std::hypot(inside.error, outside.error)) || step <= 0) return std::nullopt;
  const double filled = (spread_of(all).mean - outside.mean) / step;
  const bool clipped = inside.mean > picture.clipped;
  return LimbPlace{{std::cos(angle), std::sin(angle)},
                   half_width_px * std::clamp(2 * filled - 1, -1., 1.),
                   clipped ? of_clipped : 1};
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

/// What moves the circle onto the places: x, y and radius, by least squares whose weights leave out
/// what lies far off (Tukey's).
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

bool is_a_limb(const std::vector<LimbPlace>& places, const Disc& disc) {
  const double near_px = std::max(1.5, 0.02 * disc.radius_px);
  const auto on_it = std::ranges::count_if(
      places, [&](const LimbPlace& place) { return std::abs(place.offset_px) < near_px; });
  return on_it >= 90 && 4 * on_it >= 3 * static_cast<std::ptrdiff_t>(places.size());
}

/// The circle on the limb, measured again and again along narrower pieces of the radii.
std::optional<Disc> measured(const Luminance& image, Disc disc, double unsure_px) {
  const Picture picture{image, 0.98 * *std::ranges::max_element(image.values())};
  std::vector<LimbPlace> places;
  for (const double share : {0.08, 0.06, 0.05, 0.05, 0.05}) {
    const double half_width_px =
        std::max({4., share * disc.radius_px, share > 0.05 ? 3 * unsure_px : 0.});
    places = limb_places(picture, disc, half_width_px);
    if (places.size() < 45) return std::nullopt;
    const auto shift = shift_onto(places);
    disc = {disc.x_px + shift.x, disc.y_px + shift.y, disc.radius_px + shift.z};
    if (!(disc.radius_px >= least_radius_px)) return std::nullopt;
    for (auto& place : places) place.offset_px = residual(place, shift);
  }
  return is_a_limb(places, disc) ? std::optional(disc) : std::nullopt;
}

}  // namespace

std::optional<Disc> limb_of(const Luminance& luminance) {
  require_luminance(luminance);
  constexpr double longest_px = 400;
  const double longest = static_cast<double>(std::max(luminance.rows(), luminance.columns()));
  const double shrink = std::min(1., longest_px / longest);
  const auto sized = [&](std::size_t n) {
    return static_cast<std::size_t>(std::ceil(shrink * static_cast<double>(n)));
  };
  const auto small =
      resampled(luminance, {.scale = shrink}, sized(luminance.rows()), sized(luminance.columns()));
  const auto disc = voted(edges_of(softened(toned(small))), longest_px);
  if (!disc) return std::nullopt;
  return measured(luminance, {disc->x_px / shrink, disc->y_px / shrink, disc->radius_px / shrink},
                  1 / shrink);
}

}  // namespace coppermoon::colour
