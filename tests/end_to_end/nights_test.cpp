// SPDX-License-Identifier: MIT
// Nights of eclipses: 25 of nine JPEGs, the camera's filters and the even weather told, its tone curve and clock unknown; 25
// as strangers take them, told nothing of the camera. tests/thorough.sh draws every second one.
#include <cstdio>
#include <nlohmann/json.hpp>

#include "end_to_end/made_night.h"
#include "support/chance.h"
#include "support/program.h"

namespace coppermoon::end_to_end::nights_test {

/// Each of five eclipses with each of five cameras.
constexpr int nights = 25;

/// How often something was so, of all.
struct Tally {
  int nights = 0, found = 0, clocks = 0, refused = 0;
  std::array<int, 4> inside{};

  void count(const NightTruth& truth, const uses::FitReport& answer) {
    const auto& estimates = answer.fit.posterior.estimates;
    const auto& clock = *answer.nights.front().clock;
    found += std::abs(std::exp(estimates[0].median) / truth.dust_per_m - 1) < 0.25 &&
             std::abs(estimates[1].median - truth.cloud_cover) < 0.15;
    clocks += std::abs(clock.seconds - truth.clock_s) < 30;
    const std::array values{std::log(truth.dust_per_m), truth.cloud_cover, truth.ozone_du};
    for (std::size_t a = 0; a < values.size(); ++a)
      inside[a] += values[a] >= estimates[a].low && values[a] <= estimates[a].high;
    inside[3] += std::abs(clock.seconds - truth.clock_s) < clock.error_s;
  }
};

/// Clocks within half a minute in 95 of 100 nights; air near the truth in as many as are asked; the truth in 68 of 100
/// intervals.
void expect_as_promised(const auto& tally, support::Counts near) {
  // of 25 nights the first are in 97 of 100 such tests, the second in 98
  const auto nearly_all = support::asked({22, 25}, nights, tally.nights, 0.95),
             fair = support::asked({12, 22}, nights, tally.nights, 0.68);
  EXPECT_GE(tally.found, near.least) << tally.refused << " refused";
  EXPECT_GE(tally.clocks, nearly_all.least);
  for (const int inside : tally.inside) {
    EXPECT_GE(inside, fair.least);
    EXPECT_LE(inside, fair.most);
  }
}

/// A line of what was found, and of what was true.
void tell(std::size_t night, const NightTruth& truth, const uses::FitReport& answer) {
  const auto& [dust, cover, ozone] = answer.fit.posterior.estimates;
  const auto& clock = *answer.nights.front().clock;
  fmt::print(
      "{}: dust {:.2e} to {:.2e} ({:.2e}), cover {:.2f} to {:.2f} ({:.2f}), ozone {:.0f} to {:.0f} "
      "({:.0f}), clock {:.1f} ± {:.1f} s ({:.1f}), chi squared {:.0f} of {}, {}\n",
      night, std::exp(dust.low), std::exp(dust.high), truth.dust_per_m, cover.low, cover.high,
      truth.cloud_cover, ozone.low, ozone.high, truth.ozone_du, clock.seconds, clock.error_s,
      truth.clock_s, answer.fit.posterior.least_chi_squared, answer.fit.measurements, truth.camera);
  std::fflush(stdout);
}

class Nights : public ProgramTest {};

TEST_F(Nights, AreFoundWithTheirCurvesAndClocks) {
  Tally tally;
  const auto occasions = night_occasions();
  for (std::size_t night = 0; night < std::size_t{nights}; ++night) {
    if (!support::is_drawn(night, 2)) continue;
    ++tally.nights;
    const auto truth = night_truth(night);
    try {
      auto request = MadeNight(occasions[night % occasions.size()], truth).request(here());
      // these cameras see as the CIE observer does, and their nights have no weather along the limb; strangers' nights
      // have both, and are not told
      request.moon.response = "colorimetric";
      request.weather_error = 0;
      const auto answer = uses::fitted_air(request);
      tally.count(truth, answer);
      tell(night, truth, answer);
    } catch (const algebra::Error&) {
      ++tally.refused;  // not found
    }
  }
  RecordProperty("found", tally.found);
  RecordProperty("clocks", tally.clocks);
  expect_as_promised(tally, support::asked({22, 25}, nights, tally.nights, 0.95));
}

/// How strangers' nights were explained.
struct StrangersTally {
  int nights = 0, refused = 0, clocks = 0, found = 0, left_out_wrongly = 0;
  std::array<int, 3> inside{};
};

/// Whether a photograph of a night may be left out for that reason.
bool is_true(const std::string& reason) {
  // on none is the moment outside the eclipse; none is zoomed, but the limbs of long exposures are clipped
  return reason.find("neither clipped nor lost in noise") != std::string::npos ||
         reason.find("glow of a clipped limb") != std::string::npos ||
         reason.find("a misplaced Moon") != std::string::npos ||
         reason.find("no Moon found") != std::string::npos;
}

/// Adds a night's answer, and prints a line.
void count(const StrangersNight& night, const MadeNight& made, const nlohmann::json& found,
           StrangersTally& tally) {
  const std::array<std::pair<const char*, double>, 3> truths{
      {{"stratospheric_factor", made.mean_of(&uses::ColumnChange::stratospheric_factor)},
       {"cloud_chance", made.mean_of(&uses::ColumnChange::cloud_chance)},
       {"ozone_factor", night.truth.month->ozone_factor}}};
  bool near = true;
  for (std::size_t a = 0; a < truths.size(); ++a) {
    const auto& [name, truth] = truths[a];
    const double low = found[name]["low_68"], high = found[name]["high_68"];
    tally.inside[a] += truth >= low && truth <= high;
    near = near && (a == 2 || std::abs(found[name]["median"].get<double>() / truth - 1) < 0.3);
    fmt::print("{} {:.2f} to {:.2f} ({:.2f}), ", name, low, high, truth);
  }
  tally.found += near;
  const auto& first = found["photographs"][0];
  const double read_s = almanac::seconds_between(
                   almanac::instant_from_utc(night.occasion.greatest),
                   almanac::instant_from_utc(first["instant"].get<std::string>())),
               true_s =
                   60 * std::min(night.occasion.short_min.front(), night.occasion.long_min.front()),
               off_s = read_s + found["nights"][0]["clock"]["add_s"].get<double>() - true_s;
  tally.clocks += std::abs(off_s) < 30;
  fmt::print("clock {:+.0f} s off, chi squared {:.0f} of {}", off_s,
             found["chi_squared"].get<double>(), found["numbers"].get<int>());
  for (const auto& photograph : found["photographs"]) {
    const auto reason = photograph.value("left_out", "");
    if (reason.empty()) continue;
    tally.left_out_wrongly += !is_true(reason);
    fmt::print(", left out: {}", reason);
  }
  fmt::print("\n");
  std::fflush(stdout);
}

/// The program's answer to the photographs of a night.
Outcome answer_of(const ProgramFolder& folder, const StrangersNight& night, MadeNight& made) {
  Words words{"fit"};
  const auto request = made.request(folder.here());
  for (const auto& photograph : request.photographs) words.push_back(photograph.file);
  return folder.coppermoon(words + night.told() +
                           Words{"--albedo-map", request.moon.albedo_map, "--json"});
}

TEST_F(Nights, OfStrangersAreFoundWithTheirAirAndClocks) {
  StrangersTally tally;
  for (std::size_t i = 0; i < std::size_t{nights}; ++i) {
    if (!support::is_drawn(i, 2)) continue;
    ++tally.nights;
    const auto night = strangers_night(i);
    MadeNight made(night.occasion, night.truth);
    const auto answer = answer_of(*this, night, made);
    fmt::print("{}: {} as {}, ", i, night.truth.camera, night.truth.stranger->name);
    if (answer.status == 0) {
      count(night, made, nlohmann::json::parse(answer.out), tally);
    } else {
      ++tally.refused;
      fmt::print("refused: {}", answer.err);
    }
  }
  RecordProperty("refused", tally.refused);
  RecordProperty("clocks", tally.clocks);
  RecordProperty("found", tally.found);
  EXPECT_EQ(tally.refused, 0);
  EXPECT_EQ(tally.left_out_wrongly, 0);
  // Weather of 66 % of cloud's chance in each part of the limb, of which six light the photographs, leaves 27 % in its
  // mean: 73 of 100 nights are within 30 % of it, and few of these are lost to aerosol, which varies by 30 %.
  // Fewer than 13 of 25 are so in one test of 60.
  expect_as_promised(tally, support::asked({13, 25}, nights, tally.nights, 0.7));
}

}  // namespace coppermoon::end_to_end::nights_test
