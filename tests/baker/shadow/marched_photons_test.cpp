// SPDX-License-Identifier: MIT
#include "shadow/marched_photons.h"

#include "atmosphere/presets.h"
#include "photons/bending.h"
#include "shadow/photon_rows.h"
#include "support/every_target.h"
#include "support/testing.h"

namespace coppermoon::shadow {
namespace {

using atmosphere::Atmosphere;
using photons::Marching;
using photons::Precision;
using photons::WholeLimb;

const Arrangement february_2008{1.479e11, {3.83e8}};

std::vector<double> wavelengths_nm(std::size_t count) {
  std::vector<double> waves;
  for (std::size_t i = 0; i < count; ++i)
    waves.push_back(381 + 398. * static_cast<double>(i) / static_cast<double>(count));
  return waves;
}

Atmosphere air_of(const char* preset) { return atmosphere::preset(preset, algebra::degrees(-20)); }

/// The limb's parts, some wavelengths, and an aim at every kilometre of each part.
struct Scene {
  Atmosphere air;
  std::vector<atmosphere::Optics> optics;
  WholeLimb limb;
  std::vector<Aim> aims;

  Scene(const Atmosphere& atmosphere, std::size_t waves)
      : air(atmosphere), optics(optics_of(air, wavelengths_nm(waves))), limb(air, optics, 20) {
    for (std::size_t part = 0; part < limb.parts().size(); ++part)
      for (double h = 510; h < 40e3; h += 997) aims.push_back({part, 0, 0, h, {0, 1}, {0, 0}, 3e6});
  }

  MarchedPhotons photons(const Marching& marching) const {
    return {limb.parts(), optics, marching};
  }

  photons::LimbPath exact(const Aim& aim, const atmosphere::Optics& o) const {
    const auto& part = limb.parts()[aim.part];
    return photons::limb_path(aim.tangent_height_m, part.curvature_radius_m, part.column,
                              o.refractivity);
  }
};

MarchedRows rows_of(const Scene& scene, const Marching& marching) {
  const auto photons = scene.photons(marching);
  MarchedRows rows(scene.aims.size(), scene.optics.size());
  photons.pass(photons.followed(scene.aims), rows);
  return rows;
}

/// The worst relative error of bending, over all photons and wavelengths.
double worst_bending(const Scene& scene, const MarchedRows& rows) {
  double worst = 0;
  for (std::size_t i = 0; i < scene.aims.size(); ++i)
    for (std::size_t w = 0; w < scene.optics.size(); ++w)
      worst = std::max(worst, std::abs(rows.bending_rad(i, w) /
                                           scene.exact(scene.aims[i], scene.optics[w]).bending_rad -
                                       1));
  return worst;
}

constexpr double float_rounding = 3e-7;  // of two sums of three

TEST(MarchedPhotons, AreBentAsTheMarcherStates) {
  for (const char* preset : {"paper", "undated"}) {
    const Scene few(air_of(preset), 3);
    EXPECT_WITHIN(worst_bending(few, rows_of(few, {1000})), 0., 5e-7 + float_rounding,
                  "1 km as march.h says");
    const double coarse = worst_bending(few, rows_of(few, {30e3}));
    EXPECT_WITHIN(coarse, 0., 5e-4 + float_rounding, "30 km as march.h says");
    EXPECT_GT(coarse, 2e-5) << "a step that is seen";
  }
}

TEST(MarchedPhotons, OfManyWavelengthsAreAsExactAsThreeRefractivitiesMakeThem) {
  const Scene many(air_of("undated"), 37);
  const auto rows = rows_of(many, {1000});
  for (std::size_t i = 0; i < many.aims.size(); ++i)
    for (std::size_t w = 0; w < many.optics.size(); ++w)
      EXPECT_WITHIN(rows.bending_rad(i, w), many.exact(many.aims[i], many.optics[w]).bending_rad,
                    3e-8, "LimbTable's at 577 rays, 1e-3 · 10/577²");
}

TEST(MarchedPhotons, InSinglePrecisionAreThoseInFull) {
  const Scene scene(air_of("undated"), 37);
  const auto full = rows_of(scene, {1000}), single = rows_of(scene, {1000, Precision::single});
  for (std::size_t i = 0; i < scene.aims.size(); ++i)
    for (std::size_t w = 0; w < scene.optics.size(); ++w)
      EXPECT_WITHIN_RELATIVE(single.bending_rad(i, w), full.bending_rad(i, w), 5e-6,
                             "4e-6 as march.h says, and both precisions' rounding");
}

/// Light and landing of one wavelength from limb_path.
struct Exact {
  double optical_depth, light, landing_m;
};

Exact exact(const Scene& scene, Aim aim, const atmosphere::Optics& o) {
  const auto& part = scene.limb.parts()[aim.part];
  const auto path = scene.exact(aim, o);
  const double depth = atmosphere::product(path.amounts, atmosphere::spectra(part.column, o));
  const double filter = limb_filter(part.column, o, aim.tangent_height_m);
  const double b = part.radius_m + path.impact_height_m;
  aim.tangent_height_m += 0.5;
  const double above_m = scene.exact(aim, o).impact_height_m;
  aim.tangent_height_m -= 1;
  const double db_dh = above_m - scene.exact(aim, o).impact_height_m;
  return {depth, 2 * std::numbers::pi * aim.weight_m * b * db_dh * std::exp(-depth) * filter,
          landing_m(b, path.bending_rad, february_2008.sun_distance_m, february_2008.depths_m[0])};
}

void expect_the_exact_light(const char* preset, double of_light, const char* reason) {
  const Scene scene(air_of(preset), 37);
  const auto rows = rows_of(scene, {1000});
  algebra::Grid<float> landed(scene.aims.size(), padded(scene.optics.size()));
  land(rows, scene.aims.size(), february_2008.sun_distance_m, february_2008.depths_m[0], landed);
  for (std::size_t i = 0; i < scene.aims.size(); ++i)
    for (std::size_t w = 0; w < scene.optics.size(); w += 4) {
      const auto expected = exact(scene, scene.aims[i], scene.optics[w]);
      EXPECT_WITHIN_RELATIVE(rows.light(i, w), expected.light,
                             of_light * (1 + expected.optical_depth), reason);
      EXPECT_WITHIN(landed(i, w), expected.landing_m, 3, "as the header says");
    }
}

TEST(MarchedPhotons, LandAndShineAsTheExactRayDoes) {
  support::on_every_target([] {
    expect_the_exact_light("paper", 5e-7, "as the header says");
    expect_the_exact_light("molecular", 5e-7, "as the header says");
    expect_the_exact_light("undated", 5e-5, "what limb_path states of ozone and aerosol");
  });
}

TEST(MarchedPhotons, ThatArePaddedCarryNothing) {
  const Scene scene(air_of("paper"), 37);
  const auto rows = rows_of(scene, {10e3});
  for (std::size_t w = 37; w < padded(37); ++w) {
    EXPECT_EQ(rows.light(3, w), 0);
    EXPECT_EQ(rows.bending_rad(3, w), rows.bending_rad(3, 36)) << "and land with the last";
  }
}

}  // namespace
}  // namespace coppermoon::shadow
