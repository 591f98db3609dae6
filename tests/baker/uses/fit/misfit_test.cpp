// SPDX-License-Identifier: MIT
#include "uses/fit/misfit.h"

#include "support/testing.h"

namespace coppermoon::uses::misfit_test {

/// Four photographs of the umbra in three channels, which an air explains.
FitReport explained() {
  FitReport report;
  report.photographs.resize(4);
  report.nights.emplace_back();
  for (std::size_t p = 0; p < 4; ++p)
    for (std::size_t k = 0; k < 3; ++k)
      report.nights[0].misfits.push_back({p, k, 10, 10, 0, 0.01, 3000, 0});
  report.fit.measurements = 120;
  report.fit.posterior.least_chi_squared = 100;
  return report;
}

/// Those of which some misfit.
template <class Misfits>
Suspicion with(const Misfits& change) {
  auto report = explained();
  report.fit.posterior.least_chi_squared = 5000;
  for (auto& misfit : report.nights[0].misfits) change(misfit);
  return suspicion_of(report).value();
}

TEST(Misfit, IsNoneWhereChiSquaredIsAsExpected) {
  EXPECT_FALSE(suspicion_of(explained()));
  FitReport of_magnitudes;
  of_magnitudes.fit.posterior.least_chi_squared = 5000;
  EXPECT_FALSE(suspicion_of(of_magnitudes));
}

TEST(Misfit, OfOnePhotographIsItsExposureOrItsInstant) {
  const auto brighter = with([](Misfit& one) {
    if (one.photograph == 2)
      one.chi_squared = 500, one.mean = 0.69 + 0.01 * static_cast<double>(one.channel);
  });
  EXPECT_EQ(brighter.suspect, Suspect::exposure);
  EXPECT_EQ(brighter.worst.photograph, 2);
  const auto elsewhere = with([](Misfit& one) {
    if (one.photograph == 1) one.chi_squared = 500, one.mean = one.channel == 0 ? 0.7 : -0.5;
  });
  EXPECT_EQ(elsewhere.suspect, Suspect::instant);
  EXPECT_EQ(elsewhere.worst.photograph, 1);
}

TEST(Misfit, OfOneChannelIsTheCamerasColours) {
  const auto found = with([](Misfit& one) {
    if (one.channel == 2) one.chi_squared = 300 + static_cast<double>(one.photograph);
  });
  EXPECT_EQ(found.suspect, Suspect::colours);
  EXPECT_EQ(found.worst.channel, 2);
  EXPECT_EQ(found.worst.photograph, 3);
  const auto of_one_photograph = with([](Misfit& one) {
    if (one.channel == 2 && one.photograph == 1) one.chi_squared = 500, one.mean = 0.5;
  });
  EXPECT_EQ(of_one_photograph.suspect, Suspect::colours) << "an instant changes all channels";
}

TEST(Misfit, OfAllIsTheClockTheAirOrTheToneCurveByItsPlace) {
  const auto at = [](double km) {
    return with([=](Misfit& one) { one.chi_squared = 300, one.worst_km = km, one.scatter = 0.2; })
        .suspect;
  };
  EXPECT_EQ(at(4500), Suspect::clock);
  EXPECT_EQ(at(2000), Suspect::air);
  EXPECT_EQ(at(5500), Suspect::tone_curve);
  EXPECT_EQ(with([](Misfit& one) {
              one.chi_squared = 300;
              one.mean = 0.3 * static_cast<double>(one.photograph);
            }).suspect,
            Suspect::clock)
      << "what changes with time";
}

TEST(Misfit, IsInAPartOfTheShadow) {
  EXPECT_STREQ(part_of_shadow(3000), "umbra");
  EXPECT_STREQ(part_of_shadow(4500), "edge of the umbra");
  EXPECT_STREQ(part_of_shadow(5500), "penumbra");
}

TEST(Misfit, NamesMirroredPhotographsAmongOthers) {
  auto report = explained();
  report.fit.posterior.least_chi_squared = 5000;
  report.photographs[1].registration.render_to_photo.mirrored = true;
  EXPECT_EQ(suspicion_of(report).value().mirrored, std::vector<std::size_t>{1});
  for (auto& photograph : report.photographs)
    photograph.registration.render_to_photo.mirrored = true;
  EXPECT_TRUE(suspicion_of(report).value().mirrored.empty());
}

}  // namespace coppermoon::uses::misfit_test
