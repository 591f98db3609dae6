// SPDX-License-Identifier: MIT
#include "shadow/limb_landings.h"

#include <glm/geometric.hpp>

#include "baker/shadow/by_the_table.h"
#include "photons/photon.h"
#include "support/testing.h"

namespace coppermoon::shadow::limb_landings_test {

TEST_F(ByTheTable, StopAtTheirTolerance) {
  auto few = settings(100'000'000, 7);
  few.enough = StoppingRule{{0.2, 1, 0.1}, 0.05, 0, 4500e3};
  const auto light = in_rings({}, february_2008, waves, few);
  EXPECT_LE(worst_error(light, *few.enough), 0.05);
  EXPECT_LT(light.photons, 4'000'000U) << "far fewer than were allowed";
  int outside = 0;
  for (std::size_t r = 0; r < rings; ++r) {
    double value = 0, truth = 0;
    for (std::size_t w = 0; w < waves.size(); ++w) {
      value += few.enough->weights[w] * light.ratio[0](r, w);
      truth += few.enough->weights[w] * exact(r, w);
    }
    outside += std::abs(value / truth - 1) > 0.05;
  }
  EXPECT_LE(outside, 12) << "of 90 at 95 % confidence, 4.5; Poisson, one run in a thousand fails";
}

TEST_F(ByTheTable, StopAtTheirCapWhereTheToleranceIsOutOfReach) {
  auto capped = settings(50'000, 7);
  capped.enough = StoppingRule{{1, 1, 1}, 1e-4, 0, 4500e3};
  const auto light = in_rings({}, february_2008, waves, capped);
  EXPECT_EQ(light.photons, 49 * photons_a_block) << "50 000 rounded up to whole blocks";
}

TEST_F(ByTheTable, SayAHundredPercentWhereBlocksAreTooFew) {
  const auto light = in_rings({}, february_2008, waves, settings(7 * photons_a_block, 7));
  EXPECT_EQ(light.standard_error[0](40, 1), light.ratio[0](40, 1));
  EXPECT_GT(light.ratio[0](40, 1), 0);
}

TEST_F(ByTheTable, LandOnEveryPlane) {
  // Planes apart by the Moon's radius; Bonferroni: 120 rings, one true run in a thousand has one
  // beyond 4.5 errors.
  const Arrangement planes{1.479e11, {3.813e8, 3.822e8, 3.83e8}, true};
  const auto light = in_rings({}, planes, waves, settings(1'000'000, 8));
  for (const std::size_t plane : {0U, 2U}) {
    const auto means = ring_means({}, {1.479e11, {planes.depths_m[plane]}, true}, waves, 50e3, 60);
    for (std::size_t r = 0; r < 60; ++r)
      EXPECT_WITHIN(light.ratio[plane](r, 1), means(r, 1), 4.5 * light.standard_error[plane](r, 1),
                    "4.5 standard errors");
  }
}

TEST(LimbLandings, AimFromTheSunAtTheAirAndLandSpreadEvenly) {
  // Every aim leaves the Sun's disc for a height between ground and top; landings of the middle
  // wavelength take each sixteenth of the axis distances in turn, as 1024 strata do.
  const LimbLandings landings({}, february_2008, waves, 300);
  const double sun_m = projected_solar_radius_m(february_2008, february_2008.depths_m[0]);
  const auto aims = landings.aims(1, 2, false);
  algebra::Grid<float> landing_m(aims.size(), padded(waves.size()));
  landings.land(aims, 0, landing_m);
  std::vector<double> distances;
  for (std::size_t i = 0; i < aims.size(); ++i) {
    EXPECT_LE(glm::dot(aims[i].source, aims[i].source), 1 + 1e-9);
    EXPECT_GE(aims[i].tangent_height_m, 0);
    EXPECT_LE(aims[i].tangent_height_m, 42e3);
    const glm::dvec2 landed =
        static_cast<double>(landing_m(i, 1)) * aims[i].toward - sun_m * aims[i].source;
    distances.push_back(std::hypot(landed.x, landed.y));
  }
  ASSERT_GT(distances.size(), 990U) << "nearly all of 1024 land";
  std::sort(distances.begin(), distances.end());
  const double step =
      (distances.back() - distances.front()) / static_cast<double>(distances.size() - 1);
  for (std::size_t i = 0; i < distances.size(); ++i)
    EXPECT_WITHIN(distances[i], distances.front() + static_cast<double>(i) * step, 30 * step,
                  "strata jittered by one, and two dozen that meet no light at the rim");
}

}  // namespace coppermoon::shadow::limb_landings_test
