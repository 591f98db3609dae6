// SPDX-License-Identifier: MIT
// Three hundred stills in any air, which the program fits without being told that air.
#include <cstdio>
#include <nlohmann/json.hpp>

#include "end_to_end/random_photograph.h"
#include "support/chance.h"
#include "support/testing.h"

namespace coppermoon::end_to_end::stills_test {

constexpr std::size_t hundreds = 3, stills_an_instant = 20;
constexpr std::uint64_t first_seed = 2019;

/// Any air: of a month, changed by factors, or of one column, by amounts.
struct AnyAir {
  std::string atmosphere;
  std::array<double, 3> truth;  ///< aerosol, cloud, ozone

  const std::array<uses::Unknown, 3>& unknowns() const {
    return uses::unknowns_of(uses::usual_unknowns({.atmosphere = atmosphere}));
  }
  Words words() const {
    Words all{"--atmosphere", atmosphere};
    for (std::size_t a = 0; a < truth.size(); ++a)
      all += Words{fmt::format("--{}", unknowns()[a].parameter), fmt::format("{}", truth[a])};
    return all;
  }
};

AnyAir random_air(Random& random) {
  constexpr std::array names{"standard", "calibrated", "undated", "clear", "molecular"};
  const std::string name = one_of(random, names);
  if (uses::usual_unknowns({.atmosphere = name}) == uses::Unknowns::factors)
    return {name,
            {log_between(random, 0.2, 10), log_between(random, 0.2, 3), between(random, 0.6, 1.5)}};
  return {name,
          {log_between(random, 1.5e-6, 1e-5), between(random, 0, 0.9), between(random, 200, 450)}};
}

/// Light at which 2 % of the lit pixels are brighter.
double light_of_highlights(const texture::Image& frame) {
  std::vector<float> lit;
  for (std::size_t i = 0; i < frame.values.size(); i += 3)
    if (const auto* pixel = &frame.values[i]; pixel[1] > 0)
      lit.push_back(std::max({pixel[0], pixel[1], pixel[2]}));
  std::ranges::sort(lit);
  return lit[lit.size() * 98 / 100];
}

/// Speed at which a photographer exposes the frame to some share of saturation; longer, where no speed does.
void expose(Taken& taken, const texture::Image& frame, double share) {
  constexpr double slowest = 100, fastest = 12800, longest_s = 30;
  const auto camera = colour::camera_named("refractor");
  const double f_number = camera.optics.focal_length_mm / camera.optics.aperture_mm;
  taken.iso = share * slowest * saturation_cd_m2(camera, {taken.time_s, f_number, slowest}) /
              light_of_highlights(frame);
  if (taken.iso < slowest) taken.time_s *= taken.iso / slowest;
  if (taken.iso > fastest) taken.time_s = std::min(longest_s, taken.time_s * taken.iso / fastest);
  taken.iso = std::clamp(taken.iso, slowest, fastest);
}

class Stills : public PhotographsTest {
 protected:
  /// What the program finds in a random still of an occasion, printed.
  void fit_random(const Occasion& occasion, std::uint64_t seed, std::uint64_t number) {
    Random random(seed, number);
    const auto air = random_air(random);
    auto taken = random_photograph(random);
    const auto frame = frame_of(occasion, air.words());
    expose(taken, frame, between(random, 0.2, 0.7));
    double value_per_cd_m2 = 0;
    const auto photo = photograph_of(frame, taken, random, {seed, number}, value_per_cd_m2);
    const auto outcome = coppermoon({"fit",          photo,
                                     "--instants",   occasion.instant,
                                     "--at",         occasion.at(),
                                     "--atmosphere", air.atmosphere,
                                     "--coding",     "srgb",
                                     "--camera",     "refractor",
                                     "--times",      fmt::format("{}", taken.time_s),
                                     "--isos",       fmt::format("{}", taken.iso),
                                     "--f-number",   "6",
                                     "--albedo-map", "built-in",
                                     "--json"});
    fmt::print("{} {} {}: ", seed, number, air.atmosphere);
    if (outcome.status == 0) {
      count(air, nlohmann::json::parse(outcome.out));
    } else {
      ++refused_;
      fmt::print("refused: {}", outcome.err);
    }
    std::fflush(stdout);
  }

  int refused_ = 0;
  std::array<int, 3> inside_{};  ///< intervals that hold the truth: of aerosol, cloud, ozone

 private:
  void count(const AnyAir& air, const nlohmann::json& found) {
    for (std::size_t a = 0; a < inside_.size(); ++a) {
      const auto& unknown = air.unknowns()[a];
      const auto& estimate = found[std::string(unknown.key)];
      const double low = estimate["low_68"], high = estimate["high_68"];
      inside_[a] += air.truth[a] >= low && air.truth[a] <= high;
      fmt::print("{} {:.3g} to {:.3g} ({:.3g}), ", unknown.title, low, high, air.truth[a]);
    }
    fmt::print("chi squared {:.0f} of {}\n", found["chi_squared"].get<double>(),
               found["numbers"].get<int>());
  }
};

TEST_F(Stills, OfThreeHundredInAnyAirFindsTheirAerosolCloudAndOzone) {
  int stills = 0;
  for (std::uint64_t hundred = 0; hundred < hundreds; ++hundred)
    for (std::uint64_t number = 0; number < stills_an_instant * occasions.size(); ++number) {
      if (!support::is_drawn(number + hundred, 3)) continue;
      ++stills;
      fit_random(occasions[number / stills_an_instant], first_seed + hundred, number);
    }
  RecordProperty("refused", refused_);
  RecordProperty("aerosol_inside", inside_[0]);
  RecordProperty("cloud_inside", inside_[1]);
  RecordProperty("ozone_inside", inside_[2]);
  EXPECT_EQ(refused_, 0);
  // of 300, in 99 of 100 such tests
  const auto fair = support::asked({185, 225}, 300, stills, 0.68);
  for (const int inside : inside_) {
    EXPECT_GE(inside, fair.least);
    EXPECT_LE(inside, fair.most);
  }
}

/// A still that the program itself develops, of the umbra beside a crescent that is mostly burnt out.
struct OwnStill {
  const char *moment, *seconds,
      *camera;  ///< in UTC; the camera is empty if the Moon fills the frame
};

TEST_F(Stills, OfTheProgramItselfBesideABurntCrescentHaveItsAir) {
  constexpr std::array stills{OwnStill{"18:44:28", "0.25", ""},
                              OwnStill{"18:44:28", "2", ""},
                              OwnStill{"19:04:28", "0.016667", ""},
                              OwnStill{"19:04:28", "0.25", ""},
                              OwnStill{"19:04:28", "4", ""},
                              OwnStill{"19:19:28", "1", ""},
                              OwnStill{"21:23:13", "1", ""},
                              OwnStill{"21:43:13", "0.5", ""},
                              OwnStill{"19:25:17", "2", ""},
                              OwnStill{"19:04:28", "1", "400mm"},
                              OwnStill{"19:04:28", "0.016667", "400mm"},
                              OwnStill{"21:33:13", "1", "400mm"}};
  for (std::size_t i = 0; i < stills.size(); ++i) {
    if (!support::is_drawn(i, 3)) continue;
    const auto& [moment, seconds, camera] = stills[i];
    const auto instant = fmt::format("2018-07-27T{}Z", moment);
    Words words{"still",    instant, "--at",   "Nairobi", "--width", "900",
                "--height", "600",   "--time", seconds,   "-o",      here("own.png")};
    if (*camera) words += Words{"--camera", camera};
    ASSERT_EQ(coppermoon(words).status, 0) << moment;
    const auto outcome =
        coppermoon({"fit", here("own.png"), "--instants", instant, "--at", "Nairobi", "--json"});
    ASSERT_EQ(outcome.status, 0) << moment << " " << seconds << ": " << outcome.err;
    const auto found = nlohmann::json::parse(outcome.out);
    for (const char* key : {"stratospheric_factor", "cloud_chance"}) {
      const double median = found[key]["median"], low = found[key]["low_68"],
                   high = found[key]["high_68"];
      // two deviations: of 24 intervals, one does not hold the truth by chance
      EXPECT_LE(2 * low - median, 1) << moment << " " << seconds << " " << camera << ": " << key;
      EXPECT_GE(2 * high - median, 1) << moment << " " << seconds << " " << camera << ": " << key;
    }
  }
}

}  // namespace coppermoon::end_to_end::stills_test
