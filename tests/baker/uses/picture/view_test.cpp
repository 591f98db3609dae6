// SPDX-License-Identifier: MIT
#include "uses/picture/view.h"

#include "algebra/error.h"
#include "almanac/instant.h"
#include "support/within.h"

namespace coppermoon::uses {
namespace {

constexpr const char* reason = "rounding between degrees and radians";

almanac::SkyState mid_eclipse() {
  return almanac::sky_at(almanac::instant_from_utc("2008-02-21T03:26:05Z"));
}

almanac::Observer at(double latitude, double longitude, double elevation_m = 0) {
  return {algebra::degrees(latitude), algebra::degrees(longitude), algebra::metres(elevation_m)};
}

const auto low_moon = at(42, 47.3), just_set = at(42, 50.3), set = at(42, 51);

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
  try {
    view_of(from(at(-30, 150)), mid_eclipse());
    FAIL() << "the Moon of one in the afternoon was seen";
  } catch (const algebra::Error& error) {
    EXPECT_NE(std::string(error.what()).find("degrees below the horizon of -30,150"),
              std::string::npos);
  }
}

TEST(PlaceText, IsWhatWasToldInSevenDigits) {
  EXPECT_EQ(place_text(at(42.86, -73.77)), "42.86,-73.77");
  EXPECT_EQ(place_text(at(-30, 150, 120)), "-30,150,120");
}

}  // namespace
}  // namespace coppermoon::uses
