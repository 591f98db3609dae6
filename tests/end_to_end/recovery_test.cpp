// SPDX-License-Identifier: MIT
// A hundred photographs of eclipses under dust and decks of cloud that the fit is not told.
#include "end_to_end/random_photograph.h"
#include "support/chance.h"
#include "support/testing.h"
#include "uses/fit/compared_night.h"
#include "uses/fit/lit_bins.h"

namespace coppermoon::end_to_end::recovery_test {

constexpr std::size_t photographs_an_instant = 20;
constexpr std::uint64_t seed = 2018;

Words words_of(const ColumnTruth& truth) {
  return {"--dust-extinction", fmt::format("{}", truth.dust_per_m),
          "--cloud-cover",     fmt::format("{}", truth.cloud_cover),
          "--ozone-du",        fmt::format("{}", truth.ozone_du)};
}

/// What photographs of an occasion are held against.
struct Held {
  almanac::SkyState sky;
  uses::MoonRequest moon{};
  uses::ViewRequest view{};

  uses::FitScene scene() const {
    return fit_scene(moon, groundwork_of(moon, std::span(&sky, 1)), view, sky);
  }

  /// The scene in the air that was found.
  uses::FitScene scene_in(const uses::AirFit& fit) const {
    auto found = *this;
    found.moon.light.air = with_unknowns(moon.light.air, fit.unknowns, fit.best);
    return found.scene();
  }

  uses::FittedLight light(const uses::FitScene& of_scene,
                          const std::optional<uses::AirRange>& range = {}) const {
    const auto bins = lit_bins(of_scene, sky);
    return {moon.light,
            uses::Unknowns::amounts,
            std::span(&sky, 1),
            std::span(&bins, 1),
            uses::FittedAirs::fine,
            {},
            range};
  }
};

Held held_at(const Occasion& occasion) {
  Held held{.sky = almanac::sky_at(almanac::instant_from_utc(occasion.instant))};
  held.view.observer = almanac::Observer{algebra::degrees(occasion.latitude),
                                         algebra::degrees(occasion.longitude), algebra::metres(0)};
  held.moon.albedo_map = "built-in";
  return held;
}

uses::AirFit fitted_to(const uses::Binned& night, const uses::FittedLight& light) {
  const uses::ComparedNight compared(std::span(&night, 1), {});
  const uses::DataSet data{light, [&](const auto& of_air) { return compared.goodness(of_air); },
                           compared.count()};
  return uses::fitted_air({&data, 1});
}

/// Air fitted to a photograph, and once more with it registered, and light computed, in the air found.
uses::AirFit fitted_twice(const uses::MoonPart& photo, double value_per_cd_m2, const Held& held,
                          const uses::FitScene& scene, const uses::FittedLight& light) {
  const auto night_of = [&](const uses::FitScene& of_air, const colour::Registration& found,
                            bool in_its_air) -> uses::Binned {
    return {.photograph = 0,
            .scene = std::make_shared<const uses::FitScene>(of_air),
            .light = binned(of_air, photo, found.render_to_photo),
            .errors = {.value_per_cd_m2 = value_per_cd_m2,
                       .place_error_km = place_error_km(of_air, found, in_its_air)}};
  };
  const auto found = registration_of(scene, photo);
  const auto fit = fitted_to(night_of(scene, found, false), light);
  const auto in_air = held.scene_in(fit);
  const auto again = registration_of(in_air, photo, found.render_to_photo.scale);
  return fitted_to(night_of(in_air, again, true), held.light(in_air, range_about(fit)));
}

/// How often something was so, of all.
struct Tally {
  int photographs = 0, found = 0, refused = 0;
  std::array<int, 3> inside{};

  void count(const ColumnTruth& truth, const uses::Posterior& posterior) {
    const std::array<double, 3> true_values{std::log(truth.dust_per_m), truth.cloud_cover,
                                            truth.ozone_du};
    const auto& [dust, cover, ozone] = posterior.estimates;
    found += std::abs(std::exp(dust.median) / truth.dust_per_m - 1) < 0.25 &&
             std::abs(cover.median - truth.cloud_cover) < 0.15;
    for (std::size_t a = 0; a < 3; ++a)
      inside[a] += true_values[a] >= posterior.estimates[a].low &&
                   true_values[a] <= posterior.estimates[a].high;
  }
};

using Recovery = PhotographsTest;

TEST_F(Recovery, OfAHundredPhotographsFindsDustAndCloudAndKnowsHowWell) {
  Tally tally;
  std::uint64_t next = 0;
  for (const auto& occasion : occasions) {
    const auto held = held_at(occasion);
    const auto scene = held.scene();
    const auto light = held.light(scene);
    for (std::size_t i = 0; i < photographs_an_instant; ++i) {
      const auto number = next++;
      if (!support::is_drawn(number, 2)) continue;
      ++tally.photographs;
      Random random(seed, number);
      const auto taken = random_photograph(random);
      double value_per_cd_m2 = 0;
      const auto photo = uses::moon_part(
          texture::read_light(here(photograph_of(frame_of(occasion, words_of(taken.truth)), taken,
                                                 random, {seed + 1, number}, value_per_cd_m2))));
      try {
        tally.count(taken.truth,
                    fitted_twice(photo, value_per_cd_m2, held, scene, light).posterior);
      } catch (const algebra::Error&) {
        ++tally.refused;  // one whose Moon is lost in noise or light: not found
      }
    }
  }
  RecordProperty("found", tally.found);
  RecordProperty("refused", tally.refused);
  RecordProperty("dust_inside", tally.inside[0]);
  RecordProperty("cover_inside", tally.inside[1]);
  RecordProperty("ozone_inside", tally.inside[2]);
  // what was asked for: dust within 25 % and cover within 0.15
  EXPECT_GE(tally.found, support::asked({90, 100}, 100, tally.photographs, 0.9).least)
      << tally.refused << " refused";
  // of 100, in 92 of 100 such tests
  const auto fair = support::asked({60, 76}, 100, tally.photographs, 0.68);
  for (std::size_t a = 0; a < tally.inside.size(); ++a) {
    EXPECT_GE(tally.inside[a], fair.least) << a;
    EXPECT_LE(tally.inside[a], fair.most) << a;
  }
}

}  // namespace coppermoon::end_to_end::recovery_test
