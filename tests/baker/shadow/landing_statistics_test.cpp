// SPDX-License-Identifier: MIT
// Photons by the table of the limb: their means, their errors, their variance against plain photons.
#include <glm/geometric.hpp>

#include "baker/shadow/by_the_table.h"
#include "photons/photon.h"
#include "shadow/limb_landings.h"
#include "support/testing.h"

namespace coppermoon::shadow::landing_statistics_test {

TEST_F(ByTheTable, StandardErrorsAreThoseThatPhotonsMake) {
  // The mean over runs of 64 blocks of off²/error², which is t² of 63 degrees of freedom: 63/61.
  // How well the mean is known comes from the scatter of the runs themselves.
  constexpr int runs = 30;
  double sum = 0, squares = 0;
  for (int run = 0; run < runs; ++run) {
    const auto light = in_rings({}, february_2008, waves,
                                settings(64 * photons_a_block, 100 + static_cast<unsigned>(run)));
    double mean = 0;
    for (std::size_t r = 0; r < rings; ++r)
      for (std::size_t w = 0; w < waves.size(); ++w)
        mean += std::pow((light.ratio[0](r, w) - exact(r, w)) / light.standard_error[0](r, w), 2) /
                static_cast<double>(rings * waves.size());
    sum += mean;
    squares += mean * mean;
  }
  const double mean = sum / runs;
  const double error = std::sqrt((squares / runs - mean * mean) / (runs - 1));
  EXPECT_LT(error, 0.05) << "a test that sees errors of 10 %";
  EXPECT_WITHIN(mean, 63. / 61, 3.66 * error, "t of 29 degrees of freedom, one run in a thousand");
}

TEST_F(ByTheTable, MeansOfManyHaveNoBias) {
  // Bonferroni: 270 cells, one true run in a thousand has one of them beyond 4.6 errors.
  const auto light = in_rings({}, february_2008, waves, settings(4'000'000, 5));
  for (std::size_t r = 0; r < rings; ++r)
    for (std::size_t w = 0; w < waves.size(); ++w) {
      EXPECT_WITHIN(light.ratio[0](r, w), exact(r, w), 4.6 * light.standard_error[0](r, w),
                    "4.6 standard errors");
      EXPECT_LT(light.standard_error[0](r, w), 0.02 * exact(r, w)) << "a test that sees 10 %";
    }
}

struct Landing {
  double axis_distance_m, transmittance;
};

/// Through a sphere's air by straight lines between the rays of its fan; nothing where it meets the
/// ground.
std::optional<Landing> landed(const photons::Ray& ray, const photons::WholeLimb::Part& limb,
                              std::size_t wave) {
  const auto& fan = limb.fans[wave];
  const glm::dvec3 nearest =
      ray.position_m - glm::dot(ray.position_m, ray.direction) * ray.direction;
  const double b = glm::length(nearest), height = b - limb.radius_m;
  const auto& heights = fan.impact_height_m;
  const auto above = std::upper_bound(heights.begin(), heights.end(), height);
  if (above == heights.begin() || above == heights.end()) return std::nullopt;
  const auto i = static_cast<std::size_t>(above - heights.begin()) - 1;
  const double part = (height - heights[i]) / (heights[i + 1] - heights[i]);
  const double bending = std::lerp(fan.bending_rad[i], fan.bending_rad[i + 1], part),
               depth = std::lerp(fan.optical_depth[i], fan.optical_depth[i + 1], part);
  const double sine = std::sin(bending), cosine = std::cos(bending);
  const glm::dvec3 up = nearest / b;
  const photons::Ray leaving{b * (cosine * up + sine * ray.direction),
                             cosine * ray.direction - sine * up};
  const auto at = photons::at_depth(leaving, february_2008.depths_m[0]);
  return Landing{std::hypot(at.x, at.y), std::exp(-depth) * fan.filter[i]};
}

/// The mean over rings of the relative variance, of photons drawn one by one as they are traced:
/// uniform over the disc and over the ring's area.
double plain_variance(const algebra::Grid<double>& exact, std::size_t wave, int photons) {
  const atmosphere::Atmosphere air;
  const photons::WholeLimb limb(air, optics_of(air, waves), 500);
  std::vector<double> squares(exact.rows());
  for (int i = 0; i < photons; ++i) {
    algebra::Random random(1, static_cast<std::uint64_t>(i));
    const auto ray = photons::aimed_at_the_ring(random, february_2008.sun_distance_m, air);
    const auto light = landed(ray, limb.parts()[0], wave);
    if (!light) continue;
    const auto ring = static_cast<std::size_t>(light->axis_distance_m / 50e3);
    if (ring < exact.rows()) squares[ring] += light->transmittance * light->transmittance;
  }
  const double inner = photons::innermost_radius_m(air), outer = air.top_radius_m();
  const double spread = 1 + february_2008.depths_m[0] / february_2008.sun_distance_m;
  double mean = 0;
  for (std::size_t r = 0; r < exact.rows(); ++r) {
    const double scale = spread * spread * (outer * outer - inner * inner) /
                         (50e3 * 50e3 * (2 * static_cast<double>(r) + 1)) / exact(r, wave);
    mean += (scale * scale * squares[r] / photons - 1) / static_cast<double>(exact.rows());
  }
  return mean / photons;
}

TEST_F(ByTheTable, HaveATenthOfTheVarianceOfPlainPhotonsOrLess) {
  constexpr int photons = 1'000'000;
  const auto light = in_rings({}, february_2008, waves, settings(photons, 6));
  for (std::size_t w = 0; w < waves.size(); ++w) {
    double variance = 0;
    for (std::size_t r = 0; r < rings; ++r)
      variance += std::pow(light.standard_error[0](r, w) / exact(r, w), 2) / rings;
    EXPECT_LT(variance, plain_variance(exact, w, photons) / 10) << waves[w] << " nm";
  }
}

}  // namespace coppermoon::shadow::landing_statistics_test
