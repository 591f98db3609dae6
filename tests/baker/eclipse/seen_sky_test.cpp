// SPDX-License-Identifier: MIT
#include "eclipse/seen_sky.h"

#include "result/as_json.h"
#include "support/within.h"

namespace coppermoon::eclipse::seen_sky_test {

double of_key(const char* key, const almanac::ObserverView& view) {
  return result::as_json(SeenSky{{}, view})[key].get<double>();
}

TEST(SeenSky, AltitudeIsThatWhichIsSeen) {
  almanac::ObserverView view{};
  for (const double degrees : {0., 10., 45.}) {
    view.altitude = algebra::degrees(degrees);
    EXPECT_EQ(of_key("geometric_altitude_deg", view), degrees);
  }
  view.altitude = algebra::degrees(0);
  EXPECT_WITHIN(60 * of_key("altitude_deg", view), 28.98, 0.1,
                "arcminutes: Saemundsson (1986), printed to a tenth");
  view.altitude = algebra::degrees(10);
  EXPECT_WITHIN(60 * (of_key("altitude_deg", view) - 10), 5.4, 0.1,
                "arcminutes: Saemundsson (1986), printed to a tenth");
}

}  // namespace coppermoon::eclipse::seen_sky_test
