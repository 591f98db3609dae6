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

/// Numbers of nodes within the umbra, about the beginning of direct light, and beyond.
constexpr std::array stretches{180, 160, 100};
constexpr int columns = stretches[0] + stretches[1] + stretches[2] + 1;

/// Stretch of dense nodes, before and behind the beginning of direct light [m].
constexpr double before_m = 200e3, behind_m = 400e3;

shadow::RefractedLight light_of(const LightRequest& request, const ShadowCut& cut,
                                const std::vector<double>& waves,
                                const algebra::Progress& progress) {
  constexpr double spacing_m = 25e3;
  constexpr std::size_t around = 96;
  const double reach_m =
      shadow::refracted_reach_m(cut.arrangement, cut.air, cut.arrangement.depths_m.back());
  std::vector<double> distances_m;
  for (double d = 0; d < reach_m + spacing_m; d += spacing_m) distances_m.push_back(d);
  return refracted_light(request, cut.air, cut.arrangement, {waves, distances_m, around}, progress);
}

}  // namespace

LightStrip light_strip(const LightRequest& request, const almanac::SkyState& sky, double nearer_km,
                       double farther_km, colour::WorkingSpace space,
                       const std::optional<std::string>& response,
                       const algebra::Progress& progress) {
  auto cut = shadow_at_the_moon(request, sky);
  cut.arrangement.depths_m = {nearer_km * 1e3, farther_km * 1e3};
  const int bands = request.by_hand.bands.value_or(100);
  const auto waves = wavelengths_nm(bands);
  const auto refracted = light_of(request, cut, waves, progress);
  const shadow::DirectLight direct(cut.air, cut.arrangement, waves);
  const auto weights =
      moonlight_weights(colour::channel_weights(space, band_edges_nm(), response.value_or("")));
  shadow::Lookup lookup(refracted, direct, at_wavelengths(weights, bands));
  lookup.transform([space](std::span<double> colour) { into_gamut_or_black(space, colour); });

  LightStrip strip;
  strip.stretches = stretches;
  strip.sectors = refracted.sectors;
  strip.nearer_km = nearer_km;
  strip.farther_km = farther_km;
  const double middle_m = strip.middle_km() * 1e3,
               end_m = std::max(direct.penumbra_m(nearer_km * 1e3),
                                direct.penumbra_m(farther_km * 1e3)) +
                       50e3,
               begins_m = direct.penumbra_m(middle_m) -
                          2 * shadow::projected_solar_radius_m(cut.arrangement, middle_m);
  strip.ends_km = {(begins_m - before_m) / 1e3, (begins_m + behind_m) / 1e3, end_m / 1e3};

  const std::size_t rows = strip.sectors + 1;
  strip.roots = {static_cast<std::size_t>(columns), 2 * rows, {"R", "G", "B"}};
  std::array<double, 3> here, sunlight;
  lookup.read({algebra::metres(2 * end_m), {}, algebra::metres(middle_m)}, sunlight);
  const auto distance_m = [&](int node) {
    double from = 0;
    for (std::size_t s = 0; s < 3; ++s) {
      const double to = strip.ends_km[s] * 1e3;
      const int count = stretches[s];
      if (node <= count || s == 2) return std::lerp(from, to, double(node) / count);
      from = to;
      node -= count;
    }
    return from;
  };
  for (std::size_t r = 0; r < 2 * rows; ++r) {
    const double depth_m = (r < rows ? nearer_km : farther_km) * 1e3;
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
