// SPDX-License-Identifier: MIT
#include "uses/light/planning.h"

#include "almanac/instant.h"
#include "atmosphere/presets.h"
#include "baker/uses/light/dusty_air.h"
#include "shadow/twilight.h"
#include "support/testing.h"
#include "uses/light/moonlight.h"
#include "uses/light/spectral_bands.h"

namespace coppermoon::uses::planning_test {

const double radius_m = algebra::in_metres(almanac::lunar_radius);

ShadowedMoon moon_at(const char* utc, std::string_view preset = "undated") {
  const auto sky = almanac::sky_at(almanac::instant_from_utc(utc));
  const auto axis = eclipse::shadow_axis(sky);
  return {eclipse::place_in_shadow(axis, sky.moon_m), algebra::in_metres(axis.sun_distance), true,
          atmosphere::preset(preset, axis.sun_declination)};
}

/// A little after its first contact with the penumbra.
ShadowedMoon hardly_shaded() { return moon_at("2009-02-09T12:42:00Z"); }
ShadowedMoon deep() { return moon_at("2011-06-15T20:13:00Z"); }
ShadowedMoon february_2008() { return moon_at("2008-02-21T03:26:05Z"); }

ShadowedMoon with_dusty_south(ShadowedMoon moon) {
  auto dusty = moon.air.column;
  dusty.dust_extinction_per_m = 1e-5;
  moon.air.regions = {*between_latitudes(algebra::degrees(-90), algebra::degrees(0),
                                         algebra::radians(moon.air.earth.sun_declination_rad),
                                         dusty)};
  return moon;
}

/// Luminance at places of one depth and sector, refracted and direct, straight from the quadrature
/// with many wavelengths, rays and terms.
std::vector<double> luminances(const ShadowedMoon& moon, const std::vector<double>& places_m,
                               std::size_t sector, bool scattered = false) {
  constexpr int bands = 40;
  const auto waves = wavelengths_nm(bands);
  const double depth = algebra::in_metres(moon.centre.depth) - radius_m / 2;
  const auto arrangement = arrangement_of(moon, {depth});
  auto light = shadow::by_quadrature(moon.air, arrangement, waves, places_m,
                                     {.rays = 400, .sectors = {96, sector, 1}});
  if (scattered) shadow::add_twilight(light, moon.air);
  const auto weights = at_wavelengths(luminance_weights(), bands);
  const shadow::DirectLight clear(moon.air, arrangement, waves);
  const double angle = 2 * std::numbers::pi * static_cast<double>(sector) / 96;
  std::vector<double> all, ratios(waves.size());
  for (std::size_t d = 0; d < places_m.size(); ++d) {
    clear.ratios(places_m[d], angle, depth, ratios);
    double sum = 0;
    for (std::size_t w = 0; w < waves.size(); ++w)
      sum += weights(0, w) * (ratios[w] + light.ratio[light.sectors == 1 ? 0 : sector](d, w));
    all.push_back(sum);
  }
  return all;
}

std::vector<double> over_the_disc(const ShadowedMoon& moon, int places) {
  const double centre = algebra::in_metres(moon.centre.axis_distance),
               nearest = std::max(0., centre - radius_m);
  std::vector<double> all;
  for (int i = 0; i <= places; ++i)
    all.push_back(nearest + (centre + radius_m - nearest) * i / places);
  return all;
}

/// The largest change of luminance from one Moon to another, over 17 places in every sector.
double change(const ShadowedMoon& all, const ShadowedMoon& without) {
  const auto places = over_the_disc(all, 16);
  const auto settings = quadrature_for({}, all);
  double worst = 0;
  for (std::size_t i = 0; i < settings.sectors.count; ++i) {
    const std::size_t sector = settings.sectors[i];
    const auto one = luminances(all, places, sector), other = luminances(without, places, sector);
    for (std::size_t d = 0; d < places.size(); ++d)
      if (one[d] > 0) worst = std::max(worst, std::abs(other[d] / one[d] - 1));
  }
  return worst;
}

ShadowedMoon on_a_sphere(const ShadowedMoon& moon) {
  auto work = plan::Work{};
  work.ellipsoid = false;
  auto sphere = moon;
  sphere.air = air_for(work, moon);
  return sphere;
}

/// What scene_of adds to a size for what a coarse look does not see.
constexpr double margin = 2;
constexpr const char* coarse =
    "10 wavelengths, 100 rays and 9 places against 40, 400 and 17: a brief look may be 30 % off";

TEST(SceneOfThoroughly, KnowsHowMuchTheEllipsoidMatters) {
  for (const auto& moon : {february_2008(), deep()}) {
    const double size = change(moon, on_a_sphere(moon));
    EXPECT_WITHIN_RELATIVE(scene_of(moon, {}).without_ellipsoid, margin * size, 0.3, coarse);
    EXPECT_GT(size, 0.01) << "a test that has something to find";
  }
}

TEST(SceneOf, KnowsHowMuchRegionsMatter) {
  const auto clean = february_2008(), dusty = with_dusty_south(clean);
  const double size = change(dusty, clean);
  EXPECT_WITHIN_RELATIVE(scene_of(dusty, {}).without_regions, margin * size, 0.3, coarse);
  EXPECT_EQ(scene_of(clean, {}).without_regions, 0);
  EXPECT_GT(scene_of(dusty, {}).columns, 1U);
  EXPECT_EQ(scene_of(clean, {}).columns, 1U);
}

TEST(SceneOf, KnowsHowMuchScatteredLightMatters) {
  const auto moon = deep();
  const auto places = over_the_disc(moon, 16);
  double share = 0;
  for (const std::size_t sector : {0U, 24U, 48U, 72U}) {
    const auto with = luminances(moon, places, sector, true),
               without = luminances(moon, places, sector);
    for (std::size_t d = 0; d < places.size(); ++d)
      share = std::max(share, 1 - without[d] / with[d]);
  }
  EXPECT_WITHIN_RELATIVE(scene_of(moon, {}).without_scattered, margin * share, 0.3, coarse);
  EXPECT_GT(share, 0.02) << "a test that has something to find";
  EXPECT_LT(scene_of(hardly_shaded(), {}).without_scattered, 1e-4);
}

TEST(SceneOf, OfAPenumbralEclipseHasHardlyAnyLightThroughTheAir) {
  const auto scene = scene_of(hardly_shaded(), {});
  EXPECT_LT(scene.without_refracted, 0.01);
  EXPECT_EQ(scene_of(deep(), {}).without_refracted, 1) << "all light of the umbra is refracted";
}

TEST(SceneOf, OfABareEarthHasNone) {
  const auto scene = scene_of(moon_at("2008-02-21T03:26:05Z", "none"), {});
  EXPECT_EQ(scene.without_refracted, 0);
  EXPECT_EQ(scene.without_scattered, 0);
}

TEST(SceneOf, OfABareEarthKnowsThatTheEllipsoidCastsTheShadow) {
  EXPECT_GT(scene_of(moon_at("2008-02-21T02:10:00Z", "none"), {}).without_ellipsoid, 0.05)
      << "the umbra's edge is on the disc, kilometres from a sphere's";
}

TEST(SceneOf, OfASphereHasNoEllipsoid) {
  const auto scene = scene_of(moon_at("2008-02-21T03:26:05Z", "paper"), {});
  EXPECT_FALSE(scene.ellipsoid);
  EXPECT_EQ(scene.without_ellipsoid, 0);
}

TEST(SceneOf, ReachesFromTheDiscsNearestPlaceToItsFarthest) {
  const auto moon = february_2008();
  const double centre = algebra::in_metres(moon.centre.axis_distance);
  const auto scene = scene_of(moon, {.texels = 123, .map_file = true});
  EXPECT_WITHIN(scene.nearest_m, centre - radius_m, 1, "rounding");
  EXPECT_WITHIN(scene.farthest_m, centre + radius_m, 1, "rounding");
  EXPECT_EQ(scene.texels, 123);
  EXPECT_TRUE(scene.map_file);
  EXPECT_EQ(scene_of(deep(), {}).nearest_m, 0) << "the axis goes through the disc";
}

ShadowedMoon standing(double axis_distance_m, double position_angle_deg) {
  auto moon = february_2008();
  moon.centre.axis_distance = algebra::metres(axis_distance_m);
  moon.centre.position_angle = algebra::degrees(position_angle_deg);
  return moon;
}

/// Position angles that a disc takes in, tried along its rim.
TEST(QuadratureFor, TakesEverySectorThatCubicsOverTheDiscGoThrough) {
  for (const double distance : {0.2e6, 1.7e6, 1.8e6, 3e6, 6e6})
    for (double middle = 0; middle < 360; middle += 11) {
      const auto moon = standing(distance, middle);
      const auto settings = quadrature_for({}, moon);
      const double theta = middle * std::numbers::pi / 180;
      for (double phi = 0; phi < 6.28; phi += 0.01) {
        const double east = distance * std::sin(theta) + radius_m * std::cos(phi),
                     north = distance * std::cos(theta) + radius_m * std::sin(phi);
        const double sector = std::atan2(east, north) / (2 * std::numbers::pi) * 96;
        for (const double between : {std::floor(sector) - 1, std::ceil(sector) + 1}) {
          const auto s = static_cast<std::size_t>(static_cast<int>(between) + 192) % 96;
          EXPECT_LT((s + 96 - settings.sectors.first) % 96, settings.sectors.count)
              << distance << " m, " << middle << " degrees, sector " << s;
        }
      }
    }
}

TEST(QuadratureFor, TakesFewSectorsFarFromTheAxisAndAllOnIt) {
  EXPECT_EQ(quadrature_for({}, standing(1e6, 10)).sectors, shadow::Sectors{96});
  EXPECT_LE(quadrature_for({}, standing(6e6, 10)).sectors.count, 2 * 17 / 3.75 + 5)
      << "an angle of 17 degrees to either side, begun sectors and two for cubics";
}

TEST(QuadratureFor, IsAsFineAsTheWork) {
  const auto settings =
      quadrature_for({.rays = 123, .sun_terms = 3, .place_error = 0.02}, february_2008());
  EXPECT_EQ(settings.rays, 123);
  EXPECT_EQ(settings.sun_terms, 3);
  EXPECT_EQ(settings.place_error, 0.02);
}

TEST(DepthsOf, GoThroughTheHalfThatFacesTheSun) {
  const auto moon = february_2008();
  const double centre = algebra::in_metres(moon.centre.depth);
  const auto two = depths_of(moon, 2), five = depths_of(moon, 5), one = depths_of(moon, 1);
  EXPECT_WITHIN(two[0], centre - radius_m, 1e-6, "rounding");
  EXPECT_WITHIN(two[1], centre, 1e-6, "rounding");
  ASSERT_EQ(one.size(), 1U);
  EXPECT_TRUE(two[0] < one[0] && one[0] < two[1]);
  ASSERT_EQ(five.size(), 5U);
  for (std::size_t i = 1; i < 5; ++i)
    EXPECT_WITHIN(five[i] - five[i - 1], radius_m / 4, 1e-6, "rounding of 4e8 m");
}

TEST(DistancesOverTheDisc, ReachBeyondItByStepsOf200KmAtMost) {
  const auto moon = february_2008();
  const auto scene = scene_of(moon, {});
  const auto places = distances_over_the_disc(moon);
  EXPECT_LT(places.front(), scene.nearest_m);
  EXPECT_GT(places.back(), scene.farthest_m);
  for (std::size_t i = 1; i < places.size(); ++i) EXPECT_LE(places[i] - places[i - 1], 200.001e3);
}

TEST(AirFor, LeavesOutRegionsAndTheEllipsoid) {
  const auto moon = with_dusty_south(february_2008());
  plan::Work work;
  EXPECT_EQ(air_for(work, moon).regions.size(), moon.air.regions.size());
  work.regions = false;
  EXPECT_TRUE(air_for(work, moon).regions.empty());
  EXPECT_FALSE(air_for(work, moon).symmetric());
  work.ellipsoid = false;
  const auto air = air_for(work, moon);
  EXPECT_TRUE(air.symmetric());
  const auto limb =
      atmosphere::limb_at(moon.air.earth, algebra::in_radians(moon.centre.position_angle));
  EXPECT_EQ(air.earth.equatorial_radius_m, limb.radius_m) << "as large as the limb is there";
}

TEST(LuminanceWeights, MakeSunlightsLuminanceOnTheMoon) {
  const auto weights = luminance_weights();
  double sum = 0;
  for (const double w : weights.row(0)) sum += w;
  EXPECT_WITHIN_RELATIVE(sum, 133.33e3 / std::numbers::pi, 0.01,
                         "133.33 klx: Darula, Kittler & Gueymard (2005); spectra differ by 1 %");
}

TEST(ThisMachine, IsNeitherStillNorMagic) {
  const auto machine = this_machine();
  EXPECT_GT(machine.speed, 1e-3);
  EXPECT_LT(machine.speed, 1e3);
  EXPECT_GE(machine.cores, 1);
}

Moonlight light_of(const char* utc, int bands, int rays, double place_error) {
  LightRequest request;
  request.air.atmosphere = "undated";
  request.by_hand.bands = bands;
  request.by_hand.rays = rays;
  request.by_hand.sun_terms = 6;
  request.by_hand.place_error = place_error;
  request.by_hand.planes = 2;
  return light_on_the_moon(request, almanac::sky_at(almanac::instant_from_utc(utc)));
}

TEST(ErrorFound, OfCoarseWorkIsFarAboveThatOfFine) {
  constexpr const char* mid_eclipse = "2008-02-21T03:26:05Z";
  const double coarse_error = light_of(mid_eclipse, 10, 60, 0.1).error_found,
               fine_error = light_of(mid_eclipse, 80, 600, 3e-4).error_found;
  EXPECT_GT(coarse_error, 5e-3);
  EXPECT_LT(fine_error, 1e-3);
  EXPECT_GT(coarse_error, 10 * fine_error);
}

/// Error found in clear air, deep in the shadow, but for what a test changes.
double found_when(const std::function<void(LightRequest&)>& changed,
                  const char* utc = "2018-07-27T20:00:00Z") {
  LightRequest request;
  request.air.atmosphere = "clear";
  changed(request);
  return light_on_the_moon(request, almanac::sky_at(almanac::instant_from_utc(utc))).error_found;
}

TEST(ErrorFound, SeesEveryCoarseKnob) {
  EXPECT_LT(found_when([](LightRequest&) {}), 0.01);
  EXPECT_GT(found_when([](LightRequest& request) { request.by_hand.rays = 5; }), 0.02);
  EXPECT_GT(found_when([](LightRequest& request) { request.by_hand.bands = 2; }), 1);
  EXPECT_GT(found_when([](LightRequest& request) { request.by_hand.planes = 1; }), 0.005);
  const auto photons = [](double ring_km, double smoothing_km) {
    return found_when([&](LightRequest& request) {
      request.photons = 3e5;
      request.ring_km = ring_km;
      request.smoothing_km = smoothing_km;
    });
  };
  EXPECT_GT(photons(500, 0), 0.1);
  EXPECT_GT(photons(50, 1000), 0.1);
}

TEST(ErrorFound, OfABareEarthIsThatOfTheLookUpAlone) {
  EXPECT_LT(found_when([](LightRequest& request) { request.air.atmosphere = "none"; },
                       "2008-02-21T02:10:00Z"),
            1.2 * 0.06)
      << "straight lines over a kilometre, of the power of 3/2 that light begins with: 5 %; a "
         "fifth is "
         "added";
}

TEST(ErrorFound, IsFoundWhereverTheDiscLiesAroundTheAxis) {
  // from the axis on the disc, through discs that take in nearly all sectors, to those that take in few
  for (const char* utc : {"2018-07-27T20:21:45Z", "2018-07-27T20:00:00Z", "2018-07-27T19:50:00Z",
                          "2018-07-27T19:45:00Z", "2018-07-27T19:40:00Z", "2018-07-27T19:00:00Z",
                          "2018-07-27T20:55:00Z", "2018-07-27T21:40:00Z", "2011-06-15T20:13:00Z"})
    EXPECT_LT(light_of(utc, 20, 200, 0.01).error_found, 0.05) << utc;
}

TEST(ErrorFound, SeesATermThatWasLeftOut) {
  LightRequest request;
  request.by_hand.terms = plan::Work{.ellipsoid = false, .scattered_light = true};
  const auto sky = almanac::sky_at(almanac::instant_from_utc("2008-02-21T03:26:05Z"));
  const auto light = light_on_the_moon(request, sky);
  const double size = light.plan.left_out.front().size;
  EXPECT_GT(light.error_found, 0.2 * size);
  EXPECT_LT(light.error_found, 1.2 * size);
}

TEST(ErrorFound, SeesALookUpTooCoarseWhereDirectLightBegins) {
  const auto sky = almanac::sky_at(almanac::instant_from_utc("2034-09-28T02:55:57Z"));
  const auto request = dusty_air_of_the_paper(0.002);
  const auto light = light_on_the_moon(request, sky);
  auto wide = light.range;
  wide.tolerance = 0.1;
  const auto weights = at_wavelengths(luminance_weights(), light.plan.work.bands);
  EXPECT_GT(
      error_found(shadowed_moon(request, sky), light.plan.work, light.in_sums(weights, wide), {}),
      2e-3)
      << "nodes 10 km apart: 3e-3 to 8e-3 of the light, by where they fall";
}

TEST(ErrorFound, SeesScatteredLightThatThePlanLeftOut) {
  const auto sky = almanac::sky_at(almanac::instant_from_utc("1954-01-19T02:06:51Z"));
  const auto request = dusty_air_of_the_paper(0.01);
  const auto light = light_on_the_moon(request, sky);
  const auto weights = at_wavelengths(luminance_weights(), light.plan.work.bands);
  const auto moon = shadowed_moon(request, sky);
  const auto found = [&](bool scattered_counts) {
    return error_found(moon, light.plan.work, light.in_sums(weights, light.range),
                       {.counts = scattered_counts});
  };
  ASSERT_FALSE(light.plan.work.scattered_light);
  EXPECT_WITHIN_RELATIVE(light.error_found, 1.2 * found(true), 1e-12, "a fifth is added");
  EXPECT_GT(found(true), found(false) + 3e-4) << "of 3e-3 that scattered light is at most";
}

TEST(LightOnTheMoon, KeepsScatteredLightOffWhenItIsLeftOut) {
  LightRequest request;
  request.by_hand.terms = plan::Work{.scattered_light = false};
  const auto sky = almanac::sky_at(almanac::instant_from_utc("2011-06-15T20:13:00Z"));
  const auto light = light_on_the_moon(request, sky);
  EXPECT_FALSE(light.plan.work.scattered_light);
  const auto& left_out = light.plan.left_out;
  EXPECT_NE(std::ranges::find(left_out, plan::Term::scattered_light, &plan::LeftOut::term),
            left_out.end());
  request.by_hand.terms = plan::Work{.ellipsoid = false, .scattered_light = true};
  request.scattered_light = ScatteredLight::off;
  EXPECT_FALSE(planned_light(request, sky).work.scattered_light) << "off, whatever is left out";
}

}  // namespace coppermoon::uses::planning_test
