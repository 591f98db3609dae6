// SPDX-License-Identifier: MIT
// Places on the Moon must come to stand where an observer sees them, through map, bake, scene,
// POV-Ray and frame.
#include "almanac/instant.h"
#include "almanac/observer.h"
#include "end_to_end/spotted_moon.h"
#include "povray_scenes/scene_camera.h"
#include "support/program.h"
#include "texture/read_image.h"
#include "texture/write_image.h"

namespace coppermoon::end_to_end::orientation_test {

using algebra::degrees;

constexpr std::size_t side = 240;  // pixels
constexpr double field_deg = 0.6;

/// Who looks, when, and how the camera is held.
struct Look {
  std::string instant, at;
  almanac::Observer observer;
  povray_scenes::Up up;
};

const almanac::Observer clifton_park{degrees(42.86), degrees(-73.77), {}};
const almanac::Observer cape_town{degrees(-33.9), degrees(18.4), {}};

/// Near midnight both times: the Moon is high, in the south and in the north.
Look from_the_north(povray_scenes::Up up) {
  return {"2008-02-21T04:40:00Z", "42.86,-73.77", clifton_park, up};
}
Look from_the_south(povray_scenes::Up up) {
  return {"2018-07-27T22:40:00Z", "-33.9,18.4", cape_town, up};
}

using Centres = std::array<glm::dvec2, 3>;

double worst_distance(const Centres& seen, const Centres& expected) {
  double worst = 0;
  for (std::size_t i = 0; i < seen.size(); ++i)
    worst = std::max(worst, glm::distance(seen[i], expected[i]));
  return worst;
}

/// Where the three spots are in a frame.
Centres centres_in(const texture::Image& frame) {
  const auto found = blobs(frame);
  EXPECT_EQ(found.size(), 3U);
  if (found.size() != 3) return {};
  return {found[0].centre, found[1].centre, found[2].centre};
}

/// Where our own camera says they are.
Centres by_camera(const Look& look) {
  const auto sky = almanac::sky_at(almanac::instant_from_utc(look.instant));
  const auto camera = povray_scenes::camera_at(sky, almanac::view_from(look.observer, sky), look.up,
                                               {degrees(field_deg), side, side});
  Centres all;
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i] = *povray_scenes::pixel_of(camera, spots()[i].at);
  return all;
}

/// Where textbooks say they are, from the printed ephemeris alone (topocentric libration l, b and
/// the axis's position angle C, Meeus, Astronomical Algorithms, chapter 53): towards the Moon's
/// east and north
///     x = cos φ sin(λ − l)    y = sin φ cos b − cos φ sin b cos(λ − l)
/// of its radius; the Moon's east is the sky's west, on the right of a picture with north up. C
/// turns it. The nearer places look larger by the Moon's radius over its distance.
Centres by_textbook(const almanac::SelenographicPoint& libration, double axis_rad,
                    double turned_rad, double distance_radii) {
  const double l = in_radians(libration.longitude), b = in_radians(libration.latitude);
  const double scale = side / 2 / std::tan(field_deg * std::numbers::pi / 360);
  Centres all;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double phi = in_radians(spots()[i].at.latitude),
                 lambda = in_radians(spots()[i].at.longitude) - l;
    const double x = std::cos(phi) * std::sin(lambda);
    const double y = std::sin(phi) * std::cos(b) - std::cos(phi) * std::sin(b) * std::cos(lambda);
    const double z = std::sin(phi) * std::sin(b) + std::cos(phi) * std::cos(b) * std::cos(lambda);
    const double c =
        axis_rad - turned_rad;  // from the picture's top to the Moon's north, counterclockwise
    const glm::dvec2 right_up{x * std::cos(c) - y * std::sin(c), x * std::sin(c) + y * std::cos(c)};
    const glm::dvec2 offset = scale / (distance_radii - z) * right_up;
    all[i] = {side / 2. + offset.x, side / 2. - offset.y};
  }
  return all;
}

class Orientation : public ProgramTest {
 protected:
  Orientation() {
    texture::write_exr(here("spots.exr"), spotted_map(360), {}, {texture::ExrType::floating});
  }

  /// Once for all tests that look alike.
  const texture::Image& frame_of(const Look& look) const {
    static std::map<std::pair<std::string, povray_scenes::Up>, texture::Image> frames;
    auto& frame = frames[{look.at, look.up}];
    if (frame.values.empty()) frame = made_frame_of(look);
    return frame;
  }

  texture::Image made_frame_of(const Look& look) const {
    const char* up = look.up == povray_scenes::Up::zenith ? "zenith" : "celestial-north";
    expect_done(coppermoon({"still",
                            look.instant,
                            "--at",
                            look.at,
                            "--up",
                            up,
                            "--unshadowed",
                            "--albedo-map",
                            "spots.exr",
                            "--texture-width",
                            "720",
                            "--field",
                            std::to_string(field_deg),
                            "--width",
                            std::to_string(side),
                            "--height",
                            std::to_string(side),
                            "--reddening",
                            "off",
                            "--frame",
                            "frame.exr",
                            "-o",
                            "frame.png"}));
    return texture::read_image(here("frame.exr"));
  }

  /// Spots where they belong, and a mirrored frame refused by the same check.
  void expect_spots_in_place(const Look& look) const {
    const auto& frame = frame_of(look);
    const auto expected = by_camera(look);
    EXPECT_LT(worst_distance(centres_in(frame), expected), 1);
    EXPECT_GT(worst_distance(centres_in(mirrored(frame)), expected), 20);
  }
};

TEST_F(Orientation, SpotsAreInPlaceFromTheNorthWithNorthUp) {
  expect_spots_in_place(from_the_north(povray_scenes::Up::celestial_north));
}

TEST_F(Orientation, SpotsAreInPlaceFromTheNorthWithTheZenithUp) {
  expect_spots_in_place(from_the_north(povray_scenes::Up::zenith));
}

TEST_F(Orientation, SpotsAreInPlaceFromTheSouthWithNorthUp) {
  expect_spots_in_place(from_the_south(povray_scenes::Up::celestial_north));
}

TEST_F(Orientation, SpotsAreInPlaceFromTheSouthWithTheZenithUp) {
  expect_spots_in_place(from_the_south(povray_scenes::Up::zenith));
}

TEST_F(Orientation, TheNorthSeesTychoBelowPlatoAboveAndCrisiumOnTheRight) {
  const auto [tycho, crisium, plato] =
      centres_in(frame_of(from_the_north(povray_scenes::Up::zenith)));
  EXPECT_GT(tycho.y, side / 2.);
  EXPECT_LT(plato.y, side / 2.);
  EXPECT_GT(crisium.x, side / 2. + 50);
}

TEST_F(Orientation, TheSouthSeesTychoAbovePlatoBelowAndCrisiumOnTheLeft) {
  const auto [tycho, crisium, plato] =
      centres_in(frame_of(from_the_south(povray_scenes::Up::zenith)));
  EXPECT_LT(tycho.y, side / 2.);
  EXPECT_GT(plato.y, side / 2.);
  EXPECT_LT(crisium.x, side / 2. - 50);
}

/// The angle and distance of a place from the Moon's centre on an observer's sky, by spherical
/// trigonometry on right ascension and declination: position angle from north through east, which
/// is left of north.
glm::dvec2 by_equatorial_places(const Look& look, const almanac::SelenographicPoint& place) {
  const auto sky = almanac::sky_at(almanac::instant_from_utc(look.instant));
  const auto observer_m = almanac::view_from(look.observer, sky).position_m;
  const glm::dvec3 ground_m =
      in_metres(almanac::lunar_radius) *
      (glm::transpose(sky.selenographic_from_gcrs) * almanac::selenographic_direction(place));
  const auto moon = almanac::equatorial_place(sky, sky.moon_m - observer_m);
  const auto spot = almanac::equatorial_place(sky, sky.moon_m + ground_m - observer_m);
  const double east = in_radians(spot.right_ascension - moon.right_ascension);
  const double d0 = in_radians(moon.declination), d = in_radians(spot.declination);
  const double angle =
      std::atan2(std::cos(d) * std::sin(east),
                 std::sin(d) * std::cos(d0) - std::cos(d) * std::sin(d0) * std::cos(east));
  const double distance =
      std::acos(std::sin(d) * std::sin(d0) + std::cos(d) * std::cos(d0) * std::cos(east));
  const double pixels =
      side / 2 / std::tan(field_deg * std::numbers::pi / 360) * std::tan(distance);
  return {side / 2. - pixels * std::sin(angle), side / 2. - pixels * std::cos(angle)};
}

TEST_F(Orientation, SpotsStandAtTheirPositionAnglesOnTheSky) {
  const auto look = from_the_north(povray_scenes::Up::celestial_north);
  Centres expected;
  for (std::size_t i = 0; i < expected.size(); ++i)
    expected[i] = by_equatorial_places(look, spots()[i].at);
  const auto& frame = frame_of(look);
  EXPECT_LT(worst_distance(centres_in(frame), expected), 1);
  EXPECT_GT(worst_distance(centres_in(mirrored(frame)), expected), 20);
}

TEST_F(Orientation, SpotsStandWhereTextbookFormulaePutThem) {
  const auto look = from_the_south(povray_scenes::Up::zenith);
  const auto sky = almanac::sky_at(almanac::instant_from_utc(look.instant));
  const auto view = almanac::view_from(look.observer, sky);
  // The axis as from the Earth's centre: a degree of parallax turns it by less than half a degree.
  const auto expected =
      by_textbook(view.sub_observer, in_radians(sky.axis_position_angle),
                  in_radians(view.parallactic_angle), view.moon_distance / almanac::lunar_radius);
  const auto& frame = frame_of(look);
  EXPECT_LT(worst_distance(centres_in(frame), expected), 1.5);
  EXPECT_GT(worst_distance(centres_in(mirrored(frame)), expected), 20);
}

}  // namespace coppermoon::end_to_end::orientation_test
