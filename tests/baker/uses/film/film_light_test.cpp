// SPDX-License-Identifier: MIT
#include "uses/film/film_light.h"
#include "almanac/instant.h"
#include "almanac/sky.h"
#include "eclipse/shadow_axis.h"
#include "support/testing.h"
#include "uses/light/spectral_bands.h"

namespace coppermoon::uses::film_light_test {

namespace fs = std::filesystem;
using almanac::instant_from_utc;

class WholeFilm : public testing::Test {
 protected:
  WholeFilm() {
    auto name = (fs::temp_directory_path() / "coppermoon-XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
  }
  ~WholeFilm() override { fs::remove_all(folder_); }

  Film film(const LightRequest& request, const char* from = "2018-07-27T17:10:00Z",
            const char* to = "2018-07-27T23:32:00Z") const {
    Film film;
    film.moon.light = request;
    film.moon.albedo_map = "built-in";
    film.folder = folder_;
    film.moments.frames = {instant_from_utc(from), instant_from_utc(to)};
    return film;
  }

  FilmLight light(const LightRequest& request, const std::string& key = "",
                  bool replace = false) const {
    auto lit = film(request);
    lit.record.recipe = of_photons(key);
    return film_light(lit, replace);
  }
  /// Recipe of settings that photons depend on.
  static request::Recipe of_photons(const std::string& text) {
    auto recipe = request::recipe_in(text);
    for (auto& setting : recipe) setting.affects = request::Affects::photons;
    return recipe;
  }

  fs::path folder_;
};

LightRequest fine(const char* atmosphere) {
  LightRequest request;
  request.air.atmosphere = atmosphere;
  request.wish.tolerance = 0.002;
  return request;
}

/// The largest difference of luminance on the disc, over itself.
double worst_difference(const Moonlight& film, const Moonlight& alone,
                        const almanac::SkyState& sky) {
  const auto within = range_at(film, sky);
  const auto weights = luminance_weights();
  const auto known = at_wavelengths(weights, film.plan.work.bands);
  const auto of_film = within ? film.in_sums(known, *within) : shadow::Lookup(weights),
             of_one = alone.in_channels(weights);
  const auto axis = eclipse::shadow_axis(sky);
  double worst = 0;
  for (double across = -0.98; across <= 0.98; across += 0.07)
    for (double along = -0.98; along <= 0.98; along += 0.07) {
      const double out = across * across + along * along;
      if (out >= 0.97) continue;
      constexpr double radius_m = 1737.4e3;
      const glm::dvec3 on_disc{across, along, -std::sqrt(1 - out)};  // towards Sun and Earth
      const auto place = eclipse::place_in_shadow(
          axis, sky.moon_m + radius_m * (glm::transpose(axis.shadow_from_gcrs) * on_disc));
      std::array<double, 1> a{}, b{};
      of_film.read(place, a);
      of_one.read(place, b);
      worst = std::max(worst, std::abs(a[0] / b[0] - 1));
    }
  return worst;
}

using WholeFilmThoroughly = WholeFilm;

TEST_F(WholeFilmThoroughly, HasTheLightOfEachOfItsMoments) {
  for (const char* air : {"standard", "molecular"}) {
    fs::remove(folder_ / "eclipse.light");
    const auto request = fine(air);
    const auto film = light(request).light;
    for (const char* utc : {"2018-07-27T17:30:00Z", "2018-07-27T18:40:00Z", "2018-07-27T19:29:00Z",
                            "2018-07-27T20:21:45Z", "2018-07-27T21:40:00Z"}) {
      const auto sky = almanac::sky_at(instant_from_utc(utc));
      const auto alone = light_on_the_moon(request, sky);
      EXPECT_WITHIN(worst_difference(film, alone, sky), 0, 0.004,
                    "both are planned to be within 0.2 %")
          << air << ", " << utc;
    }
  }
}

TEST_F(WholeFilm, IsSunlitBeforeAndAfterThePenumbra) {
  const auto film = light(fine("standard")).light;
  EXPECT_FALSE(range_at(film, almanac::sky_at(instant_from_utc("2018-07-27T17:00:00Z"))));
  EXPECT_TRUE(range_at(film, almanac::sky_at(instant_from_utc("2018-07-27T17:16:00Z"))));
}

TEST_F(WholeFilmThoroughly, IsComputedOnce) {
  const auto request = fine("standard");
  EXPECT_FALSE(light(request).kept);
  EXPECT_TRUE(light(request).kept);
  EXPECT_THROW(light(request, "ozone-du = 0\n"), algebra::Error) << "of other air";
  EXPECT_FALSE(light(request, "ozone-du = 0\n", true).kept);
  fs::resize_file(folder_ / "eclipse.light", 1000);
  EXPECT_FALSE(light(request, "ozone-du = 0\n").kept) << "a file that does not verify";
}

TEST_F(WholeFilm, OutsideAnyEclipseIsRefused) {
  EXPECT_THROW(film_light(film(fine("standard"), "2018-07-28T17:10:00Z", "2018-07-28T18:10:00Z")),
               algebra::Error);
}

TEST_F(WholeFilm, OfOtherSettingsIsRefusedInTheRecordsWords) {
  LightRequest coarse;
  coarse.wish.tolerance = 0.05;
  EXPECT_FALSE(light(coarse, "ozone = 300\n").kept);
  auto other = film(coarse);
  other.record.recipe = of_photons("ozone = 200\n");
  other.record.way_out = ", or leave it";
  EXPECT_EQ(refusal_of([&] { film_light(other); }),
            folder_.string() +
                ": holds the light of a film made with ozone = 300, "
                "asked 200 (eclipse.light), allowed another folder, or leave it");
}

TEST_F(WholeFilm, OfNoNumberOfPhotonsIsTracedInNoShards) {
  EXPECT_THROW(trace_shard(film(fine("standard")), {1, 2}), algebra::Error);
}

}  // namespace coppermoon::uses::film_light_test
