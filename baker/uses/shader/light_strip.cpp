// SPDX-License-Identifier: MIT
#include "uses/shader/light_strip.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "eclipse/shadow_axis.h"
#include "uses/light/shadow_profile.h"
#include "uses/light/spectral_bands.h"

namespace coppermoon::uses {
namespace {

/// Numbers of nodes within the umbra, about the beginning of direct light, behind it, and beyond.
constexpr std::array stretches{180, 240, 80, 90};
constexpr int columns = stretches[0] + stretches[1] + stretches[2] + stretches[3] + 1;

/// Ends of the stretches from the beginning of direct light [m]: it begins within 30 km all around the Earth's figure.
constexpr double before_m = 320e3, about_m = 60e3, behind_m = 480e3;

/// Axis distances at which refracted light is computed: close where what high rays bring ends.
std::vector<double> distances_to(double reach_m, double begins_m) {
  constexpr double spacing_m = 25e3, close_m = 5e3, from_m = 450e3;
  std::vector<double> distances{0};
  while (distances.back() < reach_m)
    distances.push_back(distances.back() +
                        (distances.back() < begins_m - from_m ? spacing_m : close_m));
  return distances;
}

}  // namespace

LightStrip light_strip(const ShaderRequest& request, const almanac::SkyState& sky,
                       double nearest_km, double farthest_km, const algebra::Progress& progress) {
  auto cut = shadow_at_the_moon(request.light, sky);
  LightStrip strip;
  strip.stretches = stretches;
  strip.nearest_km = nearest_km;
  strip.farthest_km = farthest_km;
  cut.arrangement.depths_m.clear();
  for (std::size_t p = 0; p < strip.planes; ++p)
    cut.arrangement.depths_m.push_back(strip.depth_km(p) * 1e3);
  const int bands = request.light.by_hand.bands.value_or(100);
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

  const std::size_t rows = strip.sectors + 1;
  strip.roots = {static_cast<std::size_t>(columns), strip.planes * rows, {"R", "G", "B"}};
  std::array<double, 3> here, sunlight;
  lookup.read({algebra::metres(2 * end_m), {}, algebra::metres(middle_m)}, sunlight);
  const auto distance_m = [&](int node) {
    double from = 0;
    for (std::size_t s = 0; s < stretches.size(); ++s) {
      const double to = strip.ends_km[s] * 1e3;
      const int count = stretches[s];
      if (node <= count || s + 1 == stretches.size())
        return std::lerp(from, to, double(node) / count);
      from = to;
      node -= count;
    }
    return from;
  };
  for (std::size_t r = 0; r < strip.roots.height; ++r) {
    const double depth_m = strip.depth_km(r / rows) * 1e3;
    const double angle =
        2 * std::numbers::pi * static_cast<double>(r % rows) / static_cast<double>(strip.sectors);
    for (int c = 0; c < columns; ++c) {
      const double at_m = shadow::sheared(distance_m(c), depth_m / middle_m);
      lookup.read({algebra::metres(at_m), algebra::radians(angle), algebra::metres(depth_m)}, here);
      for (std::size_t k = 0; k < 3; ++k)
        strip.roots(r, static_cast<std::size_t>(c), k) =
            static_cast<float>(std::sqrt(std::max(0., here[k] / sunlight[k])));
    }
  }
  return strip;
}

}  // namespace coppermoon::uses
