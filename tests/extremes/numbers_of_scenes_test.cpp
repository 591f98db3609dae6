// SPDX-License-Identifier: MIT
// Dates, places, texels and exposures pushed over every edge.
#include <glm/geometric.hpp>

#include "algebra/random.h"
#include "almanac/observer.h"
#include "atmosphere/air_mass.h"
#include "atmosphere/astronomical_refraction.h"
#include "atmosphere/observer_air.h"
#include "baker/texture/scratch_folder.h"
#include "colour/display.h"
#include "colour/exposure.h"
#include "colour/photograph.h"
#include "colour/point_spread.h"
#include "eclipse/contacts.h"
#include "extremes/worst.h"
#include "support/testing.h"
#include "surface/albedo_map.h"
#include "surface/photometry.h"
#include "texture/bake.h"
#include "texture/globe.h"
#include "texture/read_image.h"
#include "texture/write_image.h"

namespace coppermoon::extremes::numbers_of_scenes_test {

using almanac::instant_from_utc;
using almanac::LunarTheory;
using eclipse::ShadowConvention;

bool finite(const glm::dvec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

TEST(Almanac, IsFiniteAndReadsItsOwnDatesFromMinus1999To3000) {
  Worst worst;
  for (const char* text :
       {"-1999-01-01T00:00:00.000Z", "-1000-02-28T12:00:00.000Z", "0000-01-01T00:00:00.000Z",
        "0001-12-31T23:59:59.999Z", "1582-10-15T00:00:00.000Z", "1971-12-31T23:59:59.900Z",
        "1972-01-01T00:00:00.000Z", "2016-12-31T23:59:60.500Z", "3000-12-31T23:59:59.999Z"})
    for (const auto theory : {LunarTheory::moon98, LunarTheory::elp_2000_82b}) {
      const auto sky = almanac::sky_at(instant_from_utc(text), theory);
      EXPECT_TRUE(finite(sky.sun_m) && finite(sky.moon_m)) << text;
      EXPECT_EQ(almanac::utc_text(sky.when, 3), text);
      const double moon_m = glm::length(sky.moon_m), sun_m = glm::length(sky.sun_m);
      EXPECT_TRUE(moon_m > 3.55e8 && moon_m < 4.08e8) << text << " " << moon_m;
      worst.see(std::abs(sun_m / almanac::astronomical_unit_m - 1));
    }
  holds("the sky of the years -1999 to 3000, both theories", "the Sun's distance less 1 au, in au",
        0.0195, worst, "the Earth's orbit was never rounder: e = 0.0185 in -1999");
  for (const char* text : {"-2000-12-31T23:59:59Z", "3001-01-01T00:00:00Z", "nan", ""})
    is_refused(fmt::format("the date \"{}\"", text), [&] { instant_from_utc(text); });
}

double in_order_s(const eclipse::Eclipse& one) {
  const auto& [P1, U1, U2, U3, U4, P4] = one.contacts;
  double least = std::numeric_limits<double>::max();
  std::optional<almanac::Instant> before;
  for (const auto& contact : {P1, U1, U2, std::optional(one.greatest), U3, U4, P4}) {
    if (!contact) continue;
    if (before) least = std::min(least, almanac::seconds_between(*before, *contact));
    before = contact;
  }
  return least;
}

TEST(Eclipses, OfTheFirstAndTheLastYearsHaveTheirContactsInOrder) {
  std::size_t found = 0;
  for (const auto& [from, to] :
       {std::pair{"-1999-01-01", "-1996-01-01"}, std::pair{"2998-01-01", "3000-12-31"}})
    for (const auto convention : {ShadowConvention::danjon, ShadowConvention::danjon_oblate,
                                  ShadowConvention::chauvenet, ShadowConvention::herald_sinnott})
      for (const auto& one : eclipses_between(instant_from_utc(from), instant_from_utc(to),
                                              convention, LunarTheory::moon98)) {
        ++found;
        ASSERT_TRUE(one.contacts.P1 && one.contacts.P4);
        EXPECT_GT(in_order_s(one), 0) << almanac::utc_text(one.greatest);
        EXPECT_TRUE(std::isfinite(one.gamma) && std::abs(one.gamma) < 1.6);
      }
  EXPECT_GE(found, 4 * 2 * 3 * 2U) << "two eclipses a year at least";
  tried("eclipses of -1999 to -1997 and of 2998 to 3000", "contacts in order, gamma within 1.6");
}

almanac::ObserverView seen(double latitude_deg, double longitude_deg, double elevation_m = 0) {
  static const auto sky = almanac::sky_at(instant_from_utc("2008-02-21T03:26:05Z"));
  return view_from({algebra::degrees(latitude_deg), algebra::degrees(longitude_deg),
                    algebra::metres(elevation_m)},
                   sky);
}

TEST(Observers, AtThePolesAndOnTheDateLineAreWhereTheyAreWhateverTheLongitudeIsCalled) {
  Worst metres, turn;
  for (const double pole : {-90., 90.})
    for (const double longitude : {-360., -180., -77., 0., 123., 180., 360.}) {
      const auto view = seen(pole, longitude), same = seen(pole, 0);
      metres.see(glm::distance(view.position_m, same.position_m));
      turn.see(std::abs(algebra::in_radians(view.altitude - same.altitude)));
    }
  for (const double latitude : {-90., -60., 0., 45., 90.}) {
    const auto east = seen(latitude, 180), west = seen(latitude, -180);
    metres.see(glm::distance(east.position_m, west.position_m));
    turn.see(std::abs(algebra::in_radians(east.altitude - west.altitude)));
    turn.see(std::abs(std::sin(algebra::in_radians(east.azimuth - west.azimuth))));
    turn.see(
        std::abs(std::sin(algebra::in_radians(east.parallactic_angle - west.parallactic_angle))));
  }
  holds("observers at both poles, and at 180 degrees east and west", "the same place [m]", 1e-8,
        metres, "rounding of 6.4e6 m");
  holds("the same", "the same altitude, azimuth and parallactic angle [rad]", 1e-13, turn,
        "rounding");
  is_refused("a latitude of 90.0001 degrees", [] { seen(90.0001, 0); });
  is_refused("a longitude of 361 degrees", [] { seen(0, 361); });
}

struct Geographic {
  double latitude_deg, longitude_deg;
};

/// The place that has the Moon in its zenith: the zeniths of three places are the Earth's axes.
Geographic under_the_moon() {
  const auto x = seen(0, 0).zenith, y = seen(0, 90).zenith, z = seen(90, 0).zenith;
  Geographic at{0, 0};
  for (int round = 0; round < 20; ++round) {
    const auto here = seen(at.latitude_deg, at.longitude_deg);
    static const auto moon_m = almanac::sky_at(instant_from_utc("2008-02-21T03:26:05Z")).moon_m;
    const auto up = glm::normalize(moon_m - here.position_m);
    at = {std::asin(glm::dot(up, z)) * 180 / std::numbers::pi,
          std::atan2(glm::dot(up, y), glm::dot(up, x)) * 180 / std::numbers::pi};
  }
  return at;
}

TEST(Observers, WithTheMoonInTheZenithSeeItThereAndNotNowhere) {
  const auto under = under_the_moon();
  Worst worst;
  for (int i = 0; i < 2000; ++i) {
    const double off_deg = 1e-13 * std::pow(1.01, i);
    const auto view = seen(under.latitude_deg + off_deg, under.longitude_deg);
    const double zenith_distance = std::numbers::pi / 2 - algebra::in_radians(view.altitude);
    worst.see(std::abs(zenith_distance - off_deg * std::numbers::pi / 180 * 1.0168));
    EXPECT_TRUE(std::isfinite(algebra::in_radians(view.azimuth)) &&
                std::isfinite(algebra::in_radians(view.parallactic_angle)));
  }
  holds("the Moon in the zenith, 1e-13 to 5e-5 degrees off it", "its distance from there [rad]",
        1e-10, worst, "parallax adds 1.7 % to what the place moves; 1e-4 of that, and rounding");
}

TEST(Observers, WithTheMoonOnTheHorizonSeeItDimmedAndFlattened) {
  const auto under = under_the_moon();
  double near_deg = 80, far_deg = 100;
  for (int i = 0; i < 60; ++i) {
    const double middle = (near_deg + far_deg) / 2;
    const auto view = seen(under.latitude_deg, under.longitude_deg - middle);
    (algebra::in_radians(view.altitude) > 0 ? near_deg : far_deg) = middle;
  }
  const auto altitude = seen(under.latitude_deg, under.longitude_deg - near_deg).altitude;
  Worst horizon, mass;
  horizon.see(std::abs(algebra::in_radians(altitude)));
  mass.see(std::abs(atmosphere::air_mass_young_1994(altitude) / 31.735 - 1));
  holds("the Moon on the horizon", "its altitude [rad]", 1e-12, horizon, "bisected to rounding");
  holds("the same", "Young's air mass, over his 0.0096467/0.000303978", 1e-4, mass, "five digits");
  for (double degrees = -1; degrees <= 90; degrees += 0.13) {
    const auto at = algebra::degrees(degrees);
    for (const double exponent : {-1., 0., 1., 4.})
      for (const double depth : {0., 1e-12, 1., 10.})
        for (const double elevation_m : {-500., 0., 1e5})
          for (const double nm : {380., 780.}) {
            const double light = atmosphere::transmittance_above(
                {1000, depth, exponent, elevation_m}, at, algebra::nanometres(nm));
            ASSERT_TRUE(light >= 0 && light <= 1) << degrees << " " << light;
          }
    const double flat = atmosphere::refracted_flattening(at, algebra::degrees(0.5));
    ASSERT_TRUE(flat > 0.8 && flat <= 1.000001) << degrees << " " << flat;
  }
  tried("air above the observer: aerosol 0 to 10, exponents -1 to 4, -500 m to 100 km",
        "lets through 0 to 1 from -1 degree to the zenith");
}

TEST(Exposures, FollowTheirLawToTheirEnds) {
  Worst worst;
  for (const double t : {1e-6, 1., 1e6})
    for (const double n : {0.5, 8., 512.})
      for (const double iso : {1., 100., 1e7})
        worst.see_relative(colour::exposure_scale({t, n, iso}), 0.65 * t * iso / (78 * n * n));
  holds("exposures of 1e-6 to 1e6 s, f/0.5 to f/512, ISO 1 to 1e7", "0.65 t S/(78 N^2), over it",
        1e-15, worst, "rounding");
  is_refused("an exposure of 9e-7 s", [] { colour::exposure_scale({9e-7, 8, 100}); });
  is_refused("an exposure of 1.1e6 s", [] { colour::exposure_scale({1.1e6, 8, 100}); });
  is_refused("ISO 0.9", [] { colour::exposure_scale({1, 8, 0.9}); });
  is_refused("ISO 1.1e7", [] { colour::exposure_scale({1, 8, 1.1e7}); });
}

/// A number of a range: one time in four each its ends, else evenly in its logarithm or, of one
/// from 0, evenly.
double anywhere(algebra::Random& random, double low, double high) {
  const double which = random.uniform(), share = random.uniform();
  if (which < 0.25) return low;
  if (which < 0.5) return high;
  return low > 0 ? low * std::pow(high / low, share) : share * high;
}

colour::Camera random_camera(algebra::Random& random) {
  const auto names = colour::response_names();
  const int bits = static_cast<int>(std::round(anywhere(random, 1, 16)));
  return {
      .optics = {anywhere(random, 1, 1e6), anywhere(random, 0.1, 1e5), anywhere(random, 0, 0.9),
                 anywhere(random, 0.01, 1)},
      .sensor =
          {anywhere(random, 0.1, 1000), anywhere(random, 0.1, 1000), anywhere(random, 1e-3, 1),
           anywhere(random, 10, 1e9), anywhere(random, 0, 1e4), anywhere(random, 0, 1e4),
           anywhere(random, 0, std::exp2(bits - 1)), bits,
           names[static_cast<std::size_t>(random.uniform() * static_cast<double>(names.size()))]},
      .seeing_arcsec = anywhere(random, 0, 600),
      .glow = anywhere(random, 0, 0.5),
      .diffraction = random.uniform() < 0.5,
      .noise = random.uniform() < 0.5};
}

TEST(Cameras, OfAnyPartsTakeColoursOrAreRefused) {
  constexpr std::uint64_t seed = 11, cameras = 600;
  colour::Image scene(3, 3);
  for (std::size_t i = 0; i < scene.values().size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      scene.values()[i][k] = std::array{0.F, 1e-30F, 1e-3F, 1.F, 65504.F}[(i + k) % 5];
  std::size_t taken = 0;
  std::string refusal;
  for (std::uint64_t i = 0; i < cameras; ++i) {
    algebra::Random random(seed, i);
    const auto camera = random_camera(random);
    const colour::Shot shot{.exposure = {anywhere(random, 1e-6, 1e6), anywhere(random, 0.5, 512),
                                         anywhere(random, 1, 1e7)},
                            .pixel_rad = anywhere(random, 1e-9, 1e-2),
                            .sky_cd_m2 = anywhere(random, 0, 1e5),
                            .seed = i};
    try {
      const auto photograph = photographed(scene, colour::WorkingSpace::acescg, camera, shot);
      ++taken;
      EXPECT_TRUE(std::isfinite(photograph.saturation_cd_m2) && photograph.saturation_cd_m2 > 0)
          << seed << " " << i;
      for (const auto& pixel : photograph.scene_linear.values())
        for (const float value : pixel) ASSERT_TRUE(std::isfinite(value)) << seed << " " << i;
      for (const auto& raw : photograph.raw.values())
        for (const auto number : raw) ASSERT_LT(number, std::exp2(camera.sensor.bits));
    } catch (const algebra::Error& error) {
      refusal = error.what();
      EXPECT_TRUE(refusal.starts_with("white of the sensor at ISO")) << refusal;
    }
  }
  EXPECT_GT(taken, cameras / 2);
  tried(
      fmt::format("{} of {} random cameras, each part at an end or between; f/0.5 to f/512, ISO 1 "
                  "to 1e7, 1 us to 11 days",
                  taken, cameras),
      "finite colours, raw numbers within the sensor's bits");
  refused("the others, such as one whose pixels are full before the converter counts 1", refusal);
}

TEST(Blurs, OfAnyWidthKeepAnEvenSkyEvenAndAPointsLight) {
  constexpr std::size_t side = 9;
  const algebra::Grid<double> even(side, side, 0.3);
  algebra::Grid<double> point(side, side);
  point(side / 2, side / 2) = 1;
  Worst unevenness, light;
  for (const double pixel_rad : {1e-12, 1e-6, 1.})
    for (const double seeing_rad : {0., 1e-15, 2e-8, 3.2e-8, 1e-6, 1e-2})
      for (const double diameter_m : {1e-5, 0.1, 100.})
        for (const double wavelength_nm : {0., 550.})
          for (const double obstruction : {0., 0.9}) {
            const colour::Blur blur{{diameter_m, obstruction}, wavelength_nm, seeing_rad};
            const auto of_even = blurred(even, blur, pixel_rad);
            for (const double value : of_even.values()) unevenness.see_relative(value, 0.3);
            const auto of_point = blurred(point, blur, pixel_rad);
            double sum = 0;
            for (const double value : of_point.values()) {
              EXPECT_GE(value, 0);
              sum += value;
            }
            light.see(std::max(0., sum - 1));
          }
  holds("pixels of 1e-12 to 1 rad, seeing of 0 to 1e-2 rad, apertures of 0.01 mm to 100 m",
        "an even sky, over itself", 1e-9, unevenness, "the transforms', as blurred states");
  holds("the same", "a point's light beyond what it was", 1e-9, light, "the transforms'");
}

TEST(Colours, ThatAreBlackOrNearlyStayColours) {
  using enum colour::WorkingSpace;
  for (const auto space : {linear_rec709, acescg, ciexyz_d65})
    for (const double value : {0., -0., 5e-324, 1e-310, 1e-30, 1e30}) {
      for (auto rgb : {std::array{value, value, value}, std::array{value, 0., 0.},
                       std::array{0., value, -value / 1e3}}) {
        if (!(colour::luminance(space, rgb) >= 0)) continue;
        into_gamut(space, rgb);
        EXPECT_TRUE(std::ranges::all_of(rgb, [](double x) { return x >= 0 && std::isfinite(x); }))
            << value;
      }
    }
  const colour::Image black(2, 2);
  for (const double scale :
       {colour::exposure_scale({1e-6, 512, 1}), colour::exposure_scale({1e6, 0.5, 1e7})}) {
    const auto picture = colour::developed(black, linear_rec709, {.scale = scale});
    for (const auto& pixel : picture.values())
      for (const float x : pixel) EXPECT_EQ(x, 0);
  }
  tried("black, 5e-324, 1e30, brought into a gamut; black developed by both extreme exposures",
        "colours without a NaN");
}

using Half = ScratchFolder;

TEST_F(Half, KeepsEveryNumberToItsStepFromItsFloorToItsCeilingAndRefusesMore) {
  const std::vector<float> values{0,       1e-45F,    1e-38F, 2.9e-8F,  3.1e-8F, 5.96e-8F,
                                  6.1e-5F, 6.104e-5F, 1e-3F,  65503.9F, 65504.F};
  texture::Image image(values.size(), 1, {"Y"});
  image.values = values;
  texture::write_exr(in_folder("half.exr"), image, {});
  const auto back = texture::read_image(in_folder("half.exr"));
  Worst worst;
  for (std::size_t i = 0; i < values.size(); ++i)
    worst.see(std::abs(back.values[i] - values[i]) / std::max(0x1p-24F, values[i] * 0x1p-10F));
  holds("half floats from 1e-45 to 65504", "what is read, in steps of 6e-8 or 11 bits", 0.5, worst,
        "half a step");
  const auto written = [&](float value) {
    texture::Image one(1, 1, {"Y"});
    one.values[0] = value;
    texture::write_exr(in_folder("one.exr"), one, {});
  };
  written(1);
  EXPECT_EQ(texture::read_image(in_folder("one.exr")).values, std::vector{1.F});
  tried("an image of one texel", "written and read");
  is_refused("65504.01 in a half", [&] { written(std::nextafter(65504.F, 1e9F)); });
  is_refused("65520, which rounds to infinity", [&] { written(65520); });
  is_refused("-6e-8 in a half", [&] { written(-6e-8F); });
  is_refused("no number in a half", [&] { written(std::numeric_limits<float>::quiet_NaN()); });
}

almanac::SkyState moved(double moon_distance, double sun_distance) {
  static const auto real = almanac::sky_at(instant_from_utc("2008-02-21T03:26:05Z"));
  auto sky = real;
  sky.moon_m *= moon_distance;
  sky.sun_m *= sun_distance;
  return sky;
}

/// The expression of bake.h, texel by texel, from vectors.
double by_vectors(const almanac::SkyState& sky, std::size_t row, std::size_t column,
                  std::size_t rows, surface::Photometry photometry) {
  const glm::dvec3 normal =
      glm::transpose(sky.selenographic_from_gcrs) *
      almanac::selenographic_direction(surface::texel_centre(row, column, rows));
  const glm::dvec3 at = sky.moon_m + algebra::in_metres(almanac::lunar_radius) * normal;
  const glm::dvec3 to_sun = glm::normalize(sky.sun_m - at), to_earth = glm::normalize(-at);
  const double cosine = std::clamp(glm::dot(to_sun, to_earth), -1., 1.);
  const double phase = std::max(std::acos(cosine),
                                std::asin(atmosphere::earth_equatorial_radius_m / glm::length(at)));
  if (glm::dot(normal, to_sun) <= 0) return 0;
  return radiance_factor(photometry, glm::dot(normal, to_sun),
                         std::max(0., glm::dot(normal, to_earth)), algebra::radians(phase)) *
         std::pow(almanac::astronomical_unit_m / glm::distance(sky.sun_m, at), 2);
}

TEST(Texels, AreTheExpressionInDoublePrecisionWhereverSunAndMoonStand) {
  constexpr std::size_t rows = 45;
  const algebra::Grid<float> white(rows, 2 * rows, 1.F);
  const shadow::Lookup sunlight(shadow::ChannelWeights(1, 1, 1.));
  Worst worst;
  for (const auto photometry :
       {surface::Photometry::yapo_cutler, surface::Photometry::lommel_seeliger_rolo})
    for (const double moon : {0.5, 0.93, 1.06, 2.})
      for (const double sun : {0.5, 1., 2.}) {
        const auto sky = moved(moon, sun);
        const auto image = texture::bake({white, sky, sunlight}, {"Y"}, rows, photometry);
        for (std::size_t r = 0; r < rows; ++r)
          for (std::size_t c = 0; c < 2 * rows; ++c) {
            const double other = by_vectors(sky, r, c, rows, photometry);
            worst.see(std::abs(image(r, c, 0) - other) / std::max(other, 0.01));
          }
      }
  holds("texels with Sun and Moon at half to double their distances",
        "floats against vectors in double precision, over them", 1e-5, worst, "as bake.h states");
}

TEST(Textures, OfTwoRowsAreBakedAndOfOneRefused) {
  const shadow::Lookup dark(shadow::ChannelWeights(3, 1, 0.));
  const auto bake = [&](std::size_t rows) {
    return texture::bake({algebra::Grid<float>(2, 4, 1.F), moved(1, 1), dark}, {"R", "G", "B"},
                         rows, surface::Photometry::lommel_seeliger_rolo);
  };
  for (const float x : bake(2).values) EXPECT_TRUE(x == 0 && !std::signbit(x));
  tried("a texture of two rows without any light", "0 in every texel, not -0 and no NaN");
  is_refused("a texture of one row", [&] { bake(1); });
}

TEST(Photometry, IsBoundedFromGrazingLightToLightFromAbove) {
  Worst worst;
  for (double mu0 = 1e-300; mu0 <= 1; mu0 *= 1e10)
    for (const double mu : {-1., 0., 1e-300, 1e-5, 1.})
      for (const double phase_deg : {0., 1e-12, 1.5, 97., 180.})
        worst.see(surface::radiance_factor(surface::Photometry::lommel_seeliger_rolo, mu0, mu,
                                           algebra::degrees(phase_deg)));
  holds("cosines from 1e-300 to 1, phases 0 to 180 degrees", "Lommel-Seeliger's factor", 2.32,
        worst, "as photometry.h states");
  EXPECT_EQ(surface::radiance_factor(surface::Photometry::lommel_seeliger_rolo, 0, 0, {}), 0);
}

}  // namespace coppermoon::extremes::numbers_of_scenes_test
