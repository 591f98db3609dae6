// SPDX-License-Identifier: MIT
#include "shadow/disc_arcs.h"

#include "shadow/irradiance.h"
#include "support/testing.h"

namespace coppermoon::shadow::disc_arcs_test {

using std::numbers::pi;

/// ∫ f(μ) cos mψ dψ along the arc of radius r about the axis, in many steps: what of the disc of
/// radius a about γ lies on it.
double along_arc(const photons::DiscFunction& f, double r, double gamma, double a, int m = 0) {
  constexpr int steps = 400'000;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double psi = pi * (i + 0.5) / steps;
    const double out = (r * r + gamma * gamma - 2 * r * gamma * std::cos(psi)) / (a * a);
    if (out < 1) sum += photons::value(f, std::sqrt(1 - out)) * std::cos(m * psi);
  }
  return 2 * pi / steps * sum;
}

TEST(DiscArcs, AreTheIntegralOverTheSunsDiscStepByStep) {
  const std::vector<double> waves{400, 550, 700};
  const auto sun = photons::disc_terms(waves, true, 6);
  for (const double gamma : {150., 420., 1500.}) {
    for (const auto& stretch : disc_stretches(sun, gamma, 450, 0, 0, 3000)) {
      if (stretch.to - stretch.from < 20) continue;
      const double middle = (stretch.from + stretch.to) / 2.;
      const double exact = along_arc(sun.functions[0], middle, gamma, 450);
      EXPECT_WITHIN_RELATIVE(stretch.light[1](0, 0), exact, 2e-5,
                             "a fifth of what the quadrature promises at 1000 rays")
          << gamma << " " << middle;
    }
  }
}

TEST(DiscArcs, HaveTheHarmonicsOfTheIntegralStepByStep) {
  const auto sun = photons::disc_terms(std::vector<double>{400, 550, 700}, true, 6);
  for (const double gamma : {150., 440., 1500.}) {
    for (const double r : {300., 580., 1200.})
      for (const auto& stretch :
           disc_stretches(sun, gamma, 450, 120, static_cast<int>(r), static_cast<int>(r) + 1)) {
        if (stretch.to - stretch.from == 1) continue;
        const double middle = (stretch.from + stretch.to) / 2.;
        for (const int m : {0, 1, 7, 40, 120})
          EXPECT_WITHIN(stretch.light[1](0, static_cast<std::size_t>(m)),
                        along_arc(sun.functions[0], middle, gamma, 450, m), 2e-5 * pi,
                        "as of the light of the whole arc")
              << gamma << " " << middle << " " << m;
      }
  }
}

}  // namespace coppermoon::shadow::disc_arcs_test
