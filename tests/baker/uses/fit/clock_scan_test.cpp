// SPDX-License-Identifier: MIT
#include "uses/fit/clock_scan.h"

#include "support/testing.h"
#include "texture/image.h"

namespace coppermoon::uses::clock_scan_test {

/// Photographs of one eclipse without noise, as clocks that are wrong date them.
class ClockScan : public testing::Test {
 protected:
  ClockScan() {
    moon_.albedo_map = "built-in";
    moon_.texture_width = 1024;
    std::vector<almanac::SkyState> way;
    for (double min = -150; min <= 150; min += 5) way.push_back(sky_at_min(min));
    groundwork_.emplace(groundwork_of(moon_, way));
  }

  static almanac::SkyState sky_at_min(double min) {
    return almanac::sky_at(
        almanac::later(almanac::instant_from_utc("2015-09-28T02:47:07Z"), 60 * min));
  }

  /// A photograph so many minutes from the greatest eclipse, dated `late_s` later, and registered. Of its disc a share is
  /// darker than a third of saturation.
  ClockView taken(double min, double darker, double late_s) const {
    const auto scene = fit_scene(moon_, *groundwork_, {}, sky_at_min(min));
    std::vector<float> disc;
    for (const auto& ground : scene.grounds) disc.push_back(scene.usual.values()[ground.pixel]);
    std::ranges::sort(disc);
    const float white =
        3 * disc[static_cast<std::size_t>(darker * static_cast<double>(disc.size()))];
    texture::Image photo(fit_side_px, fit_side_px, {"R", "G", "B"});
    for (std::size_t i = 0; i < photo.values.size(); ++i)
      photo.values[i] = std::min(1.F, scene.usual.values()[i / 3] / white);
    return clock_view(scene, photo, {}, false, almanac::later(scene.sky.when, late_s));
  }

  ScannedClock found(const std::vector<ClockView>& views, double error_s) const {
    return scanned_clock(*groundwork_, views, -10800, 10800,
                         [=](double clock_s) { return std::pow(clock_s / error_s, 2); });
  }

 private:
  MoonRequest moon_;
  std::optional<FitGroundwork> groundwork_;
};

TEST_F(ClockScan, FindsAClockByPartialPhasesHoweverWrongItIs) {
  for (const double late_s : {1700., -5500., 30.}) {
    const std::vector views{taken(-80, 0.9, late_s), taken(-55, 0.2, late_s),
                            taken(0, 0.6, late_s)};
    const auto clock = found(views, 600);
    EXPECT_TRUE(clock.decided);
    EXPECT_WITHIN(clock.seconds, -late_s, 30, "two of the last steps") << late_s;
    EXPECT_LT(clock.from_s, -late_s);
    EXPECT_GT(clock.to_s, -late_s);
    EXPECT_LT(clock.to_s - clock.from_s, 1800) << "three sharp shadows";
  }
}

TEST(ScannedClock, IsKeptWhereLightLeadsAwayFromIt) {
  Clock clock{.added_s = 500, .believed_s = 0, .error_s = 60};
  EXPECT_FALSE(strays(clock)) << "nothing was scanned";
  clock.scanned = ScannedClock{300, true, -300, 900};
  EXPECT_FALSE(strays(clock));
  clock.added_s = 901;
  ASSERT_TRUE(strays(clock));
  const auto again = scanned_again(clock);
  EXPECT_EQ(again.added_s, 300);
  EXPECT_EQ(again.believed_s, 300);
  EXPECT_EQ(again.error_s, 200) << "a sixth of the range";
}

TEST_F(ClockScan, BelievesTheClockInTotality) {
  const std::vector views{taken(-15, 0.6, 300), taken(5, 0.6, 300)};
  const auto clock = found(views, 60);
  EXPECT_FALSE(clock.decided);
  EXPECT_WITHIN(clock.seconds, 0, 180, "three standard errors");
}

}  // namespace coppermoon::uses::clock_scan_test
