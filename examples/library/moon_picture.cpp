// SPDX-License-Identifier: MIT
// A still: the Moon over Athens as a telescope takes it, rendered by POV-Ray and developed.
#include <coppermoon/almanac/instant.h>
#include <coppermoon/uses/picture/still.h>

#include <cstdio>

using namespace coppermoon;

int main() {
  const auto sky = almanac::sky_at(almanac::instant_from_utc("2018-07-27T20:21:45Z"));
  const almanac::Observer athens{algebra::degrees(37.98), algebra::degrees(23.73), {}};
  const auto scene =
      uses::lit_scene({}, {.observer = athens, .field_deg = 0.7, .width = 300, .height = 300}, sky);
  const auto frame = uses::rendered(scene).whole();
  const uses::Development development;
  const auto space = colour::WorkingSpace::linear_rec709;
  const auto exposures = uses::exposures_for(development, frame, space);
  uses::write_picture(development, exposures, {frame, space}, {}, "moon.png");
  std::printf("moon.png, exposed for %.2g s\n", exposures.shorter.time_s);
}
