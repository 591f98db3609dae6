// SPDX-License-Identifier: MIT
#include "uses/picture/view.h"
#include "almanac/gazetteer.h"
#include "almanac/instant.h"
#include "atmosphere/astronomical_refraction.h"
#include "support/testing.h"

namespace coppermoon::uses::view_test {

constexpr const char* reason = "rounding between degrees and radians";

almanac::SkyState mid_eclipse() {
  return almanac::sky_at(almanac::instant_from_utc("2008-02-21T03:26:05Z"));
}

almanac::Observer at(double latitude, double longitude, double elevation_m = 0) {
  return {algebra::degrees(latitude), algebra::degrees(longitude), algebra::metres(elevation_m)};
}

const auto low_moon = at(42, 47.3), just_set = at(42, 50.3), half_set = at(42, 50.6),
           set = at(42, 52);

ViewRequest from(const almanac::Observer& observer) { return {.observer = observer}; }

TEST(ViewOf, ReddensTheMoonOnlyThroughAir) {
  const auto sky = mid_eclipse();
  auto request = from(at(42.86, -73.77));
  EXPECT_FALSE(view_of({}, sky).sightline);
  EXPECT_TRUE(view_of(request, sky).sightline);
  request.reddening = false;
  EXPECT_FALSE(view_of(request, sky).sightline);
}

TEST(ViewOf, LooksThroughTheAirItIsTold) {
  auto request = from(at(42.86, -73.77, 120));
  request.observer_ozone_du = 250;
  request.observer_aerosol = 0.05;
  const auto air = view_of(request, mid_eclipse()).sightline->air;
  EXPECT_EQ(air.ozone_du, 250);
  EXPECT_EQ(air.aerosol_optical_depth, 0.05);
  EXPECT_WITHIN(air.elevation_m, 120, 1e-9, reason);
  request.observer_aerosol = -1;
  EXPECT_THROW(view_of(request, mid_eclipse()), algebra::Error);
}

TEST(ViewOf, FlattensTheMoonOnlyThroughAir) {
  const auto sky = mid_eclipse();
  auto request = from(low_moon);
  EXPECT_EQ(view_of({}, sky).camera.flattening, 1);
  const double flattening = view_of(request, sky).camera.flattening;
  EXPECT_WITHIN(flattening, 0.93, 0.05, "0.9 at 1 degree, 0.955 at 3");
  request.reddening = false;
  EXPECT_EQ(view_of(request, sky).camera.flattening, flattening);
  request.flattening = false;
  EXPECT_EQ(view_of(request, sky).camera.flattening, 1);
}

TEST(ViewOf, ShowsAMoonThatOnlyRefractionLiftsOverTheHorizon) {
  const auto sky = mid_eclipse();
  const auto view = view_of(from(just_set), sky);
  const double altitude_deg = in_degrees(view.sightline->altitude);
  EXPECT_TRUE(altitude_deg < -0.1 && altitude_deg > -0.5) << altitude_deg;
  EXPECT_THROW(view_of(from(set), sky), algebra::Error);
}

TEST(ViewOf, TakesTheFieldFromLensAndSensorUnlessTold) {
  const auto sky = mid_eclipse();
  const double paper_deg = 2 * std::atan(22.7 / 1540 / 2) * 180 / std::numbers::pi;
  const ViewRequest lens{.focal_length_mm = 1540};
  EXPECT_WITHIN(in_degrees(view_of(lens, sky).camera.horizontal_field), paper_deg, 1e-12, reason);
  ViewRequest told;
  told.field_deg = 2;
  EXPECT_WITHIN(in_degrees(view_of(told, sky).camera.horizontal_field), 2, 1e-12, reason);
}

TEST(ViewOf, HoldsTheWholeMoonWithoutALensOnAFrameOfAnyShape) {
  // The nearest full Moon of the century, 1912-01-04, is 356 375 km from the Earth's centre, and an Earth's
  // radius less from where it stands in the zenith: 2 asin(1737.4 / 350 000) = 0.569 degrees.
  constexpr double largest_deg = 0.569;
  for (const auto& [width, height] : {std::pair{1500, 1000}, {400, 900}, {64, 64}, {1920, 800}}) {
    ViewRequest request;
    request.width = static_cast<std::size_t>(width);
    request.height = static_cast<std::size_t>(height);
    const auto camera = view_of(request, mid_eclipse()).camera;
    const double per_degree = 180 / std::numbers::pi,
                 tangent = std::tan(algebra::in_radians(camera.horizontal_field) / 2),
                 vertical = 2 * std::atan(tangent * height / width) * per_degree;
    const double shorter = std::min(in_degrees(camera.horizontal_field), vertical);
    EXPECT_GT(shorter, 1.04 * largest_deg) << "some margin";
    EXPECT_LT(shorter, 1.3 * 0.49) << "the farthest Moon still fills three quarters";
  }
}

TEST(ViewOf, SaysHowFarBelowTheHorizonTheMoonIs) {
  const auto said = refusal_of([] { view_of(from(at(-30, 150)), mid_eclipse()); });
  EXPECT_TRUE(said.starts_with("from -30,150 the Moon is ")) << said;
  EXPECT_TRUE(said.ends_with("° below the horizon then; choose another moment or place, or none"))
      << said;
  const auto tokyo = almanac::city_named("Tokyo")->place;
  const auto of_city = refusal_of([&] { view_of(from(tokyo), mid_eclipse()); });
  EXPECT_TRUE(of_city.starts_with("from Tokyo the Moon")) << of_city;
}

/// A frame of ones.
texture::Image bright_frame(const View& view) {
  texture::Image frame(view.camera.width, view.camera.height, {"R", "G", "B"});
  std::ranges::fill(frame.values, 1.F);
  return frame;
}

TEST(TheHorizon, IsLoweredAsTheObserverIsHigher) {
  // 1.17' times the square root of feet above the sea: 3 degrees lower at 7218 m, 23681 ft
  EXPECT_WITHIN(in_arcminutes(horizon_altitude(at(0, 0))), -34, 1e-9, reason);
  EXPECT_WITHIN(in_arcminutes(horizon_altitude(at(0, 0, 7218))), -34 - 180, 0.2,
                "arcminutes: 1.17 and 2.12 are of three digits");
  EXPECT_EQ(horizon_altitude(at(0, 0, -430)), horizon_altitude(at(0, 0)));
  EXPECT_FALSE(moon_is_up(from(at(42, 53)), mid_eclipse()));
  EXPECT_TRUE(moon_is_up(from(at(42, 53, 4000)), mid_eclipse()));
  EXPECT_NO_THROW(view_of(from(at(42, 53, 4000)), mid_eclipse()))
      << "two degrees below where the air's formulas end";
}

TEST(TheHorizon, HidesTheLowerPartOfARisingMoon) {
  const auto sky = mid_eclipse();
  auto request = from(half_set);
  request.width = request.height = 100;
  request.up = povray_scenes::Up::zenith;
  const auto view = view_of(request, sky);
  auto frame = bright_frame(view);
  hide_below_horizon(frame, view, sky);
  const auto seen = almanac::view_from(half_set, sky);
  // refraction lifts the Moon over the horizon by so much; the field is of 0.6 degrees
  const double above_deg =
      in_degrees(seen.altitude + atmosphere::astronomical_refraction(seen.altitude));
  const double row = 50 + above_deg / 0.6 * 100;
  ASSERT_TRUE(row > 55 && row < 95) << row;
  EXPECT_EQ(frame(0, 50, 0), 1);
  EXPECT_EQ(frame(static_cast<std::size_t>(row) - 3, 50, 0), 1);
  EXPECT_EQ(frame(static_cast<std::size_t>(row) + 3, 50, 1), 0)
      << "3 pixels are 1': between almanacs' 34' and the formula of refraction are 0.4'";
  EXPECT_EQ(frame(99, 0, 2), 0);
  double column = 0;
  for (std::size_t r = 0; r < 100; ++r) column += static_cast<double>(frame(r, 10, 0));
  EXPECT_WITHIN(column, row, 1.5, "pixels: the same 0.4', 1.1 pixels, and the angle's tangent");
  auto high = from(at(42.86, -73.77));
  auto untouched = bright_frame(view_of(high, sky));
  hide_below_horizon(untouched, view_of(high, sky), sky);
  EXPECT_TRUE(std::ranges::all_of(untouched.values, [](float v) { return v == 1; }));
}

TEST(TheHorizon, StandsWhereAFixedCameraHasItToo) {
  const auto sky = mid_eclipse();
  auto request = from(low_moon);
  request.width = request.height = 100;
  request.field_deg = 10;
  const auto seen = apparent_place(low_moon, sky);
  request.aim = povray_scenes::HorizonPlace{algebra::degrees(0), seen.azimuth};
  const auto view = view_of(request, sky);
  auto frame = bright_frame(view);
  hide_below_horizon(frame, view, sky);
  EXPECT_EQ(frame(45, 50, 0), 1);
  EXPECT_EQ(frame(54, 50, 0), 0) << "the picture's middle is on the horizon";
  EXPECT_EQ(frame(45, 5, 0), 1);
  EXPECT_EQ(frame(54, 95, 0), 0) << "which is level";
}

TEST(PlaceText, IsWhatWasToldInSevenDigits) {
  EXPECT_EQ(place_text(at(42.86, -73.77)), "42.86,-73.77");
  EXPECT_EQ(place_text(at(-30, 150, 120)), "-30,150,120");
}

}  // namespace coppermoon::uses::view_test
