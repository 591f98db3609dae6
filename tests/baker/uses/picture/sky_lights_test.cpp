// SPDX-License-Identifier: MIT
#include "uses/picture/sky_lights.h"

#include <erfa.h>
#include <glm/geometric.hpp>

#include "almanac/planets.h"
#include "colour/working_space.h"
#include "povray_scenes/scene_camera.h"
#include "support/testing.h"

namespace coppermoon::uses::sky_lights_test {

constexpr double degree = std::numbers::pi / 180;

almanac::SkyState sky_of(const char* utc) {
  return almanac::sky_at(almanac::instant_from_utc(utc));
}

const almanac::SkyState& totality_of_2018() {
  static const auto sky = sky_of("2018-07-27T20:22Z");
  return sky;
}

const almanac::Observer nairobi{algebra::degrees(-1.28), algebra::degrees(36.82), {}},
    tokyo{algebra::degrees(35.66), algebra::degrees(139.74), {}};

ViewRequest wide(double field_deg, std::size_t width, std::size_t height) {
  return {.field_deg = field_deg, .width = width, .height = height};
}

/// Light of a frame by solid angles of its pixels, and where its middle is.
struct Sum {
  std::array<double, 3> lux{};
  glm::dvec2 middle{0, 0};
};

Sum sum_of(const texture::Image& frame, const povray_scenes::SceneCamera& camera) {
  const auto sight = povray_scenes::sight_of(camera);
  Sum sum;
  double green = 0;
  for (std::size_t r = 0; r < frame.height; ++r)
    for (std::size_t c = 0; c < frame.width; ++c) {
      const glm::dvec2 at(static_cast<double>(c) + 0.5, static_cast<double>(r) + 0.5);
      const glm::dvec3 ray = sight.corner + at.x * sight.across + at.y * sight.down;
      const double solid_angle = std::abs(glm::dot(glm::cross(sight.across, sight.down), ray)) /
                                 std::pow(glm::length(ray), 3);
      for (std::size_t k = 0; k < 3; ++k) sum.lux[k] += frame(r, c, k) * solid_angle;
      green += frame(r, c, 1);
      sum.middle += at * double{frame(r, c, 1)};
    }
  sum.middle /= green;
  return sum;
}

TEST(SkyLights, KeepTheirLightAndTheirPlace) {
  const auto camera = view_of(wide(20, 120, 90), totality_of_2018()).camera;
  for (const auto& [latitude, longitude] :
       {std::pair(10., 20.), std::pair(-40., 35.), std::pair(0., 0.)}) {
    const almanac::SelenographicPoint ground{algebra::degrees(latitude),
                                             algebra::degrees(longitude)};
    const auto place = *povray_scenes::pixel_of(camera, ground);
    for (const double aside :
         {0., 0.05, 0.12}) {  // radians from the picture's middle, towards north
      const glm::dvec3 direction =
          glm::normalize(almanac::selenographic_direction(ground) - camera.position +
                         aside * glm::length(camera.position) * camera.up);
      texture::Image frame(120, 90, {"R", "G", "B"});
      add_lights(frame, camera, std::array{SkyLight{direction, {3e-6, 2e-6, 1e-6}}});
      const auto sum = sum_of(frame, camera);
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_WITHIN_RELATIVE(sum.lux[k], (3 - static_cast<double>(k)) * 1e-6, 5e-4,
                               "half floats: 2.4e-4 of each pixel");
      if (aside == 0) {
        EXPECT_WITHIN(sum.middle.x, place.x, 0.01, "half floats, and 0.1 % of a pixel's slope");
        EXPECT_WITHIN(sum.middle.y, place.y, 0.01, "half floats, and 0.1 % of a pixel's slope");
      }
    }
  }
}

/// Standard coordinates about the Moon [radians]: east to the left, north up, as on a chart.
glm::dvec2 on_chart(const almanac::SkyState& sky, const glm::dvec3& position_m) {
  const auto moon = almanac::equatorial_place(sky, sky.moon_m),
             there = almanac::equatorial_place(sky, position_m);
  const double d0 = algebra::in_radians(moon.declination),
               d = algebra::in_radians(there.declination);
  const double a = algebra::in_radians(there.right_ascension - moon.right_ascension);
  const double away = std::sin(d0) * std::sin(d) + std::cos(d0) * std::cos(d) * std::cos(a);
  return {-std::cos(d) * std::sin(a) / away,
          (std::cos(d0) * std::sin(d) - std::sin(d0) * std::cos(d) * std::cos(a)) / away};
}

TEST(SkyLights, MarsStandsBelowTheMoonOf2018AsOnAChart) {
  const auto& sky = totality_of_2018();
  auto request = wide(14, 700, 700);
  request.stars.faintest = -2;  // Mars alone
  const auto view = view_of(request, sky);
  const auto lights = sky_lights(view, sky);
  ASSERT_EQ(lights.size(), 64u) << "the points of Mars' disc";
  texture::Image frame(700, 700, {"R", "G", "B"});
  add_lights(frame, view.camera, lights);
  const auto sum = sum_of(frame, view.camera);
  for (const auto& planet : almanac::planets_at(sky.when)) {
    if (planet.name != "Mars") continue;
    const auto chart = on_chart(sky, planet.position_m) * (350 / std::tan(7 * degree));
    EXPECT_WITHIN(sum.middle.x, 350 + chart.x, 0.1, "a pixel is 72″; half floats");
    EXPECT_WITHIN(sum.middle.y, 350 - chart.y, 0.1, "a pixel is 72″; half floats");
  }
  EXPECT_GT(sum.middle.y, 600) << "six degrees south, north up";
  EXPECT_GT(sum.lux[0], 1.5 * sum.lux[2]) << "Mars is red";
}

TEST(SkyLights, TheMoonHidesUranusIn2022) {
  ViewRequest request{.observer = tokyo};
  request.stars.faintest = 5.8;
  const auto points_at = [&](const char* utc) {
    const auto sky = sky_of(utc);
    return sky_lights(view_of(request, sky), sky).size();
  };
  // Published: behind the Moon from 11:40 to 12:22, each with seconds cut off (planets_test)
  // A few stars stand beside the Moon too.
  EXPECT_GE(points_at("2022-11-08T11:39Z"), 64u);
  EXPECT_LT(points_at("2022-11-08T11:42Z"), 64u);
  EXPECT_LT(points_at("2022-11-08T12:21Z"), 64u);
  EXPECT_GE(points_at("2022-11-08T12:24Z"), 64u);
  request.observer.reset();
  EXPECT_GE(points_at("2022-11-08T12:00Z"), 64u) << "from the Earth's centre the Moon passes it by";
}

TEST(SkyLights, AreThoseThatAreWanted) {
  const auto& sky = totality_of_2018();
  auto request = wide(30, 300, 300);
  const auto count = [&] { return sky_lights(view_of(request, sky), sky).size(); };
  const auto all = count();
  request.stars.faintest = 4;
  const auto few = count();
  request.stars.shown = false;
  EXPECT_EQ(count(), 0u);
  EXPECT_LE(few, all);
  request.stars = {.shown = true, .faintest = 21};
  EXPECT_THROW(view_of(request, sky), algebra::Error);
}

TEST(SkyLights, AreThoseOfTheSky) {
  const auto& sky = totality_of_2018();
  auto request = wide(14, 700, 700);
  request.stars.faintest = 3.2;
  const auto view = view_of(request, sky);
  const auto lights = sky_lights(view, sky);
  // β Capricorni (Dabih, V = 3.05): the one star so bright within seven degrees. SIMBAD, J2000; its proper
  // motion is 0.05″ a year, and precession and aberration together are what the chart must hold.
  ASSERT_EQ(lights.size(), 64u + 1u);
  const double right_ascension = 15 * (20 + 21 / 60. + 0.675 / 3600) * degree,
               declination = -(14 + 46 / 60. + 52.98 / 3600) * degree;
  const glm::dvec3 star(std::cos(declination) * std::cos(right_ascension),
                        std::cos(declination) * std::sin(right_ascension), std::sin(declination));
  const auto chart = on_chart(sky, star) * (350 / std::tan(7 * degree));
  texture::Image frame(700, 700, {"R", "G", "B"});
  add_lights(frame, view.camera, std::span(lights).first(1));
  const auto sum = sum_of(frame, view.camera);
  EXPECT_WITHIN(sum.middle.x, 350 + chart.x, 0.3, "aberration, 20″, is 0.28 of a pixel");
  EXPECT_WITHIN(sum.middle.y, 350 - chart.y, 0.3, "aberration, 20″, is 0.28 of a pixel");
  EXPECT_WITHIN_RELATIVE(sum.lux[1], 2.54e-6 * std::pow(10, -0.4 * 3.05), 0.15,
                         "Allen: V = 0 gives 2.54e-6 lux; a yellow star, steps of 0.05 magnitude");
}

TEST(SkyLights, AreRaisedAsRefractionRaises) {
  const auto sky = sky_of("2018-07-27T20:22Z");
  const almanac::Observer low{algebra::degrees(45), algebra::degrees(7.7), {}};
  auto request = wide(20, 400, 400);
  request.observer = low;
  request.up = povray_scenes::Up::zenith;
  request.stars.faintest = -2;
  const auto raised = view_of(request, sky);
  request.flattening = false;
  const auto not_raised = view_of(request, sky);
  const auto height = [&](const View& view) {
    const auto lights = sky_lights(view, sky);
    texture::Image frame(400, 400, {"R", "G", "B"});
    add_lights(frame, view.camera, lights);
    return (200 - sum_of(frame, view.camera).middle.y) * std::atan(std::tan(10 * degree) / 200) /
           degree;
  };
  const auto seen = almanac::view_from(low, sky);
  const double moon_deg = algebra::in_degrees(seen.altitude);
  const double below = -height(not_raised);
  // Saemundsson's formula, by hand
  const auto refraction_deg = [](double altitude_deg) {
    return 1.02 / 60 / std::tan((altitude_deg + 10.3 / (altitude_deg + 5.11)) * degree);
  };
  EXPECT_WITHIN(height(raised) - height(not_raised),
                refraction_deg(moon_deg - below) - refraction_deg(moon_deg), 0.003,
                "Mars is at the side too: a fifth of the 0.02 degrees by which refraction differs");
}

TEST(StarLight, IsThatOfTheSunAndOfPublishedStars) {
  const auto luminance = [](const std::array<double, 3>& rgb) {
    return colour::luminance(colour::WorkingSpace::linear_rec709, rgb);
  };
  EXPECT_WITHIN(star_temperature_k(0.653), 5772, 15, "IAU 2015: the Sun's effective temperature");
  EXPECT_WITHIN_RELATIVE(luminance(StarLights().lux(-26.76, 0.653)), 133.1e3, 0.01,
                         "ASTM E490: 133.1 klx of sunlight above the air; a black body's shape");
  EXPECT_WITHIN_RELATIVE(luminance(StarLights().lux(0, 0)), 2.54e-6, 0.06,
                         "Allen's Astrophysical Quantities §26: 2.54e-6 lux; others have 2.65e-6");
  const auto blue = StarLights().lux(1, -0.2), red = StarLights().lux(1, 1.8);
  EXPECT_GT(blue[2], 1.2 * blue[0]);
  EXPECT_GT(red[0], 2 * red[2]);
}

TEST(StarLight, IsDimmedAndReddenedByAir) {
  const auto at_altitude = [](double degrees) {
    return StarLights(atmosphere::ObserverAir{}).lux(2, 0.6, algebra::degrees(degrees));
  };
  const auto above = StarLights().lux(2, 0.6), zenith = at_altitude(90), low = at_altitude(10);
  const auto dimmed_mag = [&](const auto& light) { return -2.5 * std::log10(light[1] / above[1]); };
  EXPECT_WITHIN(dimmed_mag(zenith), 0.25, 0.06, "usual extinction in V at sea level: 0.2 to 0.3");
  EXPECT_WITHIN(dimmed_mag(low) / dimmed_mag(zenith), 5.6, 0.3,
                "5.6 air masses at 10 degrees; bands");
  EXPECT_GT(low[0] / low[2], 1.5 * zenith[0] / zenith[2]);
}

TEST(LightsOver, AreTheSkyOfALandscape) {
  const auto& sky = totality_of_2018();
  const auto view = view_of({.observer = nairobi}, sky);
  const auto lights = lights_over(view, sky);
  ASSERT_GT(lights.size(), 2u);
  EXPECT_GT(lights.front().illuminance_lux[0], 2e-5) << "Mars, V = -2.8";
  for (const auto& light : lights) EXPECT_GT(algebra::in_degrees(light.place.altitude), 0);
}

TEST(LightsOver, StandWhereErfaHasThem) {
  // Vega: SIMBAD, ICRS, epoch 2000
  const double right_ascension = 15 * (18 + 36 / 60. + 56.33635 / 3600) * degree,
               declination = (38 + 47 / 60. + 1.2802 / 3600) * degree, mas = degree / 3.6e6;
  double azimuth, from_zenith, hour_angle, seen_declination, seen_right_ascension, origins;
  eraAtco13(right_ascension, declination, 200.94 * mas / std::cos(declination), 286.23 * mas, 0.130,
            0, 2458326.5, (20 + 22 / 60.) / 24, 0.07, 36.82 * degree, -1.28 * degree, 0, 0, 0, 0, 0,
            0, 0.5, &azimuth, &from_zenith, &hour_angle, &seen_declination, &seen_right_ascension,
            &origins);
  const double altitude_deg = 90 - from_zenith / degree;
  const double refraction_deg =
      1.02 / 60 / std::tan((altitude_deg + 10.3 / (altitude_deg + 5.11)) * degree);
  const auto lights =
      lights_over(view_of({.observer = nairobi}, totality_of_2018()), totality_of_2018());
  const auto off_deg = [&](const povray_scenes::StarInSky& light) {
    return std::hypot(algebra::in_degrees(light.place.altitude) - altitude_deg - refraction_deg,
                      algebra::in_degrees(light.place.azimuth) - azimuth / degree);
  };
  const auto vega = std::ranges::min_element(lights, {}, off_deg);
  EXPECT_WITHIN(off_deg(*vega), 0, 3e-4, "1″: eraAtco13 with UT1 and diurnal aberration");
  EXPECT_LT(vega - lights.begin(), 5) << "among the brightest";
}

}  // namespace coppermoon::uses::sky_lights_test
