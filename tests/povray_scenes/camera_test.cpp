// SPDX-License-Identifier: MIT
#include "povray_scenes/camera.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <numbers>

#include "algebra/error.h"
#include "povray_scenes/meridian.h"
#include "support/within.h"

namespace coppermoon::povray_scenes {
namespace {

using algebra::degrees;
using algebra::Error;
using algebra::metres;

constexpr const char* rounding = "rounding of doubles";

Camera ten_radii_away(double field_deg) {
  return {{10, 0, 0}, {0, 0, 1}, degrees(field_deg), 200, 100};
}

TEST(FieldOfView, OfATelescopeAndASmallSensorIsTheOnePrintedForIt) {
  // 1540 mm and 22.7 mm; the small angle 22.7/1540 = 0.01474 rad is 0.8446 degrees.
  const auto field = field_of_view(metres(1.540), metres(0.0227));
  EXPECT_WITHIN(in_degrees(field), 0.845, 0.0005, "given to three digits");
}

TEST(FieldOfView, OfASensorTwiceTheFocalLengthIsARightAngle) {
  EXPECT_WITHIN(in_degrees(field_of_view(metres(1), metres(2))), 90, 1e-12, rounding);
}

TEST(FieldOfView, RefusesWhatIsNoLens) {
  EXPECT_THROW(field_of_view(metres(0), metres(0.02)), Error);
  EXPECT_THROW(field_of_view(metres(0.1), metres(-0.02)), Error);
  EXPECT_THROW(field_of_view(metres(std::numeric_limits<double>::quiet_NaN()), metres(1)), Error);
}

TEST(CameraAt, StandsWhereTheObserverIs) {
  const auto camera = camera_at(moon_at_the_equinox(), on_the_meridian(degrees(90)),
                                Up::celestial_north, degrees(1), 100, 100);
  EXPECT_WITHIN(camera.position.x, 384400 / 1737.4, 1e-9, rounding);
  EXPECT_WITHIN(camera.position.y, 0, 1e-9, rounding);
  EXPECT_WITHIN(camera.position.z, 6371 / 1737.4, 1e-9, rounding);
}

TEST(CameraAt, PutsCrisiumRightInTheNorthAndLeftInTheSouth) {
  // What everyone sees: Mare Crisium (17 N, 59 E) is at the upper right of a full Moon due south in
  // the northern hemisphere, and at the lower left of one due north in the southern.
  const auto crisium = place(17, 59);
  const auto sky = moon_at_the_equinox();
  const auto north = pixel_of(
      camera_at(sky, on_the_meridian(degrees(45)), Up::zenith, degrees(0.6), 100, 100), crisium);
  const auto south = pixel_of(
      camera_at(sky, on_the_meridian(degrees(-33)), Up::zenith, degrees(0.6), 100, 100), crisium);
  ASSERT_TRUE(north && south);
  EXPECT_GT(north->x, 60);
  EXPECT_LT(north->y, 45);
  EXPECT_LT(south->x, 40);
  EXPECT_GT(south->y, 55);
}

TEST(CameraAt, TakesNorthFromTheEquatorOfDateWhereverTheObserverStands) {
  const auto camera = camera_at(moon_at_the_equinox(), on_the_meridian(degrees(-33)),
                                Up::celestial_north, degrees(0.6), 100, 100);
  EXPECT_GT(pixel_of(camera, place(17, 59))->x, 60);
  EXPECT_LT(pixel_of(camera, place(80, 0))->y, 20);
}

TEST(CameraAt, LeansWithThePoleOfDate) {
  // The pole of date 20 degrees east (left) of the GCRS's: the Moon's own leans as far to the
  // right.
  auto sky = moon_at_the_equinox();
  const double q = 20 * std::numbers::pi / 180;
  sky.equator_from_gcrs = glm::transpose(
      glm::dmat3({1, 0, 0}, {0, std::cos(q), -std::sin(q)}, {0, std::sin(q), std::cos(q)}));
  const auto chart = camera_at(sky, Up::celestial_north, degrees(0.6), 100, 100);
  const auto top = *pixel_of(chart, place(60, 0)) - glm::dvec2(50, 50);
  EXPECT_WITHIN(std::atan2(top.x, -top.y), q, 1e-9, rounding);
}

TEST(CameraAt, LooksDownOnTheSubObserverPointOfTheAlmanac) {
  const auto sky = almanac::sky_at(almanac::instant_from_utc("2008-02-21T03:26:05Z"));
  const auto view = almanac::view_from({degrees(42.4), degrees(-71.1), metres(10)}, sky);
  const auto camera = camera_at(sky, view, Up::zenith, degrees(0.6), 100, 100);
  const auto middle = *pixel_of(camera, view.sub_observer);
  EXPECT_WITHIN(middle.x, 50, 1e-6, rounding);
  EXPECT_WITHIN(middle.y, 50, 1e-6, rounding);
  EXPECT_WITHIN_RELATIVE(glm::length(camera.position), view.moon_distance / almanac::lunar_radius,
                         1e-9, rounding);
}

TEST(CameraAt, TurnsFromNorthToTheZenithByTheParallacticAngle) {
  const auto sky = almanac::sky_at(almanac::instant_from_utc("2008-02-21T03:26:05Z"));
  const auto view = almanac::view_from({degrees(42.4), degrees(-71.1), metres(10)}, sky);
  const auto bearing = [&](Up up) {
    const auto camera = camera_at(sky, view, up, degrees(0.6), 1000, 1000);
    const auto pole = *pixel_of(camera, place(80, 0)) - glm::dvec2(500, 500);
    return std::atan2(-pole.x, -pole.y);  // anticlockwise from up, which is east of north
  };
  // The zenith stands q east of north: seen from it, the pole's bearing is smaller by q.
  EXPECT_WITHIN(bearing(Up::celestial_north) - bearing(Up::zenith),
                in_radians(view.parallactic_angle), 1e-9, rounding);
}

TEST(CameraAt, TurnsTheMoonByThePositionAngleOfItsAxis) {
  // The axis turned by 20 degrees from north through east (east is left): the pole is seen 20
  // degrees anticlockwise from straight up.
  auto sky = moon_at_the_equinox();
  const double p = 20 * std::numbers::pi / 180;
  const glm::dvec3 pole(0, std::sin(p), std::cos(p)), ninety_east(0, -std::cos(p), std::sin(p));
  for (int i = 0; i < 3; ++i)
    sky.selenographic_from_gcrs[i] = {i == 0 ? -1.0 : 0.0, ninety_east[i], pole[i]};
  const auto chart = camera_at(sky, Up::celestial_north, degrees(0.6), 100, 100);
  const auto top = *pixel_of(chart, place(60, 0)) - glm::dvec2(50, 50);
  EXPECT_WITHIN(std::atan2(-top.x, -top.y), p, 1e-9, rounding);
  const auto upright = camera_at(sky, Up::moon_north, degrees(0.6), 100, 100);
  EXPECT_WITHIN(pixel_of(upright, place(60, 0))->x, 50, 1e-9, rounding);
}

TEST(CameraAt, HasNoZenithAtTheCentreOfTheEarth) {
  EXPECT_THROW(camera_at(moon_at_the_equinox(), Up::zenith, degrees(1), 10, 10), Error);
}

TEST(CameraAt, RefusesTheZenithAsUpWhereTheMoonStandsInIt) {
  EXPECT_THROW(
      camera_at(moon_at_the_equinox(), on_the_meridian(degrees(0)), Up::zenith, degrees(1), 9, 9),
      Error);
}

TEST(CameraAt, RefusesAFieldThatNoPinholeHas) {
  const auto sky = moon_at_the_equinox();
  for (const double field : {180.0, 200.0, 0.0, -1.0, std::numeric_limits<double>::infinity()})
    EXPECT_THROW(camera_at(sky, Up::moon_north, degrees(field), 10, 10), Error) << field;
  EXPECT_THROW(camera_at(sky, Up::moon_north, degrees(1), 0, 10), Error);
}

TEST(Camera, MayNotStandInTheMoon) {
  auto camera = ten_radii_away(20);
  camera.position = {0.5, 0, 0};
  EXPECT_THROW(require_sound(camera), Error);
  camera.position = {0, 0, 0};
  EXPECT_THROW(require_sound(camera), Error);
}

TEST(PixelOf, TheNearestPlaceIsTheMiddleOfThePicture) {
  const auto pixel = pixel_of(ten_radii_away(20), place(0, 0));
  EXPECT_WITHIN(pixel->x, 100, 1e-12, rounding);
  EXPECT_WITHIN(pixel->y, 50, 1e-12, rounding);
}

TEST(PixelOf, FollowsThePinholeInClosedForm) {
  // Longitude L on the equator, from distance d: tan of the angle off the axis = sin L / (d - cos
  // L); the edge of the picture is at tan(field / 2).
  for (const double field : {0.01, 20.0, 150.0}) {
    const auto pixel = pixel_of(ten_radii_away(field), place(0, 30));
    const double tangent = 0.5 / (10 - std::sqrt(0.75));
    const double edge = std::tan(field * std::numbers::pi / 360);
    EXPECT_WITHIN_RELATIVE(pixel->x - 100, 100 * tangent / edge, 1e-12, rounding);
    EXPECT_WITHIN(pixel->y, 50, 1e-9, rounding);
  }
}

TEST(PixelOf, HasSquarePixels) {
  const auto east = pixel_of(ten_radii_away(20), place(0, 40)),
             north = pixel_of(ten_radii_away(20), place(40, 0));
  EXPECT_WITHIN(east->x - 100, 50 - north->y, 1e-9, rounding);
}

TEST(PixelOf, EndsAtTheLimbThatTheDistanceAllows) {
  // From distance d the limb is acos(1/d) from the nearest place: 84.26 degrees at d = 10.
  EXPECT_TRUE(pixel_of(ten_radii_away(20), place(0, 84.2)));
  EXPECT_FALSE(pixel_of(ten_radii_away(20), place(0, 84.3)));
  EXPECT_FALSE(pixel_of(ten_radii_away(20), place(0, 180)));
  EXPECT_TRUE(pixel_of(ten_radii_away(20), place(0, 360)));
}

/// Where a place stands from the middle of the picture.
glm::dvec2 offset(const Camera& camera, const almanac::SelenographicPoint& at) {
  return *pixel_of(camera, at) - glm::dvec2(100, 50);
}

TEST(PixelOf, SquashesTheDiscTowardsTheZenith) {
  const auto round = ten_radii_away(20);
  auto flat = round;
  flat.flattening = 0.85;
  flat.zenith = {0.6, 0, 1};  // what lies along the line of sight does not count
  for (const auto& at : {place(40, 0), place(-10, 50), place(3, -70)}) {
    EXPECT_WITHIN(offset(flat, at).x, offset(round, at).x, 1e-9, rounding);
    EXPECT_WITHIN(offset(flat, at).y, 0.85 * offset(round, at).y, 1e-9, rounding);
  }
}

TEST(PixelOf, SquashesAcrossTheDiagonalUnderAZenithThere) {
  auto flat = ten_radii_away(20);
  flat.flattening = 0.9;
  flat.zenith = {0, 1, 1};  // to the upper right, since 90 E is on the right
  const auto right = offset(ten_radii_away(20), place(0, 30));
  // Half of a step to the right lies along the diagonal and loses a tenth.
  EXPECT_WITHIN(offset(flat, place(0, 30)).x, 0.95 * right.x, 1e-9, rounding);
  EXPECT_WITHIN(offset(flat, place(0, 30)).y, 0.05 * right.x, 1e-9, rounding);
}

TEST(PixelOf, LeavesTheLimbWhereTheDistanceAllows) {
  auto flat = ten_radii_away(20);
  flat.flattening = 0.85;
  flat.zenith = {0, 0, 1};
  EXPECT_TRUE(pixel_of(flat, place(84.2, 0)));
  EXPECT_FALSE(pixel_of(flat, place(84.3, 0)));
}

TEST(FlattenedByAir, IsNothingWithoutAZenithAcrossTheSight) {
  auto camera = ten_radii_away(20);
  camera.flattening = 0.85;
  for (const auto& zenith : {glm::dvec3(0, 0, 0), glm::dvec3(-2, 0, 0)}) {
    camera.zenith = zenith;
    EXPECT_EQ(flattened_by_air(camera), glm::dmat3(1));
  }
}

TEST(Camera, MayNotBeFlatterThanAirMakesIt) {
  auto camera = ten_radii_away(20);
  for (const double flattening : {0.79, 1.01, std::numeric_limits<double>::quiet_NaN()}) {
    camera.flattening = flattening;
    EXPECT_THROW(require_sound(camera), Error) << flattening;
  }
}

TEST(CameraAt, KnowsTheZenithWhicheverWayIsUp) {
  const auto sky = moon_at_the_equinox();
  for (const auto up : {Up::celestial_north, Up::moon_north, Up::zenith}) {
    const auto zenith =
        camera_at(sky, on_the_meridian(degrees(-33)), up, degrees(1), 100, 100).zenith;
    EXPECT_WITHIN(zenith.z, -std::sin(33 * std::numbers::pi / 180), 1e-12, rounding);
    EXPECT_WITHIN(zenith.x, -std::cos(33 * std::numbers::pi / 180), 1e-12, rounding);
  }
}

TEST(PixelOf, AMirrorExchangesLeftAndRightOnly) {
  auto camera = ten_radii_away(20);
  const auto seen = pixel_of(camera, place(20, 30));
  camera.mirrored = true;
  const auto reflected = pixel_of(camera, place(20, 30));
  EXPECT_WITHIN(reflected->x, 200 - seen->x, 1e-9, rounding);
  EXPECT_WITHIN(reflected->y, seen->y, 1e-9, rounding);
}

}  // namespace
}  // namespace coppermoon::povray_scenes
