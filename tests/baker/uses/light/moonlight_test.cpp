// SPDX-License-Identifier: MIT
#include "uses/light/moonlight.h"

#include <unistd.h>

#include "almanac/instant.h"
#include "baker/uses/light/dusty_air.h"
#include "colour/working_space.h"
#include "end_to_end/true_luminance.h"
#include "support/testing.h"
#include "uses/light/spectral_bands.h"

namespace coppermoon::uses::moonlight_test {

const double radius_m = algebra::in_metres(almanac::lunar_radius);

/// The largest error over a circle of places half way out on the disc, some where direct light begins.
double true_error(const ShadowedMoon& moon, const Moonlight& light) {
  const double middle = algebra::in_metres(moon.centre.axis_distance);
  const double depth = algebra::in_metres(moon.centre.depth) - 0.5 * radius_m;
  const shadow::Arrangement plane{moon.sun_distance_m, {depth}};
  const double edge = moon.air.top_radius_m() * (1 + depth / moon.sun_distance_m) -
                      projected_solar_radius_m(plane, depth);
  auto places = std::vector<double>{};
  for (int i = 0; i <= 20; ++i) places.push_back(middle + (i - 10) * 0.08 * radius_m);
  for (int i = -2; i <= 8; ++i) places.push_back(edge + i * 2.5e3);
  std::erase_if(places, [&](double m) { return m < 0 || std::abs(m - middle) > 0.86 * radius_m; });
  std::ranges::sort(places);
  const std::vector<double> angles(places.size(), algebra::in_radians(moon.centre.position_angle));
  const auto exact =
      end_to_end::TrueLuminance(moon, {.bands = 200, .rays = 2000}).at(depth, places, angles);
  const auto luminance = light.in_channels(luminance_weights());
  double worst = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    std::array<double, 1> found;
    luminance.read({.axis_distance = algebra::metres(places[i]),
                    .position_angle = algebra::radians(angles[i]),
                    .depth = algebra::metres(depth)},
                   found);
    worst = std::max(worst, std::abs(found[0] / exact[i] - 1));
  }
  return worst;
}

void expect_kept(const char* utc, const LightRequest& request) {
  const auto sky = almanac::sky_at(almanac::instant_from_utc(utc));
  const auto light = light_on_the_moon(request, sky);
  const double error = true_error(shadowed_moon(request, sky), light);
  EXPECT_LE(error, light.plan.error) << utc;
  EXPECT_GE(3 * light.error_found + 1e-5, error)
      << utc << ": as planned_runs_test has it, a third, or a tenth of the finest tolerance";
}

TEST(LightOnTheMoon, ThroughThePapersDustyAirIsAsExactAsPlanned) {
  expect_kept("2034-09-28T02:55:57Z", dusty_air_of_the_paper(0.002));
  expect_kept("1954-01-19T01:00:00Z", dusty_air_of_the_paper(0.001));
  expect_kept("1954-01-19T02:06:51Z", dusty_air_of_the_paper(0.01));
}

TEST(LightOnTheMoonThoroughly, ThroughThePapersDustyAirIsAsExactAsPlanned) {
  for (const char* utc : {"2034-09-28T02:20:00Z", "2034-09-28T02:46:00Z", "2008-02-21T01:50:00Z",
                          "2008-02-21T03:26:05Z", "2011-06-15T18:40:00Z", "1954-01-19T01:00:00Z"})
    for (const double dust : {1e-6, 4.7e-6, 2e-5})
      for (const double tolerance : {0.001, 0.002, 0.01, 0.05}) {
        auto request = dusty_air_of_the_paper(tolerance);
        request.air.column.dust_extinction_per_m = dust;
        expect_kept(utc, request);
      }
}

TEST(LightOnTheMoon, OfUsualQualityHasTheRedAndGreenOfFourHundredBands) {
  LightRequest usual, fine;
  fine.by_hand.bands = 400;
  const auto rec709 = moonlight_weights(
      colour::channel_weights(colour::WorkingSpace::linear_rec709, band_edges_nm()));
  for (const char* utc : {"2018-07-27T19:40:17Z", "2018-07-27T20:21:45Z", "2015-09-28T03:40:00Z"}) {
    const auto sky = almanac::sky_at(almanac::instant_from_utc(utc));
    const auto moon = shadowed_moon(usual, sky);
    const auto found = light_on_the_moon(usual, sky, {.error_told = false}).in_channels(rec709),
               exact = light_on_the_moon(fine, sky, {.error_told = false}).in_channels(rec709);
    const double middle = algebra::in_metres(moon.centre.axis_distance);
    for (double m = std::max(0., middle - 0.9 * radius_m); m < middle + 0.9 * radius_m;
         m += 200e3) {
      const eclipse::ShadowPlace place{.axis_distance = algebra::metres(m),
                                       .position_angle = moon.centre.position_angle,
                                       .depth = moon.centre.depth - algebra::metres(radius_m / 2)};
      std::array<double, 3> here, there;
      found.read(place, here);
      exact.read(place, there);
      for (const std::size_t channel : {0U, 1U})
        EXPECT_WITHIN_RELATIVE(here[channel], there[channel], 0.01,
                               "twice the error of luminance by 32 bands, and other settings")
            << utc << ", " << m / 1e3 << " km, "
            << "RG"[channel];
    }
  }
}

TEST(LightOnTheMoon, OfPhotonsKeepsToItsBudget) {
  LightRequest request;
  request.solver = Solver::table;
  request.wish = {.tolerance = 1e-4, .budget_s = 1e-3};  // not to be had together
  const auto sky = almanac::sky_at(almanac::instant_from_utc("2008-02-21T03:26:05Z"));
  const auto light = light_on_the_moon(request, sky);
  EXPECT_LE(light.refracted->photons, 1U << 20U) << "not until the tolerance is reached";
}

/// Recipe 2801 of the sweep: dust over some degrees of the limb, behind which all is dark.
TEST(LightOnTheMoon, OfPhotonsThatNobodyAskedForComesToAnEnd) {
  LightRequest request;
  request.air.regions = {
      {.from_latitude = 33.7, .to_latitude = 40.4, .column = {.dust_extinction_per_m = 4.8e-5}},
      {.from_position_angle = 332.8,
       .to_position_angle = 142.5,
       .column = {.dust_extinction_per_m = 2.8e-8}}};
  request.air.column.tropospheric_optical_depth = 4.64;
  request.air.column.cloud_top_km = 16.57;
  request.limb_darkening = false;
  request.wish.tolerance = 0.41;
  const auto sky = almanac::sky_at(almanac::instant_from_utc("1992-12-09T23:46:56Z"));
  const auto light = light_on_the_moon(request, sky);
  EXPECT_LE(light.refracted->photons, 1U << 24U) << "seconds, instead of ever more";
}

class PhotonFilesTest : public testing::Test {
 protected:
  PhotonFilesTest() { std::filesystem::create_directory(folder); }
  ~PhotonFilesTest() override { std::filesystem::remove_all(folder); }

  std::filesystem::path file(const std::string& name) const { return folder / name; }

  static shadow::RefractedLight light(const PhotonFiles& files) {
    LightRequest request;
    request.solver = Solver::table;
    request.photons = 50'000;
    request.ring_km = 500;
    request.photon_files = files;
    const std::array waves{500., 650.};
    return refracted_light(request, {}, {1.479e11, {3.83e8}}, {waves});
  }

  std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("photon_files_" + std::to_string(getpid()));
};

TEST_F(PhotonFilesTest, OfThreeShardsMakeTheLightOfOneRun) {
  PhotonFiles all;
  for (std::size_t part = 1; part <= 3; ++part) {
    const auto path = file(std::to_string(part));
    EXPECT_LT(light({.shard = Shard{part, 3}, .keep = path}).photons, 18'000U);
    all.add.push_back(path);
  }
  const auto together = light(all), whole = light({});
  EXPECT_EQ(together.photons, whole.photons);
  for (std::size_t i = 0; i < whole.ratio[0].values().size(); ++i)
    EXPECT_WITHIN_RELATIVE(together.ratio[0].values()[i], whole.ratio[0].values()[i], 1e-12,
                           "rounding of sums in another order");
}

TEST_F(PhotonFilesTest, OfTheSamePhotonsAreRefused) {
  light({.shard = Shard{1, 3}, .keep = file("one")});
  EXPECT_THROW(light({.add = {file("one"), file("one")}}), algebra::Error);
}

TEST_F(PhotonFilesTest, OfAnotherSceneAreRefused) {
  light({.shard = Shard{1, 3}, .keep = file("one"), .key = "its air"});
  EXPECT_THROW(light({.add = {file("one")}, .key = "other air"}), algebra::Error);
}

TEST_F(PhotonFilesTest, MeanNothingToTheQuadrature) {
  LightRequest request;
  request.photon_files.shard = Shard{1, 3};
  const auto sky = almanac::sky_at(almanac::instant_from_utc("2008-02-21T03:26:05Z"));
  EXPECT_THROW(light_on_the_moon(request, sky), algebra::Error);
}

TEST(ShardFrom, RefusesWhatIsNone) {
  for (const std::string shard : {"3", "a/b", "0/3", "4/3", "1/0", "-1/3", "/", "1/2/3"})
    EXPECT_THROW(shard_from(shard), algebra::Error) << shard;
}

}  // namespace coppermoon::uses::moonlight_test
