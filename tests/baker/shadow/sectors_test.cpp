// SPDX-License-Identifier: MIT
#include "shadow/sectors.h"

#include "support/testing.h"

namespace coppermoon::shadow::sectors_test {

constexpr double degree = std::numbers::pi / 180;

TEST(Sectors, GoRoundThroughNorth) {
  const Sectors some{24, 22, 4};
  EXPECT_EQ(some[0], 22U);
  EXPECT_EQ(some[1], 23U);
  EXPECT_EQ(some[2], 0U);
  EXPECT_EQ(some[3], 1U);
  EXPECT_FALSE(some.all());
  for (std::size_t part = 0; part < 24; ++part)
    EXPECT_EQ(some.hold(part), part >= 22 || part < 2) << part;
}

TEST(Sectors, AreAllWhereNothingElseIsSaid) {
  const Sectors all{7};
  EXPECT_TRUE(all.all());
  EXPECT_EQ(all, (Sectors{7, 0, 7}));
  for (std::size_t part = 0; part < 7; ++part) EXPECT_TRUE(all.hold(part));
  EXPECT_TRUE(Sectors{}.all());
}

TEST(Sectors, CountOnEitherWayRoundTheCircle) {
  const Sectors all{5};
  EXPECT_EQ(all.wrapped(-1), 4U);
  EXPECT_EQ(all.wrapped(-11), 4U);
  EXPECT_EQ(all.wrapped(5), 0U);
  EXPECT_EQ(all.wrapped(13), 3U);
}

TEST(Sectors, LieAroundTheirMiddles) {
  const Sectors all{24};
  EXPECT_WITHIN(all.angle_rad(3), 45 * degree, 1e-15, "rounding");
  for (const auto& [angle, part] : {std::pair{0., 0U},
                                    {7.4, 0U},
                                    {7.6, 1U},
                                    {-7.4, 0U},
                                    {-7.6, 23U},
                                    {180, 12U},
                                    {352.4, 23U},
                                    {352.6, 0U},
                                    {-180, 12U},
                                    {725, 0U}})
    EXPECT_EQ(all.nearest(angle * degree), part) << angle << " degrees";
}

TEST(Sectors, HaveOneOppositeAndAMirrorImage) {
  const Sectors all{24}, odd{5};
  EXPECT_EQ(all.opposite(2), 14U);
  EXPECT_EQ(all.opposite(14), 2U);
  EXPECT_EQ(odd.opposite(3), 3U) << "none is opposite";
  EXPECT_EQ(all.mirrored(0), 0U);
  EXPECT_EQ(all.mirrored(5), 19U);
  EXPECT_EQ(all.mirrored(12), 12U);
}

TEST(Sectors, WidenUntilTheyAreAll) {
  EXPECT_EQ((Sectors{24, 0, 3}.widened()), (Sectors{24, 23, 5}));
  EXPECT_EQ((Sectors{24, 5, 21}.widened()), (Sectors{24, 4, 23}));
  EXPECT_EQ((Sectors{24, 5, 22}.widened()), Sectors{24});
}

TEST(Sectors, OfAnotherNumberAroundAreAll) {
  const Sectors some{24, 5, 3};
  EXPECT_EQ(some.in(24), some);
  EXPECT_EQ(some.in(1), Sectors{});
}

TEST(BetweenAngles, TakesInBothEnds) {
  EXPECT_EQ(between_angles(24, 31 * degree, 44 * degree), (Sectors{24, 2, 2}));
  EXPECT_EQ(between_angles(24, -20 * degree, 20 * degree), (Sectors{24, 22, 5}));
  EXPECT_EQ(between_angles(24, -200 * degree, 300 * degree).count, 24U);
}

}  // namespace coppermoon::shadow::sectors_test
