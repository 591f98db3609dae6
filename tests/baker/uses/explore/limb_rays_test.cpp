// SPDX-License-Identifier: MIT
#include "uses/explore/limb_rays.h"

#include "almanac/sky.h"
#include "baker/uses/explore/page_data.h"
#include "photons/bending.h"
#include "photons/earth_limb.h"
#include "shadow/twilight.h"
#include "support/testing.h"
#include "uses/light/air.h"

namespace coppermoon::uses::limb_rays_test {

const std::vector<double> waves{450, 550, 650};

atmosphere::Atmosphere air_of_2018(const std::string& name = "standard") {
  Air air;
  air.atmosphere = name;
  return atmosphere_of(air, almanac::sky_at(almanac::instant_from_utc("2018-07-27T20:21:45Z")));
}

/// The numbers of a page, and how many of each.
struct Rays {
  PageArrays arrays;
  nlohmann::ordered_json facts;
  std::size_t rays, nodes, kinds;
  std::vector<float> heights, bending, excess, amounts, spectra, blend;

  explicit Rays(const atmosphere::Atmosphere& air)
      : facts(add_limb_rays(arrays, air, waves)),
        rays(arrays.index()["limb.bending"]["shape"][2]),
        nodes(arrays.index()["limb.bending"]["shape"][1]),
        kinds(facts["absorbers"].size()),
        heights(numbers_in_page(arrays, "limb.heights")),
        bending(numbers_in_page(arrays, "limb.bending")),
        excess(numbers_in_page(arrays, "limb.excess")),
        amounts(numbers_in_page(arrays, "limb.amounts")),
        spectra(numbers_in_page(arrays, "limb.spectra")),
        blend(numbers_in_page(arrays, "limb.blend")) {}

  double share(std::size_t wave, std::size_t node) const {
    return blend[wave * (nodes - 1) + node];
  }
  double bending_at(std::size_t part, std::size_t wave, std::size_t ray) const {
    double sum = 0;
    for (std::size_t k = 0; k + 1 < nodes; ++k)
      sum += share(wave, k) * bending[(part * nodes + k) * rays + ray];
    return sum;
  }
  double optical_depth(std::size_t part, std::size_t wave, std::size_t ray) const {
    double sum = 0;
    for (std::size_t k = 0; k + 1 < nodes; ++k)
      for (std::size_t a = 0; a < kinds; ++a)
        sum += share(wave, k) * amounts[((part * nodes + k) * rays + ray) * kinds + a] *
               spectra[(part * waves.size() + wave) * kinds + a];
    return sum;
  }
};

TEST(LimbRays, AreTheExactOnesWhenTheyAreBlended) {
  const auto air = air_of_2018();
  const Rays page(air);
  const auto optics = shadow::optics_of(air, waves);
  const photons::WholeLimb limb(air, optics, 4);
  for (const std::size_t part : {std::size_t{0}, limb.parts().size() / 2})
    for (std::size_t w = 0; w < waves.size(); ++w)
      for (const std::size_t ray : {std::size_t{10}, std::size_t{60}, std::size_t{130}}) {
        const auto& where = limb.parts()[part];
        const double impact_m = 1e3 * (page.heights[ray] + optics[w].refractivity *
                                                               page.excess[part * page.rays + ray]);
        const auto exact =
            photons::limb_ray(impact_m, where.curvature_radius_m, where.column, optics[w]);
        ASSERT_TRUE(exact);
        EXPECT_WITHIN_RELATIVE(page.bending_at(part, w, ray), exact->bending_rad, 1e-4,
                               "three refractivities, single precision, the ground's two radii");
        EXPECT_WITHIN_RELATIVE(page.optical_depth(part, w, ray), exact->optical_depth, 1e-3,
                               "profiles by table, 25 m apart, and as above");
      }
}

TEST(LimbRays, OfTheLastRefractivityGoStraight) {
  const Rays page(air_of_2018());
  for (std::size_t ray = 0; ray < page.rays; ++ray)
    EXPECT_EQ(page.bending[(page.nodes - 1) * page.rays + ray], 0);
}

TEST(LimbRays, KnowOzoneAsAFilterAndADeckOfCloud) {
  const auto air = air_of_2018("paper");
  const Rays page(air);
  const auto optics = shadow::optics_of(air, waves);
  EXPECT_EQ(page.facts["parts"].size(), 1U);
  const std::size_t ray = page.rays / 3;
  const auto path =
      photons::limb_path(1e3 * page.heights[ray], 6.378e6, air.column, optics[1].refractivity);
  const double depth =
      atmosphere::product(path.amounts, atmosphere::spectra(air.column, optics[1])) -
      std::log(atmosphere::limb_filter(air.column, optics[1], 1e3 * page.heights[ray]));
  EXPECT_WITHIN_RELATIVE(page.optical_depth(0, 1, ray), depth, 1e-3, "as above");
  EXPECT_EQ(Rays(air_of_2018("undated")).facts["parts"][0]["cloudCover"],
            air_of_2018("undated").column.cloud_cover);
}

TEST(ScatteredLight, IsTheTwilightsMeanAroundTheAxis) {
  const auto air = air_of_2018();
  const shadow::Arrangement arrangement{1.5e11, {3.8e8}, true};
  PageArrays arrays;
  add_scattered_light(arrays, air, arrangement, waves);
  const auto numbers = numbers_in_page(arrays, "scattered");
  const std::vector<double> distances{2e6};
  const auto exact = shadow::mean_ratio(shadow::twilight(air, arrangement, waves, distances));
  for (const std::size_t w : {0, 2})  // the one between is on a straight line
    EXPECT_WITHIN_RELATIVE(numbers[waves.size() + w], exact(0, w), 1e-6, "single precision");
  EXPECT_WITHIN_RELATIVE(numbers[waves.size() + 1], (exact(0, 0) + exact(0, 2)) / 2, 1e-6,
                         "as above");
}

}  // namespace coppermoon::uses::limb_rays_test
