// SPDX-License-Identifier: MIT
// The air that explains three magnitudes of one eclipse: computed ones, of dust 3e-6, cover 0.5, 300 DU. All else of the
// air is alike everywhere: light is computed three times as fast as in the air of the month.
#include <coppermoon/uses/fit/fit.h>

#include <cmath>
#include <cstdio>

using namespace coppermoon;

int main() {
  const auto when = almanac::instant_from_utc("2018-07-27T20:21:45Z");
  const auto fit =
      uses::fitted_air({.magnitudes = {{when, "B", 2.55}, {when, "V", -0.47}, {when, "R", -3.20}},
                        .moon = {.light = {.air = {.atmosphere = "undated"}}}})
          .fit;
  const auto& [dust, cloud, ozone] = fit.posterior.estimates;
  std::printf("dust %.1e 1/m, cloud cover %.2f, ozone %.0f DU; %s\n", std::exp(dust.median),
              cloud.median, ozone.median, uses::explains(fit) ? "explained" : "not explained");
}
