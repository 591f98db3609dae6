// SPDX-License-Identifier: MIT
#include "uses/explore/motion.h"

#include <glm/matrix.hpp>

#include "almanac/observer.h"
#include "almanac/sky.h"
#include "eclipse/shadow_axis.h"
#include "support/testing.h"

namespace coppermoon::uses::motion_test {

/// Σ c_k T_k(x), by the definition of T_k.
double sum_of(const nlohmann::ordered_json& coefficients, double x) {
  double sum = 0;
  for (std::size_t k = 0; k < coefficients.size(); ++k)
    sum += coefficients[k].get<double>() * std::cos(static_cast<double>(k) * std::acos(x));
  return sum;
}

TEST(Motion, IsTheAlmanacsAtAnyMoment) {
  const auto from = almanac::instant_from_utc("2018-07-27T17:05:00Z"),
             to = almanac::instant_from_utc("2018-07-27T23:40:00Z");
  const auto motion = motion_between(from, to);
  const double seconds = motion["seconds"].get<double>();
  for (const double x : {-1., -0.87, -0.3, 0.05, 0.61, 1.}) {
    const auto sky = almanac::sky_at(almanac::later(from, (x + 1) / 2 * seconds));
    const auto axis = eclipse::shadow_axis(sky);
    const auto centre_m = axis.shadow_from_gcrs * sky.moon_m;
    const auto& series = motion["series"];
    for (int i = 0; i < 3; ++i)
      EXPECT_WITHIN(sum_of(series["centre"][static_cast<std::size_t>(i)], x), centre_m[i] / 1e3,
                    1e-3, "a metre");
    EXPECT_WITHIN(sum_of(series["sunDistance"][0], x), algebra::in_kilometres(axis.sun_distance),
                  1e-2, "the ephemeris is known to no more");
    const auto moon = axis.shadow_from_gcrs * glm::transpose(sky.selenographic_from_gcrs),
               equator = axis.shadow_from_gcrs * glm::transpose(sky.equator_from_gcrs);
    for (int i = 0; i < 9; ++i) {
      const auto k = static_cast<std::size_t>(i);
      EXPECT_WITHIN(sum_of(series["moonFrame"][k], x), moon[i / 3][i % 3], 1e-8, "rounding");
      EXPECT_WITHIN(sum_of(series["equatorFrame"][k], x), equator[i / 3][i % 3], 1e-8, "rounding");
    }
    const auto zenith = sky.equator_from_gcrs * almanac::view_from({}, sky).zenith;
    const double sidereal = motion["siderealTime"][0].get<double>() +
                            motion["siderealTime"][1].get<double>() * (x + 1) / 2;
    EXPECT_WITHIN(std::remainder(sidereal - std::atan2(zenith.y, zenith.x), 2 * std::acos(-1.)), 0,
                  1e-8, "the Earth turns evenly, but for nutation");
  }
}

}  // namespace coppermoon::uses::motion_test
