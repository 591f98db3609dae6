// SPDX-License-Identifier: MIT
#include "texture/bake.h"

#include <tbb/global_control.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "eclipse/shadow_axis.h"
#include "shadow/by_quadrature.h"
#include "support/testing.h"
#include "surface/albedo_map.h"
#include "surface/ground.h"
#include "surface/photometry.h"

namespace coppermoon::texture::bake_test {

using enum surface::Photometry;

const auto february_2008 = almanac::instant_from_utc("2008-02-21T03:08:26Z");

algebra::Grid<float> uniform(std::size_t rows, float albedo = 0.1F) {
  return {rows, 2 * rows, albedo};
}

shadow::Lookup sunlight(double radiance) {
  return shadow::Lookup(shadow::ChannelWeights(1, 1, radiance));
}

std::size_t row_of(double latitude_deg, std::size_t rows) {
  return static_cast<std::size_t>((90 - latitude_deg) / 180 * static_cast<double>(rows));
}
std::size_t column_of(double longitude_deg, std::size_t rows) {
  return static_cast<std::size_t>((180 + longitude_deg) / 180 * static_cast<double>(rows));
}

TEST(Bake, LightsTheSubSolarPointByTheInverseSquareOfItsDistance) {
  const auto sky = almanac::sky_at(february_2008);
  const auto moon = bake({uniform(180), sky, sunlight(1000)}, {"Y"}, 180, yapo_cutler);
  const double sun_m = glm::length(sky.sun_m - sky.moon_m) - 1.7374e6;
  const double near = almanac::astronomical_unit_m / sun_m;
  const float lit = moon(row_of(algebra::in_degrees(sky.sub_solar.latitude), 180),
                         column_of(algebra::in_degrees(sky.sub_solar.longitude), 180), 0);
  EXPECT_WITHIN_RELATIVE(lit, 0.1 * 1000 * near * near, 1e-5,
                         "float texels; mu is 1 − 1e-4 within a texel, f 1 − 1e-5");
}

/// Value of the texel below the Sun, on even ground of albedo 0.3 twice as far from the Sun as the Earth is.
float below_a_far_sun(TexelQuantity quantity) {
  auto sky = almanac::sky_at(february_2008);
  const auto to_sun = glm::normalize(sky.sun_m - sky.moon_m);
  sky.sun_m = sky.moon_m + 2 * almanac::astronomical_unit_m * to_sun;  // as on an asteroid
  const std::size_t rows = 16;
  const auto light = sunlight(1000);
  const auto ground = uniform(rows, 0.3F);
  const auto lit = lit_rows({ground, sky, light}, rows, {yapo_cutler, Extent::whole, quantity});
  std::vector<float> values(2 * rows * rows);
  lit(0, values);
  return values[row_of(algebra::in_degrees(sky.sub_solar.latitude), rows) * 2 * rows +
                column_of(algebra::in_degrees(sky.sub_solar.longitude), rows)];
}

TEST(Bake, IrradianceIsThatOfTheSunAtItsDistanceWhateverTheGround) {
  EXPECT_WITHIN_RELATIVE(below_a_far_sun(TexelQuantity::irradiance), 1000. / 4, 1e-4,
                         "the inverse square; the lunar radius is 1e-5");
}

TEST(Bake, ReflectanceIsTheGroundsWhateverTheSunsDistance) {
  EXPECT_WITHIN_RELATIVE(below_a_far_sun(TexelQuantity::reflectance), 0.3 * 1000, 0.02,
                         "a texel of 11 degrees looks up to 8 away from the Sun");
}

TEST(Bake, FollowsThePhotometricFunctionAwayFromIt) {
  const auto sky = almanac::sky_at(february_2008);
  const std::size_t rows = 360;
  const auto moon = bake({uniform(rows), sky, sunlight(1)}, {"Y"}, rows, yapo_cutler);
  const auto sun = almanac::selenographic_direction(sky.sub_solar);
  for (const double longitude : {-70., -30., 20., 60., 80.}) {
    const std::size_t r = row_of(20, rows), c = column_of(longitude, rows);
    const double mu =
        glm::dot(almanac::selenographic_direction(surface::texel_centre(r, c, rows)), sun);
    const float at_sub_solar = moon(row_of(0.1, rows), column_of(5, rows), 0);
    EXPECT_WITHIN(moon(r, c, 0) / at_sub_solar,
                  surface::radiance_factor_at_full_moon(surface::Photometry::yapo_cutler, mu), 3e-4,
                  "the Sun's parallax over the Moon's radius: 1.2e-5 in mu, up to ten times that "
                  "in f; 2.3e-5 in distance");
  }
}

/// The Moon's centre: between the directions to the Sun and to the Earth's centre.
double phase_deg(const almanac::SkyState& sky) {
  const double cosine =
      glm::dot(glm::normalize(sky.sun_m - sky.moon_m), glm::normalize(-sky.moon_m));
  return std::acos(cosine) * 180 / std::numbers::pi;
}

/// 1 au over the distance from the Moon's centre to the Sun, squared.
double sunlight_at(const almanac::SkyState& sky) {
  return std::pow(almanac::astronomical_unit_m / glm::length(sky.sun_m - sky.moon_m), 2);
}

/// Mean over the disc as seen from far above the sub-Earth point.
double disc_mean(const Image& moon, const almanac::SkyState& sky) {
  const auto earth = almanac::selenographic_direction(sky.sub_earth);
  double sum = 0, area = 0;
  for (std::size_t r = 0; r < moon.height; ++r)
    for (std::size_t c = 0; c < moon.width; ++c) {
      const auto at = surface::texel_centre(r, c, moon.height);
      const double share = std::cos(algebra::in_radians(at.latitude)) *
                           std::max(0., glm::dot(almanac::selenographic_direction(at), earth));
      sum += share * moon(r, c, 0);
      area += share;
    }
  return sum / area;
}

TEST(Bake, GivesTheFullMoonsDiscTheLuminanceOfItsAlbedo) {
  const auto sky = almanac::sky_at(almanac::instant_from_utc("2008-02-21T00:36:00Z"));
  ASSERT_NEAR(phase_deg(sky), 1.5, 0.02);
  const auto moon = bake({uniform(180), sky, sunlight(1000)}, {"Y"}, 180, lommel_seeliger_rolo);
  EXPECT_WITHIN_RELATIVE(disc_mean(moon, sky), 0.1 * 1000 * sunlight_at(sky), 3e-3,
                         "0.01 degrees of phase are 1e-3; 0.9e-3 is dark at the limb; texels");
}

TEST(Bake, DimsTheDiscAsRoloMeasuredWhenThePhaseGrows) {
  // Eleven hours after full Moon. ROLO, the mean of 544.0, 549.1, 553.8 nm: 0.1203 at 3 degrees,
  // 0.1075 at 5, and 0.1347 at 1.5.
  const auto sky = almanac::sky_at(almanac::instant_from_utc("2008-02-21T13:20:00Z"));
  const double phase = phase_deg(sky);
  ASSERT_NEAR(phase, 5, 0.3);
  const auto moon = bake({uniform(180), sky, sunlight(1000)}, {"Y"}, 180, lommel_seeliger_rolo);
  const double rolo = (0.1075 + (phase - 5) * (0.0985 - 0.1203) / 4) / 0.1347;
  EXPECT_WITHIN_RELATIVE(disc_mean(moon, sky) / (0.1 * 1000 * sunlight_at(sky)), rolo, 0.01,
                         "the slope from 3 to 7 degrees, 5 %/degree, over 0.3 degrees at most");
}

TEST(Bake, LightsTheEclipsedMoonFromTheEarthsLimb) {
  // The Earth's angular radius is asin(6378.137 / (383600 − 1737)) = 0.957 degrees; the Sun's
  // centre is behind it.
  const auto sky = almanac::sky_at(almanac::instant_from_utc("2008-02-21T03:26:05Z"));
  ASSERT_LT(phase_deg(sky), 0.5);
  const auto moon = bake({uniform(180), sky, sunlight(1)}, {"Y"}, 180, lommel_seeliger_rolo);
  const double surge =
      surface::radiance_factor(lommel_seeliger_rolo, 1, 1, algebra::degrees(0.957));
  ASSERT_GT(surge, 1.04);
  for (const double longitude : {-60., -20., 5., 40., 70.})
    EXPECT_WITHIN_RELATIVE(
        moon(row_of(10, 180), column_of(longitude, 180), 0), 0.1 * surge * sunlight_at(sky), 0.012,
        "mu0 and mu differ by tan(70) times the phase, 0.02 at most, half of it in f");
}

TEST(Bake, GoesOnWithoutAStepBeyondWhatTheEarthSees) {
  // A Moon three days past full: its eastern limb is night, its western one lit beyond the horizon.
  const auto sky = almanac::sky_at(almanac::instant_from_utc("2008-02-24T03:26:05Z"));
  ASSERT_GT(phase_deg(sky), 30);
  const std::size_t rows = 360;
  const auto moon = bake({uniform(rows), sky, sunlight(1000)}, {"Y"}, rows, lommel_seeliger_rolo);
  for (double longitude = -110; longitude < -60; longitude += 0.5) {
    const std::size_t r = row_of(0.1, rows), c = column_of(longitude + 0.1, rows);
    ASSERT_GT(moon(r, c, 0), 0);
    EXPECT_WITHIN_RELATIVE(moon(r, c + 1, 0), moon(r, c, 0), 0.03,
                           "half a degree of mu, 0.009, beside mu0 of 0.5 at the limb");
  }
}

TEST(Bake, LeavesTheFarSideDark) {
  const auto moon =
      bake({uniform(90), almanac::sky_at(february_2008), sunlight(1)}, {"Y"}, 90, yapo_cutler);
  EXPECT_EQ(moon(45, 0, 0), 0);
  EXPECT_EQ(moon(45, 179, 0), 0);
  EXPECT_GT(moon(45, 90, 0), 0);
}

TEST(Bake, DarkensTheSideThatIsDeeperInTheShadow) {
  // At 03:08 the Moon has just entered: it moves east, so its eastern (celestial) limb is deepest;
  // the Moon is south of the axis, so north is deeper than south. Celestial east is the Moon's
  // western hemisphere, longitude negative.
  const auto sky = almanac::sky_at(february_2008);
  const std::vector<double> waves{600};
  std::vector<double> distances;
  for (double d = 0; d < 9e6; d += 1e5) distances.push_back(d);
  const auto light = shadow::by_quadrature({}, {1.479e11, {3.82e8, 3.83e8}}, waves, distances);
  const shadow::DirectLight direct({}, light.arrangement, waves);
  const shadow::Lookup lookup(light, direct, shadow::ChannelWeights(1, 1, 1));
  const auto moon = bake({uniform(180), sky, lookup}, {"Y"}, 180, yapo_cutler);
  const auto at = [&](double latitude, double longitude) {
    return moon(row_of(latitude, 180), column_of(longitude, 180), 0);
  };
  EXPECT_LT(at(50, -50), at(0, 0));
  EXPECT_LT(at(0, 0), at(-50, 50));
  EXPECT_LT(at(0, -60), at(0, 60));
  EXPECT_LT(at(60, 0), at(-60, 0));
}

/// Refracted and direct light over the whole shadow, three channels.
shadow::Lookup eclipse_light() {
  const std::vector<double> waves{450, 550, 650};
  std::vector<double> distances;
  for (double d = 0; d < 9.4e6; d += 5e4) distances.push_back(d);
  const auto light = shadow::by_quadrature({}, {1.479e11, {3.80e8, 3.82e8, 3.84e8}}, waves,
                                           distances, {.rays = 100});
  const shadow::DirectLight direct({}, light.arrangement, waves);
  shadow::ChannelWeights each(3, 3);
  for (std::size_t c = 0; c < 3; ++c) each(c, c) = 1000;
  return shadow::Lookup(light, direct, each);
}

/// The docstring's expression for one texel, by way of the photometric function and of the shadow's
/// axis, one vector at a time.
std::vector<double> expected_texel(const almanac::SkyState& sky, const shadow::Lookup& light,
                                   const almanac::SelenographicPoint& at, double albedo,
                                   surface::Photometry photometry) {
  std::vector<double> values(light.channels());
  const glm::dvec3 normal =
      glm::transpose(sky.selenographic_from_gcrs) * almanac::selenographic_direction(at);
  const glm::dvec3 place = sky.moon_m + 1737.4e3 * normal, to_sun = sky.sun_m - place;
  const double sun_m = glm::length(to_sun), earth_m = glm::length(place);
  const double phase =
      std::max(std::atan2(glm::length(glm::cross(to_sun, -place)), glm::dot(to_sun, -place)),
               std::asin(6378.137e3 / earth_m));
  const double factor =
      surface::radiance_factor(photometry, glm::dot(normal, to_sun) / sun_m,
                               -glm::dot(normal, place) / earth_m, algebra::radians(phase));
  light.read(eclipse::place_in_shadow(eclipse::shadow_axis(sky), place), values);
  for (double& value : values)
    value *= albedo * factor * std::pow(almanac::astronomical_unit_m / sun_m, 2);
  return values;
}

algebra::Grid<float> spotted(std::size_t rows) {
  auto map = uniform(rows);
  for (std::size_t i = 0; i < map.values().size(); ++i)
    map.values()[i] = 0.05F + 0.001F * static_cast<float>(i * 7919 % 100);
  return map;
}

TEST(Bake, IsItsExpressionAtEveryTexel) {
  constexpr std::size_t rows = 90;
  const auto map = spotted(rows);
  const auto light = eclipse_light();
  for (const char* when : {"2008-02-21T03:26:05Z", "2008-02-21T02:10:00Z", "2008-02-24T03:26:05Z"})
    for (const auto photometry : {yapo_cutler, lommel_seeliger_rolo}) {
      const auto sky = almanac::sky_at(almanac::instant_from_utc(when));
      const auto moon = bake({map, sky, light}, {"R", "G", "B"}, rows, photometry);
      for (std::size_t r = 0; r < rows; ++r)
        for (std::size_t c = 0; c < 2 * rows; ++c) {
          const auto expected =
              expected_texel(sky, light, surface::texel_centre(r, c, rows), map(r, c), photometry);
          for (std::size_t k = 0; k < 3; ++k)
            EXPECT_WITHIN_RELATIVE(moon(r, c, k), expected[k], 1e-5,
                                   "the phase curve between its table's entries; float texels");
        }
    }
}

TEST(Bake, IsTheSameHoweverItIsCutIntoRowsAndThreads) {
  constexpr std::size_t rows = 150;
  const auto sky = almanac::sky_at(february_2008);
  const auto map = spotted(64);
  const auto light = eclipse_light();
  const auto whole = bake({map, sky, light}, {"R", "G", "B"}, rows, lommel_seeliger_rolo);
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const auto lit = lit_rows({map, sky, light}, rows, {lommel_seeliger_rolo});
  std::vector<float> band(7 * 2 * rows * 3);
  for (std::size_t r = 0; r + 7 <= rows; r += 7) {
    lit(r, band);
    EXPECT_TRUE(std::equal(band.begin(), band.end(), &whole.values[r * 2 * rows * 3])) << r;
  }
}

TEST(Bake, LeavesOutOnlyWhatNoPlaceOnEarthSees) {
  // Three days past full: a fifth of the lit half is beyond the limb.
  constexpr std::size_t rows = 180;
  const auto sky = almanac::sky_at(almanac::instant_from_utc("2008-02-24T03:26:05Z"));
  const auto map = uniform(rows);
  const auto light = sunlight(1);
  const auto whole = bake({map, sky, light}, {"Y"}, rows, yapo_cutler);
  std::vector<float> seen(whole.values.size());
  lit_rows({map, sky, light}, rows, {yapo_cutler, Extent::seen_from_earth})(0, seen);
  std::size_t left_out = 0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const auto at = surface::texel_centre(i / (2 * rows), i % (2 * rows), rows);
    const glm::dvec3 normal =
        glm::transpose(sky.selenographic_from_gcrs) * almanac::selenographic_direction(at);
    const double up = -glm::dot(normal, glm::normalize(sky.moon_m + 1737.4e3 * normal));
    const bool needed = up > -0.02 - 6378.0 / 360e3, far_beyond = up < -0.1;
    EXPECT_TRUE(!needed || seen[i] == whole.values[i]) << up;
    EXPECT_TRUE(!far_beyond || seen[i] == 0) << up;
    left_out += seen[i] == 0 && whole.values[i] > 0;
  }
  EXPECT_GT(left_out, seen.size() / 20);
}

TEST(Resized, LargerIsBilinear) {
  const auto map = spotted(9);
  const auto large = resized(map, 40);
  for (std::size_t r = 0; r < 40; ++r)
    for (std::size_t c = 0; c < 80; ++c)
      EXPECT_WITHIN(large(r, c), surface::sampled(map, surface::texel_centre(r, c, 40)), 1e-7,
                    "float texels");
}

TEST(Resized, KeepsTheMeanOfASmallerMap) {
  algebra::Grid<float> map(7 * 9, 14 * 9);
  for (std::size_t i = 0; i < map.values().size(); ++i)
    map.values()[i] = static_cast<float>((i * 7919) % 101);
  const auto mean = [](const algebra::Grid<float>& m) {
    return std::accumulate(m.values().begin(), m.values().end(), 0.) /
           static_cast<double>(m.values().size());
  };
  for (const std::size_t rows : {2U, 7U, 10U, 62U})
    EXPECT_WITHIN_RELATIVE(mean(resized(map, rows)), mean(map), 1e-5, "float texels");
}

TEST(Resized, ToItsOwnSizeIsTheMap) {
  algebra::Grid<float> map(3, 6);
  map(1, 4) = 2;
  EXPECT_EQ(resized(map, 3)(1, 4), 2);
}

TEST(Resized, KeepsAPointInItsPlaceWhenLarger) {
  algebra::Grid<float> map(10, 20);
  map(3, 14) = 1;
  const auto large = resized(map, 50);
  double x = 0, y = 0, sum = 0;
  for (std::size_t r = 0; r < 50; ++r)
    for (std::size_t c = 0; c < 100; ++c) {
      sum += large(r, c);
      x += large(r, c) * (static_cast<double>(c) + 0.5);
      y += large(r, c) * (static_cast<double>(r) + 0.5);
    }
  EXPECT_WITHIN(x / sum / 5, 14.5, 1e-5, "bilinear weights are symmetric");
  EXPECT_WITHIN(y / sum / 5, 3.5, 1e-5, "bilinear weights are symmetric");
}

TEST(Resized, RefusesWhatIsNoMap) {
  EXPECT_THROW(resized(algebra::Grid<float>(10, 10), 5), algebra::Error);
  EXPECT_THROW(resized(uniform(4), 1), algebra::Error);
  EXPECT_THROW(resized(uniform(4), 20000), algebra::Error);
}

/// Light of which the reddest ground and the bluest make something else: [first, second, first, second].
shadow::Lookup two_grounds() {
  shadow::ChannelWeights weights(4, 1);
  for (std::size_t c = 0; c < 4; ++c) weights(c, 0) = std::array{100., 40., 60., 80.}[c];
  return shadow::Lookup(weights);
}

TEST(Bake, MixesTheReddestAndTheBluestGroundByItsColour) {
  const auto sky = almanac::sky_at(february_2008);
  const std::size_t rows = 36;
  surface::Ground ground{uniform(rows, 0), uniform(rows, 0)};
  for (std::size_t c = 0; c < 2 * rows; ++c)
    for (std::size_t r = 0; r < rows; ++r)
      ground.colour(r, c) = 0.0015F * static_cast<float>(c) - 0.05F;
  const auto map = uniform(rows);
  const auto light = two_grounds();
  const auto grey = bake({map, sky, sunlight(1)}, {"Y"}, rows, lommel_seeliger_rolo);
  const auto moon = bake({map, sky, light, &ground}, {"A", "B"}, rows, lommel_seeliger_rolo);
  for (const std::size_t c : {24UL, 36UL, 50UL}) {
    const double share = 0.5 + ground.colour(18, c) / 0.3;
    EXPECT_WITHIN_RELATIVE(moon(18, c, 0) / grey(18, c, 0), 100 - 40 * share, 1e-6, "floats");
    EXPECT_WITHIN_RELATIVE(moon(18, c, 1) / grey(18, c, 0), 40 + 40 * share, 1e-6, "floats");
  }
}

TEST(Bake, GivesGroundItsOwnSurge) {
  const auto sky = almanac::sky_at(almanac::instant_from_utc("2008-02-25T00:00:00Z"));
  ASSERT_GT(phase_deg(sky), 40);
  const std::size_t rows = 36;
  const surface::Ground ground{uniform(rows, 0), uniform(rows, 0.3F)};
  const auto map = uniform(rows);
  const auto light = two_grounds();
  const auto grey = bake({map, sky, sunlight(80)}, {"Y"}, rows, lommel_seeliger_rolo);
  const auto moon = bake({map, sky, light, &ground}, {"A", "B"}, rows, lommel_seeliger_rolo);
  const double slope = surface::surge_slope(lommel_seeliger_rolo, algebra::degrees(phase_deg(sky)));
  EXPECT_WITHIN_RELATIVE(moon(18, 36, 0) / grey(18, 36, 0), 1 + 0.3 * slope, 1e-3,
                         "the phase of a place differs from the middle's by 0.3 degrees");
}

}  // namespace coppermoon::texture::bake_test
