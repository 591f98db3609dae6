// SPDX-License-Identifier: MIT
#include "uses/shader/light_strip.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "eclipse/shadow_axis.h"
#include "uses/light/shadow_profile.h"
#include "uses/light/spectral_bands.h"

namespace coppermoon::uses {
namespace {

/// Numbers of columns in the strip's four stretches: deep in the umbra, around the edge where direct sunlight begins,
/// just outside it, and farther out. Where light changes steeply, there are up to `most_times` times as many.
constexpr std::array fewest_stretches{180, 240, 80, 90};
constexpr int most_times = 4;

/// Limits on interpolation errors, relative to the brightest channel. If any error exceeds `good_enough`, the number of
/// rows is doubled if the error between rows exceeds `between_nodes`. The columns of each stretch are treated likewise.
constexpr double good_enough = 6e-3, between_nodes = 4e-3;

constexpr double rounding =
    5e-4;  ///< relative error of light whose square root is stored as a half float
constexpr int usual_bands = 100;

/// Distances from the edge where direct sunlight begins to the ends of the strip's stretches [m]. Around the Earth, the
/// edge's own distance from the axis varies by less than 30 km.
constexpr double before_m = 320e3, about_m = 60e3, behind_m = 480e3;

/// Axis distances for refracted light [m], denser around the umbra's edge, where light refracted high in the air ends.
std::vector<double> distances_to(double reach_m, double begins_m) {
  constexpr double spacing_m = 25e3, close_m = 5e3, from_m = 450e3;
  std::vector<double> distances{0};
  while (distances.back() < reach_m)
    distances.push_back(distances.back() +
                        (distances.back() < begins_m - from_m ? spacing_m : close_m));
  return distances;
}

using Colour = std::array<double, 3>;

/// Largest error of any channel, relative to the brightest channel of the exact light. It is 0 if that light is black.
double error_of(const Colour& found, const Colour& exact) {
  const double brightest = std::ranges::max(exact);
  if (brightest <= shadow::darkness_ratio) return 0;
  double worst = 0;
  for (std::size_t k = 0; k < exact.size(); ++k)
    worst = std::max(worst, std::abs(found[k] - exact[k]));
  return worst / brightest;
}

/// Light at any place in the shadow, relative to full sunlight.
struct LightAtPlaces {
  const shadow::Lookup& lookup;
  Colour sunlight;

  LightAtPlaces(const shadow::Lookup& all, double sunlit_m) : lookup(all), sunlight{1, 1, 1} {
    sunlight = at(sunlit_m, 0, 4e8);
  }

  Colour at(double distance_m, double angle_rad, double depth_m) const {
    Colour here;
    lookup.read(
        {algebra::metres(distance_m), algebra::radians(angle_rad), algebra::metres(depth_m)}, here);
    for (std::size_t k = 0; k < here.size(); ++k) here[k] = std::max(0., here[k] / sunlight[k]);
    return here;
  }
};

/// Axis distance of a node in the middle plane [m], or of a point a fraction `part` of the way to the next node.
double node_m(const LightStrip& strip, int node, double part = 0) {
  std::size_t s = 0;
  while (s + 1 < strip.stretches.size() && node >= strip.stretches[s]) node -= strip.stretches[s++];
  return std::lerp(strip.from_km(s) * 1e3, strip.ends_km[s] * 1e3,
                   (node + part) / strip.stretches[s]);
}

double angle_rad(const LightStrip& strip, double row) {
  return 2 * std::numbers::pi * row / static_cast<double>(strip.sectors);
}

void fill(LightStrip& strip, const LightAtPlaces& light) {
  const std::size_t rows = strip.sectors + 1;
  const auto columns = std::reduce(strip.stretches.begin(), strip.stretches.end()) + 1;
  strip.roots = {static_cast<std::size_t>(columns), strip.planes * rows, {"R", "G", "B"}};
  for (std::size_t r = 0; r < strip.roots.height; ++r) {
    const double depth_km = strip.depth_km(r / rows);
    for (int c = 0; c < columns; ++c) {
      const double at_m = shadow::sheared(node_m(strip, c), depth_km / strip.middle_km());
      const auto here =
          light.at(at_m, angle_rad(strip, static_cast<double>(r % rows)), depth_km * 1e3);
      for (std::size_t k = 0; k < here.size(); ++k)
        strip.roots(r, static_cast<std::size_t>(c), k) = static_cast<float>(std::sqrt(here[k]));
    }
  }
}

/// Light between texels, as a shader computes it: square roots are interpolated linearly, and the result is squared.
Colour light_between(const LightStrip& strip, std::size_t r, std::size_t c, double along,
                     double across) {
  const std::size_t right = along > 0 ? c + 1 : c, below = across > 0 ? r + 1 : r;
  Colour light;
  for (std::size_t k = 0; k < light.size(); ++k) {
    const auto root = [&](std::size_t row) {
      return std::lerp(double{strip.roots(row, c, k)}, double{strip.roots(row, right, k)}, along);
    };
    light[k] = std::pow(std::lerp(root(r), root(below), across), 2);
  }
  return light;
}

/// Largest errors of linear interpolation between columns, between rows, and between both at once.
struct BetweenTexels {
  std::array<double, 4> columns{};  ///< largest error in each stretch
  double rows = 0, both = 0;

  double most() const { return std::max({std::ranges::max(columns), rows, both}); }
};

BetweenTexels between_texels(const LightStrip& strip, const LightAtPlaces& light) {
  BetweenTexels worst;
  for (std::size_t r = 0; r < strip.roots.height; ++r) {
    const std::size_t row = r % (strip.sectors + 1);
    const double depth_km = strip.depth_km(r / (strip.sectors + 1));
    const bool last_row = row == strip.sectors || strip.sectors == 1;
    std::size_t c = 0;
    for (std::size_t s = 0; s < strip.stretches.size(); ++s)
      for (int i = 0; i < strip.stretches[s]; ++i, ++c) {
        if (strip.roots(r, c, 0) == 0) continue;  // this texel is black
        const auto see = [&](double& most, double along, double across) {
          const double middle_m = node_m(strip, static_cast<int>(c), along);
          const auto exact =
              light.at(shadow::sheared(middle_m, depth_km / strip.middle_km()),
                       angle_rad(strip, static_cast<double>(row) + across), depth_km * 1e3);
          most = std::max(most, error_of(light_between(strip, r, c, along, across), exact));
        };
        see(worst.columns[s], 0.5, 0);
        see(worst.columns[s], 0.25, 0);  // on a steep rise the darker side has the largest error
        if (last_row) continue;
        see(worst.rows, 0, 0.5);
        see(worst.both, 0.5, 0.5);
      }
  }
  return worst;
}

/// Largest error of the light from which a strip is filled. It is found by comparison with a more accurate computation,
/// at points between the nodes, in the plane halfway between the nearest and the farthest.
double error_found(const ShaderRequest& request, const almanac::SkyState& sky,
                   const LightStrip& strip, const LightAtPlaces& light,
                   const shadow::ChannelWeights& weights) {
  constexpr std::array places{24, 24, 6, 4};  // number of test points in each stretch
  constexpr double off_nodes = 0.381966;
  LightRequest exact;
  exact.air = request.light.air;
  exact.limb_darkening = request.light.limb_darkening;
  exact.scattered_light = request.light.scattered_light;
  exact.starlight = request.light.starlight;
  exact.wish.tolerance = 2e-4;
  auto cut = shadow_at_the_moon(exact, sky);
  const double depth_m = strip.middle_km() * 1e3;
  cut.arrangement.depths_m = {depth_m};
  std::vector<double> distances_m;
  for (std::size_t s = 0; s < places.size(); ++s)
    for (int i = 0; i < places[s]; ++i)
      distances_m.push_back(
          1e3 * std::lerp(strip.from_km(s), strip.ends_km[s], (i + off_nodes) / places[s]));
  const int bands = request.light.by_hand.bands
                        ? std::clamp(2 * *request.light.by_hand.bands, 64, 400)
                        : usual_bands;
  const auto waves = wavelengths_nm(bands);
  const auto at_waves = at_wavelengths(weights, bands);
  const std::size_t around = cut.air.regions.empty() ? 29 : 13;  // test angles lie between rows
  const auto refracted =
      refracted_light(exact, cut.air, cut.arrangement, {waves, distances_m, around});
  const shadow::DirectLight direct(cut.air, cut.arrangement, waves);
  std::vector<double> clear(waves.size());
  double worst = 0;
  for (std::size_t sector = 0; sector < refracted.sectors; ++sector) {
    const double angle = shadow::Sectors{refracted.sectors}.angle_rad(sector);
    for (std::size_t d = 0; d < distances_m.size(); ++d) {
      direct.ratios(distances_m[d], angle, depth_m, clear);
      const auto there = refracted.ratio[sector].row(d);
      Colour colour{}, sunlit{};
      for (std::size_t k = 0; k < colour.size(); ++k)
        for (std::size_t w = 0; w < waves.size(); ++w) {
          colour[k] += at_waves(k, w) * (there[w] + clear[w]);
          sunlit[k] += at_waves(k, w);
        }
      into_gamut_or_black(request.space, colour);
      for (std::size_t k = 0; k < colour.size(); ++k)
        colour[k] = std::max(0., colour[k] / sunlit[k]);
      worst = std::max(worst, error_of(light.at(distances_m[d], angle, depth_m), colour));
    }
  }
  return worst;
}

}  // namespace

LightStrip light_strip(const ShaderRequest& request, const almanac::SkyState& sky,
                       double nearest_km, double farthest_km, const algebra::Progress& progress) {
  auto cut = shadow_at_the_moon(request.light, sky);
  LightStrip strip;
  strip.stretches = fewest_stretches;
  strip.nearest_km = nearest_km;
  strip.farthest_km = farthest_km;
  if (nearest_km == farthest_km) strip.planes = 1;
  cut.arrangement.depths_m.clear();
  for (std::size_t p = 0; p < strip.planes; ++p)
    cut.arrangement.depths_m.push_back(strip.depth_km(p) * 1e3);
  const int bands = request.light.by_hand.bands.value_or(usual_bands);
  const auto waves = wavelengths_nm(bands);
  const shadow::DirectLight direct(cut.air, cut.arrangement, waves);
  const double middle_m = strip.middle_km() * 1e3,
               end_m = direct.penumbra_m(farthest_km * 1e3) + 50e3,
               begins_m = direct.penumbra_m(middle_m) -
                          2 * shadow::projected_solar_radius_m(cut.arrangement, middle_m);
  strip.ends_km = {(begins_m - before_m) / 1e3, (begins_m + about_m) / 1e3,
                   (begins_m + behind_m) / 1e3, end_m / 1e3};
  constexpr std::size_t around = 96;
  const auto distances_m = distances_to(
      shadow::refracted_reach_m(cut.arrangement, cut.air, cut.arrangement.depths_m.back()),
      begins_m);
  const auto refracted = refracted_light(request.light, cut.air, cut.arrangement,
                                         {waves, distances_m, around}, progress);
  strip.sectors = refracted.sectors;
  const auto weights = moonlight_weights(
      colour::channel_weights(request.space, band_edges_nm(), request.response.value_or("")),
      request.sightline);
  shadow::Lookup lookup(refracted, direct, at_wavelengths(weights, bands));
  lookup.transform([&](std::span<double> colour) { into_gamut_or_black(request.space, colour); });

  const LightAtPlaces light(lookup, 2 * end_m);
  fill(strip, light);
  auto worst = between_texels(strip, light);
  for (int times = 1; times < most_times && worst.most() > good_enough; times *= 2) {
    if (worst.rows > between_nodes) strip.sectors *= 2;
    for (std::size_t s = 0; s < strip.stretches.size(); ++s)
      if (worst.columns[s] > between_nodes) strip.stretches[s] *= 2;
    fill(strip, light);
    worst = between_texels(strip, light);
  }
  strip.error = worst.most() + error_found(request, sky, strip, light, weights) + rounding;
  return strip;
}

}  // namespace coppermoon::uses
