// SPDX-License-Identifier: MIT
#include "uses/shader/light_strip.h"

#include "almanac/instant.h"
#include "eclipse/shadow_axis.h"
#include "support/testing.h"
#include "uses/light/shadow_profile.h"
#include "uses/light/spectral_bands.h"

namespace coppermoon::uses::light_strip_test {

using Colour = std::array<double, 3>;

constexpr int bands = 10;
constexpr double nearest_km = 4.03e5, farthest_km = 4.07e5;

const almanac::SkyState& sky() {
  static const auto sky = almanac::sky_at(almanac::instant_from_utc("2018-07-27T20:21:45Z"));
  return sky;
}

ShaderRequest request_of(const Air& air) {
  ShaderRequest request;
  request.light.air = air;
  request.light.by_hand.bands = bands;
  request.light.scattered_light = ScatteredLight::off;
  return request;
}

LightStrip strip_of(const ShaderRequest& request) {
  return light_strip(request, sky(), nearest_km, farthest_km);
}

/// What a shader reads, as formula.h has it.
Colour read(const LightStrip& strip, double distance_m, double angle_rad, double depth_m) {
  const double deeper_by = strip.middle_km() * 1e3 / depth_m - 1,
               in_middle_km = (distance_m + (distance_m - shadow::limb_m) * deeper_by *
                                                std::min(1., distance_m / shadow::one_limb_m)) /
                              1e3;
  double from_km = 0, along = 0;
  for (std::size_t s = 0; s < 4; ++s) {
    const double to_km = strip.ends_km[s];
    along += strip.stretches[s] * std::clamp((in_middle_km - from_km) / (to_km - from_km), 0., 1.);
    from_km = to_km;
  }
  const double turns = angle_rad / (2 * std::numbers::pi),
               across = (turns - std::floor(turns)) * static_cast<double>(strip.sectors),
               deeper = (depth_m / 1e3 - strip.nearest_km) / (strip.farthest_km - strip.nearest_km);
  const auto c = std::min(static_cast<std::size_t>(along), strip.roots.width - 2),
             r = std::min(static_cast<std::size_t>(across), strip.sectors - 1);
  const double right = along - static_cast<double>(c), down = across - static_cast<double>(r);
  Colour light;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto root = [&](std::size_t plane) {
      const std::size_t row = plane * (strip.sectors + 1) + r;
      return std::lerp(std::lerp(strip.roots(row, c, k), strip.roots(row, c + 1, k), right),
                       std::lerp(strip.roots(row + 1, c, k), strip.roots(row + 1, c + 1, k), right),
                       down);
    };
    light[k] = std::pow(std::lerp(root(0), root(1), deeper), 2);
  }
  return light;
}

struct Errors {
  double worst = 0;
  int beyond = 0, places = 0;  ///< places where the error is above what the strip says
};

/// A strip's errors at places of no grid, against a finer quadrature of the same wavelengths.
Errors errors_of(const LightStrip& strip, const ShaderRequest& request) {
  auto cut = shadow_at_the_moon(request.light, sky());
  const double depth_m = 1e3 * std::lerp(nearest_km, farthest_km, 0.3);
  cut.arrangement.depths_m = {depth_m};
  const double to_km = strip.ends_km[2];
  std::vector<double> distances_m;
  for (int i = 0; i < 67; ++i) distances_m.push_back(1e3 * to_km * std::sqrt((i + 0.7) / 67));
  auto finer = request.light;
  finer.wish.tolerance = 2e-4;
  const auto waves = wavelengths_nm(bands);
  const auto weights = at_wavelengths(
      moonlight_weights(colour::channel_weights(request.space, band_edges_nm())), bands);
  const auto light = refracted_light(finer, cut.air, cut.arrangement, {waves, distances_m, 17});
  const shadow::DirectLight direct(cut.air, cut.arrangement, waves);
  std::vector<double> clear(waves.size());
  Errors errors;
  for (std::size_t s = 0; s < light.sectors; ++s) {
    const double angle = shadow::Sectors{light.sectors}.angle_rad(s);
    for (std::size_t d = 0; d < distances_m.size(); ++d) {
      direct.ratios(distances_m[d], angle, depth_m, clear);
      Colour exact{}, sunlit{};
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t w = 0; w < waves.size(); ++w) {
          exact[k] += weights(k, w) * (light.ratio[s](d, w) + clear[w]);
          sunlit[k] += weights(k, w);
        }
      into_gamut_or_black(request.space, exact);
      for (std::size_t k = 0; k < 3; ++k) exact[k] /= sunlit[k];
      const auto found = read(strip, distances_m[d], angle, depth_m);
      double error = 0;
      for (std::size_t k = 0; k < 3; ++k)
        error = std::max(error, std::abs(found[k] - exact[k]) / std::ranges::max(exact));
      errors.worst = std::max(errors.worst, error);
      ++errors.places;
      if (error > strip.error) ++errors.beyond;
    }
  }
  return errors;
}

TEST(LightStrip, OfUsualAirHasFewColumnsAndRows) {
  const auto strip = strip_of(request_of({.atmosphere = "undated"}));
  EXPECT_EQ(strip.roots.width, 591U);
  EXPECT_EQ(strip.roots.height, 194U);
}

TEST(LightStrip, HasMoreColumnsWhereLightFallsSteeply) {
  const auto request =
      request_of({.atmosphere = "paper", .column = {.dust_extinction_per_m = 2e-5}});
  const auto strip = strip_of(request);
  EXPECT_EQ(strip.sectors, 1U);
  EXPECT_GT(strip.roots.width, 591U);
  EXPECT_EQ(strip.stretches[3], 90) << "beyond, all is sunlight";
  const auto errors = errors_of(strip, request);
  EXPECT_LE(errors.beyond, errors.places / 20) << "as stated";
}

TEST(LightStrip, SaysItsErrorAlsoWhereItIsLarge) {
  AirRegion gap{.from_position_angle = 40, .to_position_angle = 50};
  gap.column.dust_extinction_per_m = 0;
  const auto request = request_of(
      {.atmosphere = "paper", .column = {.dust_extinction_per_m = 2e-5}, .regions = {gap}});
  const auto strip = strip_of(request);
  const auto errors = errors_of(strip, request);
  EXPECT_GT(strip.sectors, 96U) << "the gap's borders are sharp";
  EXPECT_GT(errors.worst, 0.01) << "this air is too hard for it";
  EXPECT_LE(errors.beyond, errors.places / 20) << "as stated";
}

}  // namespace coppermoon::uses::light_strip_test
