// SPDX-License-Identifier: MIT
#include "povray_scenes/scene_camera.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "atmosphere/astronomical_refraction.h"
#include "povray_scenes/meridian.h"
#include "support/testing.h"

namespace coppermoon::povray_scenes::scene_camera_test {

using algebra::degrees;
using algebra::Error;
using algebra::metres;

constexpr const char* rounding = "rounding of doubles";

SceneCamera ten_radii_away(double field_deg) {
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
                                Up::celestial_north, {degrees(1), 100, 100});
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
      camera_at(sky, on_the_meridian(degrees(45)), Up::zenith, {degrees(0.6), 100, 100}), crisium);
  const auto south = pixel_of(
      camera_at(sky, on_the_meridian(degrees(-33)), Up::zenith, {degrees(0.6), 100, 100}), crisium);
  ASSERT_TRUE(north && south);
  EXPECT_GT(north->x, 60);
  EXPECT_LT(north->y, 45);
  EXPECT_LT(south->x, 40);
  EXPECT_GT(south->y, 55);
}

TEST(CameraAt, TakesNorthFromTheEquatorOfDateWhereverTheObserverStands) {
  const auto camera = camera_at(moon_at_the_equinox(), on_the_meridian(degrees(-33)),
                                Up::celestial_north, {degrees(0.6), 100, 100});
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
  const auto chart = camera_at(sky, Up::celestial_north, {degrees(0.6), 100, 100});
  const auto top = *pixel_of(chart, place(60, 0)) - glm::dvec2(50, 50);
  EXPECT_WITHIN(std::atan2(top.x, -top.y), q, 1e-9, rounding);
}

TEST(CameraAt, LooksDownOnTheSubObserverPointOfTheAlmanac) {
  const auto sky = almanac::sky_at(almanac::instant_from_utc("2008-02-21T03:26:05Z"));
  const auto view = almanac::view_from({degrees(42.4), degrees(-71.1), metres(10)}, sky);
  const auto camera = camera_at(sky, view, Up::zenith, {degrees(0.6), 100, 100});
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
    const auto camera = camera_at(sky, view, up, {degrees(0.6), 1000, 1000});
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
  const auto chart = camera_at(sky, Up::celestial_north, {degrees(0.6), 100, 100});
  const auto top = *pixel_of(chart, place(60, 0)) - glm::dvec2(50, 50);
  EXPECT_WITHIN(std::atan2(-top.x, -top.y), p, 1e-9, rounding);
  const auto upright = camera_at(sky, Up::moon_north, {degrees(0.6), 100, 100});
  EXPECT_WITHIN(pixel_of(upright, place(60, 0))->x, 50, 1e-9, rounding);
}

TEST(CameraAt, HasNoZenithAtTheCentreOfTheEarth) {
  EXPECT_THROW(camera_at(moon_at_the_equinox(), Up::zenith, {degrees(1), 10, 10}), Error);
}

TEST(CameraAt, RefusesTheZenithAsUpWhereTheMoonStandsInIt) {
  EXPECT_THROW(
      camera_at(moon_at_the_equinox(), on_the_meridian(degrees(0)), Up::zenith, {degrees(1), 9, 9}),
      Error);
}

TEST(CameraAt, RefusesAFieldThatNoPinholeHas) {
  const auto sky = moon_at_the_equinox();
  for (const double field : {180.0, 200.0, 0.0, -1.0, std::numeric_limits<double>::infinity()})
    EXPECT_THROW(camera_at(sky, Up::moon_north, {degrees(field), 10, 10}), Error) << field;
  EXPECT_THROW(camera_at(sky, Up::moon_north, {degrees(1), 0, 10}), Error);
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
glm::dvec2 offset(const SceneCamera& camera, const almanac::SelenographicPoint& at) {
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
        camera_at(sky, on_the_meridian(degrees(-33)), up, {degrees(1), 100, 100}).zenith;
    EXPECT_WITHIN(zenith.z, -std::sin(33 * std::numbers::pi / 180), 1e-12, rounding);
    EXPECT_WITHIN(zenith.x, -std::cos(33 * std::numbers::pi / 180), 1e-12, rounding);
  }
}

SceneCamera turned_right(double by_deg, double field_deg) {
  auto camera = ten_radii_away(field_deg);
  const double by = in_radians(degrees(by_deg));
  camera.direction = 7.0 * glm::dvec3(-std::cos(by), std::sin(by), 0);  // 90 E is on the right
  return camera;
}

TEST(PixelOf, MovesTheMoonAgainstTheDirectionByTheTangent) {
  for (const double by : {0.01, 30.0, -69.0}) {
    const auto pixel = pixel_of(turned_right(by, 140), place(0, 0));
    const double edge = std::tan(in_radians(degrees(70)));
    EXPECT_WITHIN(pixel->x - 100, -100 * std::tan(in_radians(degrees(by))) / edge, 1e-9, rounding);
    EXPECT_WITHIN(pixel->y, 50, 1e-9, rounding);
  }
}

TEST(PixelOf, KnowsNoPixelForWhatIsBehindTheCamera) {
  EXPECT_TRUE(pixel_of(turned_right(89, 20), place(0, 0)));
  EXPECT_FALSE(pixel_of(turned_right(91, 20), place(0, 0)));
  EXPECT_FALSE(pixel_of(turned_right(180, 20), place(0, 0)));
}

TEST(PixelOf, FlattensAMoonAwayFromTheMiddleByAsMuch) {
  // From so far off that the disc is drawn as by a parallel projection.
  auto camera = turned_right(20, 60);
  camera.position = {1e5, 0, 0};
  const auto height = [&] { return pixel_of(camera, place(89, 0))->y; };
  const double round = height() - 50;
  camera.zenith = {0, 0, 1};
  camera.flattening = 0.85;
  EXPECT_WITHIN_RELATIVE(height() - 50, 0.85 * round, 1e-6, "the disc's own perspective, 1e-5");
}

TEST(Camera, MayHaveTheMoonBehindItOrAlongItsUp) {
  EXPECT_NO_THROW(require_sound(turned_right(180, 20)));
  auto camera = turned_right(90, 20);
  camera.up = {1, 0, 0};
  EXPECT_NO_THROW(require_sound(camera));
}

TEST(Camera, RefusesADirectionAlongItsUpOrNone) {
  auto camera = ten_radii_away(20);
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN(),
                   endless = std::numeric_limits<double>::infinity();
  for (const auto& direction :
       {glm::dvec3(0, 0, 2), glm::dvec3(0, 0, -1), glm::dvec3(nothing, 0, 0),
        glm::dvec3(endless, 0, 0), glm::dvec3(1e-200, 0, 0)}) {
    camera.direction = direction;
    EXPECT_THROW(require_sound(camera), Error) << direction.x << ", " << direction.z;
  }
}

/// Where a pinhole camera of 200 x 100 pixels, its zenith up, shows a place of the sky: the
/// gnomonic projection in closed form.
glm::dvec2 gnomonic(const HorizonPlace& at, const HorizonPlace& aim, double field_deg) {
  const double a = in_radians(at.altitude), a0 = in_radians(aim.altitude);
  const double turn = in_radians(at.azimuth - aim.azimuth);
  const double depth = std::sin(a0) * std::sin(a) + std::cos(a0) * std::cos(a) * std::cos(turn);
  const double x = std::cos(a) * std::sin(turn);
  const double y = std::cos(a0) * std::sin(a) - std::sin(a0) * std::cos(a) * std::cos(turn);
  const double scale = 100 / std::tan(0.5 * in_radians(degrees(field_deg))) / depth;
  return {100 + scale * x, 50 - scale * y};
}

TEST(CameraFixed, ShowsTheMoonItIsAimedAtInTheMiddle) {
  const auto sky = almanac::sky_at(almanac::instant_from_utc("2008-02-21T03:26:05Z"));
  for (const double longitude_deg : {-71.1, 25.0, -155.0}) {
    const auto view = almanac::view_from({degrees(42.4), degrees(longitude_deg), metres(10)}, sky);
    const HorizonPlace aim{atmosphere::apparent_altitude(view.altitude), view.azimuth};
    const auto camera = camera_fixed(sky, view, aim, {degrees(30), 200, 100});
    const auto middle = *pixel_of(camera, view.sub_observer);
    EXPECT_WITHIN(middle.x, 100, 1e-6, rounding);
    EXPECT_WITHIN(middle.y, 50, 1e-6, rounding);
  }
}

TEST(CameraFixed, ShowsTheMoonWhereTheSkyHasIt) {
  const auto sky = almanac::sky_at(almanac::instant_from_utc("2008-02-21T03:26:05Z"));
  const auto view = almanac::view_from({degrees(42.4), degrees(25), metres(10)}, sky);
  const HorizonPlace moon{atmosphere::apparent_altitude(view.altitude), view.azimuth};
  for (const auto& off : {glm::dvec2(10, 0), glm::dvec2(0, -7), glm::dvec2(-25, 12)}) {
    const HorizonPlace aim{moon.altitude + degrees(off.y), moon.azimuth + degrees(off.x)};
    const auto camera = camera_fixed(sky, view, aim, {degrees(80), 200, 100});
    const auto expected = gnomonic(moon, aim, 80), shown = *pixel_of(camera, view.sub_observer);
    EXPECT_WITHIN(shown.x, expected.x, 1e-6, rounding);
    EXPECT_WITHIN(shown.y, expected.y, 1e-6, rounding);
  }
}

TEST(CameraFixed, ShowsAMoonOnTheHorizonTenDegreesToTheRightByTheTangent) {
  const auto camera =
      camera_fixed(moon_at_the_equinox(), moon_in_the_east(atmosphere::lowest_true_altitude),
                   {degrees(0), degrees(80)}, {degrees(40), 200, 100});
  const auto shown = *pixel_of(camera, place(0, 0));
  const double tangent = std::tan(in_radians(degrees(10))),
               edge = std::tan(in_radians(degrees(20)));
  EXPECT_WITHIN(shown.x, 100 + 100 * tangent / edge, 1e-6, rounding);
  EXPECT_WITHIN(shown.y, 50, 0.003, "the horizon's altitude is given to 1e-4 degrees: 5e-4 pixel");
}

TEST(CameraFixed, LiftsALowMoonByItsRefraction) {
  // Meeus, chapter 16: at a true altitude of 1 degree, 1.02' / tan(1 + 10.3 / 6.11) = 21.75'.
  const auto camera = camera_fixed(moon_at_the_equinox(), moon_in_the_east(degrees(1)),
                                   {degrees(1), degrees(90)}, {degrees(4), 200, 100});
  const auto shown = *pixel_of(camera, place(0, 0));
  EXPECT_WITHIN(shown.x, 100, 1e-9, rounding);
  const double arcminutes_per_pixel = 4 * 60 / 200.;
  EXPECT_WITHIN((50 - shown.y) * arcminutes_per_pixel, 21.75, 0.02,
                "printed to 0.01'; the tangent's scale, 4e-4");
}

TEST(CameraFixed, HoldsTheHorizonLevelUnderALowMoon) {
  // The Moon's own vertical: straight up where it is in the middle's azimuth, and leaning to the
  // zenith, which is behind the top of the picture, where it is beside.
  const auto up_there = [](double azimuth_deg) {
    const auto camera = camera_fixed(moon_at_the_equinox(), moon_in_the_east(degrees(1)),
                                     {degrees(30), degrees(azimuth_deg)}, {degrees(60), 200, 100});
    return *pixel_of(camera, place(60, 0)) - *pixel_of(camera, place(-60, 0));
  };
  EXPECT_WITHIN(up_there(90).x, 0, 1e-9, rounding);
  EXPECT_LT(up_there(90).y, 0);
  EXPECT_LT(up_there(80).x, -0.01);
  EXPECT_GT(up_there(100).x, 0.01);
}

TEST(CameraFixed, AllowsAMoonThatIsNotInThePicture) {
  const auto camera = camera_fixed(moon_at_the_equinox(), moon_in_the_east(degrees(-40)),
                                   {degrees(10), degrees(-90)}, {degrees(60), 200, 100});
  EXPECT_FALSE(pixel_of(camera, place(0, 0)));
}

TEST(CameraFixed, RefusesTheZenithAndWhatIsNoPlaceOfTheSky) {
  const auto aimed = [](double altitude_deg, double azimuth_deg) {
    return camera_fixed(moon_at_the_equinox(), moon_in_the_east(degrees(40)),
                        {degrees(altitude_deg), degrees(azimuth_deg)}, {degrees(60), 200, 100});
  };
  EXPECT_NO_THROW(aimed(89, 360));
  EXPECT_THROW(aimed(90, 0), Error);
  EXPECT_THROW(aimed(-91, 0), Error);
  EXPECT_THROW(aimed(10, 361), Error);
  EXPECT_THROW(aimed(std::numeric_limits<double>::quiet_NaN(), 0), Error);
}

}  // namespace coppermoon::povray_scenes::scene_camera_test
