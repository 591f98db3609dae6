// SPDX-License-Identifier: MIT
#include "eclipse/sky_columns.h"

#include "support/testing.h"

namespace coppermoon::eclipse {
namespace {

double of_column(const char* name, const almanac::ObserverView& view) {
  return std::ranges::find(view_columns(), std::string(name),
                           &algebra::Column<almanac::ObserverView>::name)
      ->value(view);
}

TEST(SkyColumns, AltitudeIsThatWhichIsSeen) {
  almanac::ObserverView view{};
  for (const double degrees : {0., 10., 45.}) {
    view.altitude = algebra::degrees(degrees);
    EXPECT_EQ(of_column("geometric_altitude_deg", view), degrees);
  }
  view.altitude = algebra::degrees(0);
  EXPECT_WITHIN(60 * of_column("altitude_deg", view), 28.98, 0.1,
                "arcminutes: Saemundsson (1986), printed to a tenth");
  view.altitude = algebra::degrees(10);
  EXPECT_WITHIN(60 * (of_column("altitude_deg", view) - 10), 5.4, 0.1,
                "arcminutes: Saemundsson (1986), printed to a tenth");
}

}  // namespace
}  // namespace coppermoon::eclipse
