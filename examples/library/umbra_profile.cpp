// SPDX-License-Identifier: MIT
// Light across the Earth's shadow over full sunlight, at three wavelengths, the mean around the axis.
#include <coppermoon/almanac/instant.h>
#include <coppermoon/uses/light/shadow_profile.h>

#include <cstdio>

using namespace coppermoon;

int main() {
  const auto sky = almanac::sky_at(almanac::instant_from_utc("2018-07-27T20:21:45Z"));
  const uses::LightRequest light{.air = {.atmosphere = "clear"}};
  const auto profile = uses::shadow_profile(
      light, uses::shadow_at_the_moon(light, sky),
      {.wavelengths_nm = {450, 550, 650}, .axis_distances_m = {0, 2e6, 4e6, 5e6}});
  std::printf("axis distance [km], ratio at 450, 550 and 650 nm\n");
  for (std::size_t d = 0; d < profile.axis_distances_m.size(); ++d)
    std::printf("%g,%.6g,%.6g,%.6g\n", profile.axis_distances_m[d] / 1e3, profile.ratio(d, 0),
                profile.ratio(d, 1), profile.ratio(d, 2));
}
