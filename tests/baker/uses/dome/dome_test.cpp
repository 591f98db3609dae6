// SPDX-License-Identifier: MIT
#include "uses/dome/dome.h"

#include "almanac/instant.h"
#include "almanac/planets.h"
#include "atmosphere/astronomical_refraction.h"
#include "atmosphere/sky_luminance.h"
#include "colour/working_space.h"
#include "result/as_json.h"
#include "support/testing.h"
#include "uses/picture/brightness.h"
#include "uses/picture/clear_sky.h"

namespace coppermoon::uses::dome_test {

using std::numbers::pi;
constexpr double degree = pi / 180;

const almanac::Observer nairobi{algebra::degrees(-1.28), algebra::degrees(36.82), {}},
    grossmugl{algebra::degrees(48.5), algebra::degrees(16.23), algebra::metres(220)};

MoonRequest small_moon(bool unshadowed) {
  MoonRequest moon;
  moon.texture_width = 360;
  moon.unshadowed = unshadowed;
  moon.light.wish.tolerance = 0.1;
  return moon;
}

LitMoon moon_at(const char* utc, bool unshadowed = false) {
  return lit_moon(small_moon(unshadowed), almanac::sky_at(almanac::instant_from_utc(utc)));
}

const LitMoon& totality_of_2018() {
  static const auto moon = moon_at("2018-07-27T20:22Z");
  return moon;
}

const LitMoon& full_moon_of_2018() {
  static const auto moon = moon_at("2018-07-27T20:22Z", true);
  return moon;
}

ViewRequest from(const almanac::Observer& place, bool stars = false) {
  return {.observer = place, .stars = {.shown = stars}};
}

double figure(const Dome& dome, const std::string& name) {
  return result::as_json(dome.figures)[name].get<double>();
}

double luminance(const texture::Image& image, std::size_t row, std::size_t column) {
  const std::array<double, 3> rgb{image(row, column, 0), image(row, column, 1),
                                  image(row, column, 2)};
  return colour::luminance(colour::WorkingSpace::linear_rec709, rgb);
}

/// Solid angle of a texel: the integral of cos(altitude).
double solid_angle(const texture::Image& image, std::size_t row) {
  const double step = pi / static_cast<double>(image.height);
  const double top = pi / 2 - static_cast<double>(row) * step;
  return step * (std::sin(top) - std::sin(top - step));
}

/// Luminance times solid angle of all texels above the horizon; on level ground, or on surfaces that face each.
double sum_lx(const texture::Image& image, bool on_level_ground) {
  const double step = pi / static_cast<double>(image.height);
  double sum = 0;
  for (std::size_t r = 0; r < image.height / 2; ++r)
    for (std::size_t c = 0; c < image.width; ++c)
      sum += luminance(image, r, c) * solid_angle(image, r) *
             (on_level_ground ? std::sin(pi / 2 - (static_cast<double>(r) + 0.5) * step) : 1);
  return sum;
}

void expect_light(const texture::Image& image) {
  EXPECT_TRUE(
      std::ranges::all_of(image.values, [](float v) { return std::isfinite(v) && v >= 0; }));
}

TEST(Dome, IsFiniteAtAllAltitudesOfSunAndMoon) {
  const almanac::Observer pole{algebra::degrees(90), {}, {}},
      andes{{}, algebra::degrees(-150), algebra::metres(5000)};
  const LitMoon dark = totality_of_2018(), full = full_moon_of_2018();
  for (const auto* moon : {&dark, &full})
    for (const auto& place :
         {nairobi, grossmugl, pole, andes}) {  // night, moonrise, polar day, day without a Moon
      const auto dome =
          dome_over({.width = 64, .moon = true, .ground_albedo = 0.3}, *moon, from(place, true));
      expect_light(dome.light);
      const double sun = figure(dome, "sun_geometric_altitude_deg");
      EXPECT_EQ(figure(dome, "zenith_luminance_cd_m2") > 10, sun > -3) << sun;
    }
}

TEST(Dome, HasTheLawsLuminanceInEveryTexel) {
  const auto& moon = full_moon_of_2018();
  const auto view = from(nairobi);
  const auto dome = dome_over({.width = 128}, moon, view);
  const auto brightness = brightness_of(moon.request, moon.sky);
  const ClearSky sky(nairobi, moon.sky, air_over(nairobi, view), brightness.disc.magnitudes[1]);
  for (const std::size_t row : {0u, 10u, 31u})
    for (const std::size_t column : {0u, 40u, 64u, 127u}) {
      const auto direction = in_sky(algebra::degrees(90 - (double(row) + 0.5) * 180 / 64),
                                    algebra::degrees((double(column) + 0.5) * 360 / 128 - 180));
      EXPECT_WITHIN_RELATIVE(luminance(dome.light, row, column), sky.towards(direction).sum(),
                             0.003, "the Moon's V by textures of 180 and 360 rows");
    }
  EXPECT_WITHIN_RELATIVE(figure(dome, "zenith_luminance_cd_m2"), sky.zenith_cd_m2(), 0.003,
                         "the same");
  EXPECT_WITHIN_RELATIVE(figure(dome, "sky_illuminance_lx"), sum_lx(dome.light, true), 1e-3,
                         "solid angles in closed form");
}

TEST(Dome, HoldsTheMoonsIlluminance) {
  for (const auto* moon : {&full_moon_of_2018(), &totality_of_2018()}) {
    const auto view = from(nairobi);
    const auto without = dome_over({.width = 256}, *moon, view),
               with = dome_over({.width = 256, .moon = true}, *moon, view);
    const double lx = brightness_of(moon->request, moon->sky, view).seen->disc.illuminance_lx;
    EXPECT_WITHIN_RELATIVE(sum_lx(with.light, false) - sum_lx(without.light, false), lx, 0.01,
                           "textures of 360 rows; colours brought into Rec.709 keep luminance");
    EXPECT_WITHIN_RELATIVE(figure(with, "moon_illuminance_lx"), lx, 0.01, "the same");
    EXPECT_EQ(figure(with, "sky_illuminance_lx"), figure(without, "sky_illuminance_lx"));
    // where it stands: the brightest texel
    const auto brightest = std::ranges::max_element(with.light.values) - with.light.values.begin();
    const auto texel = static_cast<std::size_t>(brightest) / 3;
    EXPECT_WITHIN(90 - (static_cast<double>(texel / 256) + 0.5) * 180 / 128,
                  figure(with, "moon_altitude_deg"), 1.4, "a texel");
    EXPECT_WITHIN((static_cast<double>(texel % 256) + 0.5) * 360 / 256 - 180,
                  figure(with, "moon_azimuth_deg"), 1.4, "a texel");
  }
}

TEST(Dome, DarkensAndStarsStandOut) {
  const auto full = dome_over({.width = 64}, full_moon_of_2018(), from(nairobi)),
             dark = dome_over({.width = 64}, totality_of_2018(), from(nairobi));
  EXPECT_GT(figure(full, "zenith_luminance_cd_m2"), 8 * figure(dark, "zenith_luminance_cd_m2"));
  EXPECT_WITHIN_RELATIVE(figure(dark, "zenith_luminance_cd_m2"),
                         atmosphere::luminance_of_magnitude_cd_m2(21.9), 0.02,
                         "a Moon of V = -1 adds a hundredth to the night's own light");
}

TEST(Dome, IsAsBrightAsMeasuredInAnEclipse) {
  // Project Nightflight, Grossmugl (Austria), 16 July 2019, SQM-L towards the zenith: 19.8 mag/arcsec2 both at 20:38 UT
  // and at 22:25 UT, when the Milky Way appeared and went; project-nightflight.net/projects012.html
  for (const char* utc : {"2019-07-16T20:38Z", "2019-07-16T22:25Z"}) {
    const auto dome = dome_over({.width = 16}, moon_at(utc), from(grossmugl));
    const double mag = -2.5 * std::log10(figure(dome, "zenith_luminance_cd_m2") /
                                         atmosphere::luminance_of_magnitude_cd_m2(0));
    EXPECT_WITHIN(mag, 19.8, 0.75,
                  "mag: the formula's 23 %, towns towards Vienna, and the SQM's blue response; "
                  "twilight's factor of two at 20:38");
  }
}

/// Middle and light of what differs between two images.
struct Spot {
  double altitude_deg, azimuth_deg;
  std::array<double, 3> lux{};
};

Spot spot_of(const texture::Image& with, const texture::Image& without) {
  double east = 0, north = 0, up = 0;
  Spot spot{};
  for (std::size_t r = 0; r < with.height / 2; ++r)
    for (std::size_t c = 0; c < with.width; ++c) {
      const double altitude = pi / 2 - (static_cast<double>(r) + 0.5) * pi /
                                           static_cast<double>(with.height),
                   azimuth =
                       (static_cast<double>(c) + 0.5) * 2 * pi / static_cast<double>(with.width) -
                       pi;
      for (std::size_t k = 0; k < 3; ++k)
        spot.lux[k] += (double{with(r, c, k)} - without(r, c, k)) * solid_angle(with, r);
      const double light = (double{with(r, c, 1)} - without(r, c, 1)) * solid_angle(with, r);
      east += light * std::cos(altitude) * std::sin(azimuth);
      north += light * std::cos(altitude) * std::cos(azimuth);
      up += light * std::sin(altitude);
    }
  spot.altitude_deg = std::atan2(up, std::hypot(east, north)) / degree;
  spot.azimuth_deg = std::atan2(east, north) / degree;
  return spot;
}

TEST(Dome, HasMarsWhereTheAlmanacHasItAndAsBright) {
  auto view = from(nairobi, true);
  view.stars.faintest = -2.5;  // Mars alone, V = -2.8
  const auto& moon = totality_of_2018();
  const auto spot = spot_of(dome_over({.width = 512}, moon, view).light,
                            dome_over({.width = 512}, moon, from(nairobi)).light);
  for (const auto& planet : almanac::planets_at(moon.sky.when)) {
    if (planet.name != "Mars") continue;
    // by hour angle: sidereal time of Nairobi from the equatorial place of its zenith
    const auto seen = almanac::view_from(nairobi, moon.sky);
    const auto zenith = almanac::equatorial_place(moon.sky, seen.zenith),
               mars = almanac::equatorial_place(moon.sky, planet.position_m);
    const double h = algebra::in_radians(zenith.right_ascension - mars.right_ascension),
                 d = algebra::in_radians(mars.declination),
                 p = algebra::in_radians(nairobi.latitude);
    const double altitude =
                     std::asin(std::sin(p) * std::sin(d) + std::cos(p) * std::cos(d) * std::cos(h)),
                 azimuth = std::atan2(
                     -std::cos(d) * std::sin(h),
                     std::sin(d) * std::cos(p) - std::cos(d) * std::sin(p) * std::cos(h));
    EXPECT_WITHIN(spot.altitude_deg, altitude / degree, 0.1,
                  "refraction 0.01, Mars' parallax 0.006; floats");
    EXPECT_WITHIN(std::remainder(spot.azimuth_deg - azimuth / degree, 360), 0, 0.1, "as above");
    const double above = 2.54e-6 * std::pow(10, -0.4 * planet.magnitude);
    const double y = colour::luminance(colour::WorkingSpace::linear_rec709, spot.lux);
    EXPECT_LT(y, 1.1 * above);
    EXPECT_GT(y, 0.6 * above) << "extinction at sea level: 0.25 mag at the zenith";
  }
}

TEST(Dome, KeepsTheLightOfAllStars) {
  auto view = from(nairobi, true);
  const auto& moon = totality_of_2018();
  const auto without = dome_over({.width = 128}, moon, from(nairobi)).light;
  const double lx =
      sum_lx(dome_over({.width = 128}, moon, view).light, false) - sum_lx(without, false);
  view.stars.faintest = 1;
  const double bright =
      sum_lx(dome_over({.width = 128}, moon, view).light, false) - sum_lx(without, false);
  EXPECT_GT(lx, 1.3 * bright);
  // Allen (2000), §26: all stars to V = 6 give 2.3e-4 lx of a whole sky: half of it stands above the horizon, dimmed
  EXPECT_GT(lx, 3e-5);
  EXPECT_LT(lx, 2e-4);
}

TEST(Dome, HasNoSeamAndAGroundOfItsAlbedo) {
  const auto dome =
      dome_over({.width = 128, .ground_albedo = 0.5}, full_moon_of_2018(), from(nairobi));
  const auto& image = dome.light;
  for (std::size_t r = 0; r < 32; ++r) {
    const double step = std::abs(luminance(image, r, 0) / luminance(image, r, 127) - 1),
                 inside = std::abs(luminance(image, r, 1) / luminance(image, r, 0) - 1) +
                          std::abs(luminance(image, r, 127) / luminance(image, r, 126) - 1);
    EXPECT_LT(step, inside + 1e-3) << r;
  }
  const double lx =
      figure(dome, "sky_illuminance_lx") +
      figure(dome, "moon_illuminance_lx") * std::sin(figure(dome, "moon_altitude_deg") * degree);
  for (const std::size_t row : {32u, 50u, 63u})
    EXPECT_WITHIN_RELATIVE(luminance(image, row, 7), 0.5 * lx / pi, 1e-5, "floats");
  EXPECT_EQ(luminance(dome_over({.width = 64}, full_moon_of_2018(), from(nairobi)).light, 20, 3),
            0);
}

TEST(Dome, IsInTheSpaceAskedForAndRefusesWhatIsUnsound) {
  const auto& moon = totality_of_2018();
  const auto rec709 = dome_over({.width = 32}, moon, from(nairobi)),
             wide = dome_over({.width = 32, .content = {.space = colour::WorkingSpace::acescg}},
                              moon, from(nairobi));
  const std::array<double, 3> rgb{wide.light(3, 5, 0), wide.light(3, 5, 1), wide.light(3, 5, 2)};
  EXPECT_WITHIN_RELATIVE(colour::luminance(colour::WorkingSpace::acescg, rgb),
                         luminance(rec709.light, 3, 5), 1e-4, "floats");
  EXPECT_EQ(std::get<std::string>(wide.attributes.at("colorInteropID")), "lin_ap1_scene");
  EXPECT_THROW(dome_over({.width = 18}, moon, from(nairobi)), algebra::Error);
  EXPECT_THROW(dome_over({.width = 64, .ground_albedo = 2}, moon, from(nairobi)), algebra::Error);
  EXPECT_THROW(dome_over({.width = 64}, moon, {}), algebra::Error);
}

}  // namespace coppermoon::uses::dome_test
