// SPDX-License-Identifier: MIT
#include <OpenImageIO/imageio.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "almanac/sky.h"
#include "colour/working_space.h"
#include "support/program.h"
#include "texture/read_image.h"

namespace coppermoon::end_to_end::ring_test {

using std::numbers::pi;
using texture::Image;

const std::string middle_of_2018 = "2018-07-27T20:22:00Z", late_in_2018 = "2018-07-27T21:00:00Z";

double luminance(const Image& image, std::size_t row, std::size_t column) {
  const std::array<double, 3> rgb{image(row, column, 0), image(row, column, 1),
                                  image(row, column, 2)};
  return colour::luminance(colour::WorkingSpace::linear_rec709, rgb);
}

class Ring : public ProgramTest {
 protected:
  Image ring(const std::string& instant, const Words& more = {}) const {
    auto words = words_of("ring {} -o ring.exr", instant);
    words += more;
    expect_done(coppermoon(words));
    return texture::read_image(here("ring.exr"));
  }

  std::string said(const char* name) const {
    return texture::read_attribute(here("ring.exr"), name).value_or("");
  }
  double header(const std::string& name) const {
    return std::stod(said(("coppermoon:" + name).c_str()));
  }
};

using RingThoroughly = Ring;

TEST_F(RingThoroughly, SaysInItsHeaderHowItStandsOnTheSky) {
  const auto image = ring(middle_of_2018);
  EXPECT_EQ(image.channels, (Words("R G B")));
  EXPECT_EQ(said("capDate"), "2018:07:27 20:22:00");
  EXPECT_EQ(said("coppermoon:colour_space"), "lin_rec709");
  const double distance_km = header("earth_distance_km");
  EXPECT_WITHIN(distance_km, 406107 - 1737, 60, "the Moon's distance then (JPL), and its radius");
  EXPECT_WITHIN(header("earth_altitude"), 90, 0.01, "the default is the sub-Earth point");
  EXPECT_EQ(said("coppermoon:zenith_position_angle"), "") << "the Earth is there";
  const auto angle = [&](double km) { return std::asin(km / distance_km) * 180 / pi; };
  EXPECT_WITHIN(header("inner_angle"), angle(6356.75 + 1.8), angle(3),
                "the pole, lifted by (n − 1) R = 1.8 km; tipped by 19°, 2 km");
  EXPECT_GT(header("outer_angle"), angle(6378.14));
  EXPECT_LT(header("outer_angle"), angle(6378.14 + 86));
}

TEST_F(RingThoroughly, IsMadeAgainFromItsHeader) {
  ring(late_in_2018, "--on 20,30 --atmosphere clear --ozone-du 300");
  expect_done(coppermoon("ring ring.exr -o again.exr"));
  EXPECT_TRUE(text_of(here("ring.exr")) == text_of(here("again.exr")));
}

/// Position angle of one direction at another, from their right ascensions and declinations.
///
///     tan p = sin Δα / (cos δ tan δ' − sin δ cos Δα)        Meeus, Astronomical Algorithms
double position_angle_deg(const almanac::SkyState& sky, const glm::dvec3& at,
                          const glm::dvec3& of) {
  const auto here = almanac::equatorial_place(sky, at), there = almanac::equatorial_place(sky, of);
  const double d = algebra::in_radians(here.declination),
               apart = algebra::in_radians(there.right_ascension - here.right_ascension);
  return std::atan2(std::sin(apart),
                    std::cos(d) * std::tan(algebra::in_radians(there.declination)) -
                        std::sin(d) * std::cos(apart)) *
         180 / pi;
}

/// Where its light is centred: by columns, of which the first begins in the north.
double brightest_deg(const Image& image) {
  double x = 0, y = 0;
  for (std::size_t row = 0; row < image.height; ++row)
    for (std::size_t column = 0; column < image.width; ++column) {
      const double angle =
          2 * pi * (static_cast<double>(column) + 0.5) / static_cast<double>(image.width);
      x += luminance(image, row, column) * std::cos(angle);
      y += luminance(image, row, column) * std::sin(angle);
    }
  return std::atan2(y, x) * 180 / pi;
}

TEST_F(Ring, IsBrightestWhereTheSunStandsBehindTheLimb) {
  const auto sky = almanac::sky_at(almanac::instant_from_utc(late_in_2018));
  for (const auto& [on, latitude, longitude, air] :
       {std::tuple{"20,30", 20., 30., "standard"}, std::tuple{"-60,-40", -60., -40., "undated"}}) {
    const auto image = ring(late_in_2018, {"--on", on, "--atmosphere", air});
    const auto direction =
        almanac::selenographic_direction({algebra::degrees(latitude), algebra::degrees(longitude)});
    const auto position =
        sky.moon_m + algebra::in_metres(almanac::lunar_radius) *
                         (glm::transpose(sky.selenographic_from_gcrs) * direction);
    const double sun = position_angle_deg(sky, -position, sky.sun_m - position);
    EXPECT_WITHIN(std::remainder(header("sun_position_angle") - sun, 360.), 0, 1e-4,
                  "a float's 7 digits");
    EXPECT_WITHIN(std::remainder(brightest_deg(image) - sun, 360.), 0, 3,
                  "the limb's radius and altitude vary with the angle by 21 of 6378 km");
    EXPECT_WITHIN(
        header("earth_altitude"),
        90 - std::acos(glm::dot(glm::normalize(-position),
                                glm::transpose(sky.selenographic_from_gcrs) * direction)) *
                 180 / pi,
        1e-3, "a float's 7 digits");
  }
}

/// [lx], of ground that faces the Earth: the ring's luminance over its solid angle.
double illuminance(const Image& image, double inner_deg, double outer_deg) {
  const double inner = inner_deg * pi / 180, outer = outer_deg * pi / 180;
  double sum = 0;
  for (std::size_t row = 0; row < image.height; ++row) {
    const double angle = std::lerp(
        outer, inner, (static_cast<double>(row) + 0.5) / static_cast<double>(image.height));
    for (std::size_t column = 0; column < image.width; ++column)
      sum += luminance(image, row, column) * std::sin(angle) * std::cos(angle);
  }
  return sum * (outer - inner) / static_cast<double>(image.height) * 2 * pi /
         static_cast<double>(image.width);
}

// A texture 32 wide has texels about 5.625° and 16.875° from its middle.
TEST_F(Ring, LightsTheGroundAsTheTextureIsLit) {
  const auto image = ring(late_in_2018, "--on 5.625,16.875 --atmosphere undated");
  expect_done(coppermoon(
      words_of("bake {} --passes --texture-width 32 --tolerance 0.1% --albedo-map built-in "
               "--atmosphere undated --scattered-light off --leave-out scattered-light -o moon.exr",
               late_in_2018)));
  const auto file = OIIO::ImageInput::open(here("moon.exr"));
  ASSERT_TRUE(file);
  constexpr int irradiance = 3;
  Image baked(32, 16, {"R", "G", "B"});
  ASSERT_TRUE(file->read_image(irradiance, 0, 0, 3, OIIO::TypeDesc::FLOAT, baked.values.data()));
  EXPECT_WITHIN_RELATIVE(illuminance(image, header("inner_angle"), header("outer_angle")),
                         pi * luminance(baked, 7, 17), 0.025,
                         "the bake weighs light as the Moon's reddish ground does: 1.7 % here");
}

TEST_F(Ring, ThatCannotBeSeenIsRefused) {
  const auto refused = [&](const Words& words, const std::string& part) {
    Words all = "ring -o ring.exr";
    all += words;
    expect_refused(all, part);
  };
  refused({"2018-07-20T00:00:00Z"}, "no lunar eclipse at 2018-07-20T00:00:00Z; the nearest is");
  refused({middle_of_2018, "--on", "0,180"}, "below the horizon");
  refused("2018-07-27T18:40:00Z --on 0,80", "of the Sun's light comes straight to");
  refused({middle_of_2018, "--on", "95,0"}, "lunar latitude [deg] = 95, allowed -90 to 90");
  refused({middle_of_2018, "--on", "12"}, "place on the Moon = 12, allowed LATITUDE,LONGITUDE");
  refused({middle_of_2018, "--atmosphere", "none"}, "air = none");
  refused({middle_of_2018, "--refraction", "off"}, "the ring is black");
  expect_refused(
      words_of("ring {} -o ring.png", middle_of_2018),
      "ring.png: a ring ends in .exr (scene-linear; `coppermoon develop` makes a picture of it)");
}

}  // namespace coppermoon::end_to_end::ring_test
