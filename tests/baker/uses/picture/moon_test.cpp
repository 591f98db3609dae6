// SPDX-License-Identifier: MIT
#include "uses/picture/moon.h"

#include <glm/geometric.hpp>

#include "colour/cie_observer.h"
#include "photons/solar_disc.h"
#include "support/testing.h"
#include "surface/albedo_map.h"
#include "surface/reflectance.h"
#include "uses/light/photometer.h"
#include "uses/light/spectral_bands.h"
#include "uses/picture/baked_moon.h"

namespace coppermoon::uses::moon_test {

/// A map of two rows, all texels 1 but one, and the ratio of that one's albedo to another's.
class AlbedoEncodings : public testing::Test {
 protected:
  double ratio(AlbedoEncoding encoding, int code, double exponent = 1) const {
    std::ofstream(path_, std::ios::binary)
        << "P5\n4 2\n255\n"
        << std::string("\xFF\xFF\xFF\xFF\xFF\xFF\xFF") << static_cast<char>(code);
    MoonRequest moon;
    moon.albedo_map = path_;
    moon.albedo_encoding = encoding;
    moon.albedo_exponent = exponent;
    const auto map = normal_albedo(moon);
    return map(1, 3) / map(1, 0);
  }
  void TearDown() override { std::filesystem::remove(path_); }

 private:
  std::string path_ = testing::TempDir() + "encoded_moon.pgm";
};

TEST_F(AlbedoEncodings, AreUndone) {
  using enum AlbedoEncoding;
  EXPECT_WITHIN_RELATIVE(ratio(normal_albedo, 102), 0.4, 1e-6, "floats");
  EXPECT_WITHIN_RELATIVE(ratio(normal_albedo, 102, 2), 0.16, 1e-6, "floats");
  EXPECT_WITHIN_RELATIVE(ratio(image, 102), 0.13287, 1e-4, "IEC 61966-2-1, five digits");
  EXPECT_WITHIN_RELATIVE(ratio(cgi_moon_kit_2025, 102), std::pow(0.13287, 1 / 1.56), 1e-4,
                         "the same");
}

/// NASA SVS 4720: "a gamma of 2.8", "the range (0.16, 0.4)": 0.4 of the way is a root of 0.256.
TEST_F(AlbedoEncodings, OfTheKitOf2019IsARootBetweenTwoEnds) {
  const double contrast = ratio(AlbedoEncoding::cgi_moon_kit_2019, 102);
  const double at_60_degrees = std::pow(0.256, 2.8) / std::pow(0.4, 2.8);
  // at latitude 45 nothing is mended
  EXPECT_WITHIN_RELATIVE(contrast, std::pow(at_60_degrees, 1 / 1.56), 1e-5, "floats");
}

/// A map whose first and last quarter are twice as bright as its middle half.
class MapCentre : public testing::Test {
 protected:
  MapCentre() {
    std::ofstream(moon.albedo_map = path_, std::ios::binary) << "P5\n8 4\n255\n"
                                                             << row << row << row << row;
    moon.albedo_encoding = AlbedoEncoding::normal_albedo;
    moon.when_near_side_brighter = [this](double ratio) { told = ratio; };
  }
  void TearDown() override { std::filesystem::remove(path_); }

  const std::string row{"\x64\x66\x32\x32\x32\x32\x64\x64"};
  MoonRequest moon;
  double told = 0;

 private:
  std::string path_ = testing::TempDir() + "map_from_zero.pgm";
};

TEST_F(MapCentre, Of180BringsTheEdgesOfAMapToItsMiddle) {
  const auto as_stored = normal_albedo(moon);
  EXPECT_EQ(told, 0);
  moon.albedo_map_centre_deg = 180;
  const auto turned = normal_albedo(moon);
  for (std::size_t c = 0; c < 8; ++c)
    EXPECT_WITHIN_RELATIVE(turned(1, (c + 4) % 8) / turned(1, 4), as_stored(1, c) / as_stored(1, 0),
                           1e-6, "floats");
  moon.albedo_map_centre_deg = 90;
  EXPECT_THROW(normal_albedo(moon), algebra::Error);
}

/// Maria lie on the near side: a map whose near side is the brighter one is likely to be turned round.
TEST_F(MapCentre, IsAskedAboutWhereTheNearSideIsTheBrighterOne) {
  moon.albedo_map_centre_deg = 180;
  normal_albedo(moon);
  EXPECT_WITHIN(told, (100 + 102 + 100 + 100) / 200., 1e-6, "floats");
  moon.albedo_map = "built-in";
  told = 0;
  normal_albedo(moon);
  EXPECT_EQ(told, 0);
}

MoonRequest built_in(bool by_place) {
  MoonRequest moon;
  moon.albedo_map = "built-in";
  moon.texture_width = 360;
  moon.unshadowed = true;
  moon.ground_by_place = by_place;
  return moon;
}

texture::Image baked_in_xyz(const MoonRequest& request, const almanac::SkyState& sky) {
  const auto moon = baked(lit_moon(request, sky), {colour::WorkingSpace::ciexyz_d65});
  const auto& layout = moon.parts[0].layout;
  texture::Image image(layout.width, layout.height, layout.channels);
  moon.parts[0].rows(0, image.values);
  return image;
}

/// X, Y and Z of sunlight from ground whose spectrum departs by c, over those from the mean ground's.
std::array<double, 3> departures(double c) {
  const auto xyz = colour::xyz_weights(band_edges_nm());
  const auto sun = photons::solar_irradiance(band_edges_nm());
  const auto nm = band_centres_nm();
  std::array<double, 3> own{}, mean{};
  double mean_y = 0, k_y = 0;
  const auto spectrum = [](double wavelength) {
    const double x = wavelength - 566;
    return -5.4578e-3 * x + 7.7136e-6 * x * x;
  };
  for (std::size_t b = 0; b < nm.size(); ++b) {
    const double light =
        sun[b] * surface::lunar_reflectance_yapo_cutler(algebra::nanometres(nm[b]));
    mean_y += light * xyz(1, b);
    k_y += light * xyz(1, b) * spectrum(nm[b]);
  }
  for (std::size_t b = 0; b < nm.size(); ++b)
    for (std::size_t k = 0; k < 3; ++k) {
      const double light =
          sun[b] * surface::lunar_reflectance_yapo_cutler(algebra::nanometres(nm[b])) * xyz(k, b);
      mean[k] += light;
      own[k] += light * (1 + c * (spectrum(nm[b]) - k_y / mean_y));
    }
  return {own[0] / mean[0], own[1] / mean[1], own[2] / mean[2]};
}

TEST(GroundByPlace, IsTheIntegralOverEachPlacesOwnSpectrum) {
  const auto sky = almanac::sky_at(almanac::instant_from_utc("2018-07-27T20:21:45Z"));
  const auto own = baked_in_xyz(built_in(true), sky), mean = baked_in_xyz(built_in(false), sky);
  const auto ground = ground_of(built_in(true), normal_albedo(built_in(true)));
  // where the Earth stands before the Sun the phase is the Earth's angular radius
  const auto phase = algebra::radians(std::asin(6378.137e3 / glm::length(sky.moon_m)));
  const double slope = surface::surge_slope(surface::Photometry::lommel_seeliger_rolo, phase);
  for (const auto& [row, column] : {std::pair<std::size_t, std::size_t>{81, 210},
                                    {62, 199},
                                    {133, 169},
                                    {75, 125},
                                    {100, 150}}) {
    const auto expected = departures(ground->colour(row, column));
    const double surge =
        1 + slope * surface::sampled(ground->surge, surface::texel_centre(row, column, 180));
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_WITHIN_RELATIVE(own(row, column, k) / mean(row, column, k), surge * expected[k], 1e-4,
                             "the place is nearer than the Moon's middle; wavelengths");
  }
}

/// At 1.5 degrees the disc is what ROLO measured, in any band.
TEST(GroundByPlace, LeavesTheDiscAsBrightAndAsRed) {
  const auto sky = almanac::sky_at(almanac::instant_from_utc("2008-02-21T00:36:00Z"));
  const auto meter = photometer();
  const auto disc = [&](bool by_place) {
    const auto request = built_in(by_place);
    const auto albedo = normal_albedo(request);
    const auto ground = ground_of(request, albedo);
    const auto weights =
        ground ? reddest_and_bluest(meter.weights, band_centres_nm()) : meter.weights;
    return measured(meter,
                    texture::bake({albedo, sky, shadow::Lookup(weights), ground.get()},
                                  meter.channels, 180, request.photometry),
                    sky)
        .magnitudes;
  };
  const auto own = disc(true), mean = disc(false);
  for (std::size_t band = 0; band < own.size(); ++band)
    EXPECT_WITHIN(own[band], mean[band], 1e-3, "libration: the disc's mean is of longitude 0");
}

}  // namespace coppermoon::uses::moon_test
