// SPDX-License-Identifier: MIT
#include "colour/circles.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>

#include "algebra/random.h"
#include "colour/quantile.h"
#include "colour/similarity.h"

namespace coppermoon::colour {
namespace {

using Picture = algebra::Grid<float>;

constexpr double least_circle_px = 5;

/// Maps light to an asinh scale: linear up to `floor_share` of the range from the sky to the maximum, then logarithmic.
Picture toned(Picture image, double floor_share) {
  const double sky = quantile<float>({image.values().begin(), image.values().end()}, 0.2),
               range = *std::ranges::max_element(image.values()) - sky;
  if (range <= 0) return Picture(image.rows(), image.columns());
  for (float& value : image.values())
    value = static_cast<float>(std::asinh((double{value} - sky) / (floor_share * range)));
  return image;
}

/// Smooths a picture twice with the binomial filter 1 2 1 along both axes.
Picture softened(const Picture& image) {
  Picture soft = image;
  for (int pass = 0; pass < 2; ++pass) {
    const Picture from = soft;
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

/// An edge pixel: its sub-pixel position and the direction in which light increases.
struct Edge {
  glm::dvec2 at, inward;
};

glm::dvec2 slope(const Picture& image, std::size_t r, std::size_t c) {
  return {0.5 * (image(r, c + 1) - image(r, c - 1)), 0.5 * (image(r + 1, c) - image(r - 1, c))};
}

/// Finds edge pixels, whose gradient is among the picture's steeper ones and has a maximum along its own direction.
std::vector<Edge> edges_of(const Picture& image) {
  constexpr double of_steepest = 0.1, of_median = 3.5;
  Picture steepness(image.rows(), image.columns());
  for (std::size_t r = 3; r + 3 < image.rows(); ++r)
    for (std::size_t c = 3; c + 3 < image.columns(); ++c)
      steepness(r, c) = static_cast<float>(glm::length(slope(image, r, c)));
  const std::vector<float> all(steepness.values().begin(), steepness.values().end());
  const double steepest = *std::ranges::max_element(all), usual = quantile(all, 0.5);
  if (steepest <= 0) return {};
  const double least =
      std::max(of_steepest * steepest, std::min(of_median * usual, 0.5 * steepest));
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
  constexpr double least_cosine = 0.85;
  const double aside_px = std::clamp(0.05 * disc.radius_px, 0.75, 1.5);
  const glm::dvec2 outward = edge.at - glm::dvec2(disc.x_px, disc.y_px);
  const double away = glm::length(outward);
  return std::abs(away - disc.radius_px) < aside_px &&
         -glm::dot(outward, edge.inward) > least_cosine * away;
}

/// Number of a circle's five-degree sectors, 72 in all, in which an edge lies on the circle.
std::size_t covered(const std::vector<Edge>& edges, const Disc& disc) {
  constexpr std::size_t steps = 72;
  std::bitset<steps> has;
  for (const auto& edge : edges)
    if (lies_on(edge, disc)) {
      const double turn =
          std::atan2(edge.at.y - disc.y_px, edge.at.x - disc.x_px) / (2 * std::numbers::pi);
      has.set(static_cast<std::size_t>((turn + 1) * steps) % steps);
    }
  return has.count();
}

/// The best of many circles through three random edges: the one with edges along most of its length (RANSAC).
std::optional<Disc> voted(const std::vector<Edge>& edges, double most_radius_px) {
  constexpr int ballots = 20000, counts = 600;
  if (edges.size() < 12) return std::nullopt;
  algebra::Random random(1, 0);
  const auto any = [&] {
    return edges[static_cast<std::size_t>(random.uniform() * static_cast<double>(edges.size()))];
  };
  std::optional<Disc> best;
  std::size_t most = 0;
  int counted = 0;
  for (int ballot = 0; ballot < ballots && counted < counts; ++ballot) {
    const std::array three{any(), any(), any()};
    const auto disc = circle_through(three[0].at, three[1].at, three[2].at);
    if (!disc || disc->radius_px < least_circle_px || disc->radius_px > most_radius_px ||
        !std::ranges::all_of(three, [&](const Edge& edge) { return lies_on(edge, *disc); }))
      continue;
    ++counted;
    const auto votes = covered(edges, *disc);
    if (votes <= most) continue;
    most = votes;
    best = disc;
  }
  return best;
}

}  // namespace

std::vector<Disc> likely_circles(const Picture& image) {
  std::vector<Disc> circles;
  const double most_radius_px = static_cast<double>(std::max(image.rows(), image.columns()));
  for (const double floor_share : {3e-4, 3e-3, 3e-2, 0.3})
    if (const auto disc = voted(edges_of(softened(toned(image, floor_share))), most_radius_px))
      circles.push_back(*disc);
  return circles;
}

}  // namespace coppermoon::colour
