// SPDX-License-Identifier: MIT
// What examples/paper_figures.sh shows, small: which picture is the brighter, and what saturates.
#include <nlohmann/json.hpp>

#include "end_to_end/luminance.h"
#include "end_to_end/sunlit_ground.h"
#include "support/program.h"
#include "texture/read_image.h"

namespace coppermoon::end_to_end::paper_figures_test {

using texture::Image;

constexpr std::size_t width = 150, height = 100;
constexpr double pixel_km = 38;  // on the Moon, whose disc is 92 of them across

/// As the recipe's telescope sees it.
Scene scene_at(const std::string& utc) {
  const auto sky = almanac::sky_at(almanac::instant_from_utc(utc));
  const almanac::Observer clifton_park{algebra::degrees(42.86), algebra::degrees(-73.77), {}};
  const auto scene = end_to_end::scene_at(
      sky, povray_scenes::camera_at(
               sky, almanac::view_from(clifton_park, sky), povray_scenes::Up::celestial_north,
               {povray_scenes::field_of_view(algebra::metres(1.537), algebra::metres(0.0227)),
                width, height}));
  EXPECT_GT(scene.ground.size(), 6000U) << "of 92 x 92 x π/4, without the limb";
  return scene;
}

double brightest_channel(const Image& image, const Ground& at) {
  return std::max(
      {image(at.row, at.column, 0), image(at.row, at.column, 1), image(at.row, at.column, 2)});
}

double luminance(const Image& image, const Ground& at) {
  return end_to_end::luminance(image, at.row, at.column);
}

/// Share of the disc that is saturated in some channel.
double saturated_share(const Image& picture, const Scene& scene) {
  const auto saturated = std::ranges::count_if(
      scene.ground, [&](const Ground& at) { return brightest_channel(picture, at) >= 1; });
  return static_cast<double>(saturated) / static_cast<double>(scene.ground.size());
}

/// Red over green over blue wherever the ground is nearer to the axis than that.
void expect_copper(const Image& image, const Scene& scene, double within_km) {
  std::size_t seen = 0;
  for (const auto& at : scene.ground) {
    if (at.axis_km > within_km) continue;
    ++seen;
    ASSERT_GT(image(at.row, at.column, 0), image(at.row, at.column, 1)) << at.axis_km;
    ASSERT_GT(image(at.row, at.column, 1), image(at.row, at.column, 2)) << at.axis_km;
  }
  EXPECT_GT(seen, 1000U);
}

// -- the program

const std::string recipe = COPPERMOON_TEST_DATA "/../examples/first_eclipse.toml";

class PaperFigures : public ProgramTest {
 protected:
  /// The script's frame, as NAME.exr.
  Image frame(const std::string& name, const std::string& instant, const Words& more) const {
    const Words small = "--solver quadrature --albedo-map built-in --texture-width 512 --sky off";
    const Words sides{"--width", std::to_string(width), "--height", std::to_string(height)};
    const Words files{"--frame", name + ".exr", "-o", name + ".png"};
    const auto made =
        coppermoon(Words{"still", instant, "--recipe", recipe} + small + sides + files + more);
    EXPECT_EQ(made.status, 0) << made.err;  // which says that the recipe's photons are not used
    return texture::read_image(here(name + ".exr"));
  }

  /// What the sensor holds after so long [s], 1 where it saturates.
  Image exposed(const std::string& name, const std::string& time,
                const std::string& view = "Raw") const {
    expect_done(coppermoon(words_of("develop {} -o exposed.png --time {} --view {} --bits 16",
                                    name + ".exr", time, view)));
    return texture::read_image(here("exposed.png"));
  }
};

const Words no_dust = "--dust-extinction 0";

// -- Figure 1

constexpr const char* before_totality = "2008-02-21T02:50:00Z";

TEST_F(PaperFigures, Figure1WithoutAirTheUmbraIsBlackButForTheStars) {
  const auto scene = scene_at(before_totality);
  const auto found =
      frame("none", before_totality,
            no_dust + "--atmosphere none --earth sphere --limb-darkening off --starlight on");
  const auto picture = exposed("none", "4", "Un-tone-mapped");
  for (const auto& at : scene.ground) {
    const double beyond_km = at.axis_km - scene.bodies.umbra_km();
    if (beyond_km < -2 * pixel_km) {
      ASSERT_LT(brightest_channel(picture, at), 1 / 510.) << "0 of 255";
      ASSERT_GT(luminance(found, at), 0) << "the stars' light";
    } else if (beyond_km > 2 * pixel_km) {
      ASSERT_GT(brightest_channel(picture, at), 0.2) << "a thousandth of sunlight is";
    }
  }
}

TEST_F(PaperFigures, Figure1AirThatOnlyRefractsLightsTheUmbraMoreThanAllOfItAndLessRed) {
  const auto scene = scene_at(before_totality);
  const auto refracted =
      frame("refraction", before_totality, no_dust + "--rayleigh off --ozone-du 0");
  const auto all = frame("all", before_totality, no_dust);
  for (const auto& at : scene.ground) {
    ASSERT_GT(luminance(refracted, at), luminance(all, at)) << at.axis_km;
    ASSERT_GT(luminance(all, at), 0) << at.axis_km;
  }
  expect_copper(all, scene, 4000);
  for (const auto& at : scene.ground)
    if (at.axis_km < 4000) {
      const auto redness = [&](const Image& frame) {
        return frame(at.row, at.column, 0) / frame(at.row, at.column, 1);
      };
      ASSERT_GT(redness(all), 1.2 * redness(refracted)) << "0.2 mag, to be seen";
    }
}

// -- Figure 4

constexpr const char* partial = "2008-02-21T04:12:44Z";
const Words usual_dust = "--dust-extinction 4.7e-6";

/// Sunlight alone decides, where it is more than all that the air can bend there: what must saturate
/// and what cannot, by a pixel to either side and 2 %: half floats, texels of the map.
void expect_saturated_by_sunlight(const Image& sensor, const Image& full_moon, const Scene& scene,
                                  double time_s) {
  const double saturating_cd_m2 = 78 * 12.1 * 12.1 / (0.65 * time_s * 800);
  constexpr double most_bent = 0.004;  // of sunlight: six magnitudes less, by the edge
  for (const auto& at : scene.ground) {
    const double full = brightest_channel(full_moon, at) / saturating_cd_m2;
    const double least = full * scene.bodies.sunlight(at.axis_km - pixel_km, earth_km + air_km);
    const double most = full * (scene.bodies.sunlight(at.axis_km + pixel_km, earth_km) + most_bent);
    if (least > 1.02) {
      ASSERT_EQ(brightest_channel(sensor, at), 1) << at.axis_km;
    } else if (most < 0.98) {
      ASSERT_LT(brightest_channel(sensor, at), 1) << at.axis_km;
    }
  }
}

const std::array<const char*, 5> exposures{"0.008", "0.050", "0.166", "0.500", "1.509"};

using PaperFiguresThoroughly = PaperFigures;

TEST_F(PaperFiguresThoroughly, Figure4SaturatesWhereSunlightIsLeftForThat) {
  const auto scene = scene_at(partial);
  const auto full_moon = frame("full", partial, {"--unshadowed"});
  frame("partial", partial, usual_dust);
  double before = 0;
  for (const char* time : exposures) {
    const auto sensor = exposed("partial", time);
    expect_saturated_by_sunlight(sensor, full_moon, scene, std::stod(time));
    const double share = saturated_share(sensor, scene);
    if (time == exposures.front()) {
      EXPECT_EQ(share, 0) << "at no place on the Moon is as much as a quarter of the Sun in view";
    } else {
      EXPECT_GT(share, before) << time;
    }
    before = share;
  }
}

/// Values of the brightest channel in sunlight and in the umbra, 300 km within its edge.
struct Exposed {
  double lit = 0, umbra_least = 1, umbra_most = 0;
};

Exposed values(const Image& sensor, const Scene& scene) {
  Exposed found;
  for (const auto& at : scene.ground) {
    const double value = brightest_channel(sensor, at);
    if (at.axis_km > scene.bodies.umbra_km()) found.lit = std::max(found.lit, value);
    if (at.axis_km > scene.bodies.umbra_km() - 300) continue;
    found.umbra_least = std::min(found.umbra_least, value);
    found.umbra_most = std::max(found.umbra_most, value);
  }
  return found;
}

TEST_F(PaperFigures, Figure4ShowsTheSunlitLimbFirstAndTheCopperLast) {
  const auto scene = scene_at(partial);
  frame("partial", partial, usual_dust);
  const auto shortest = values(exposed("partial", exposures.front()), scene);
  EXPECT_GT(shortest.lit, 0.18) << "as bright as what is exposed to be grey";
  EXPECT_LT(shortest.umbra_most, 0.005) << "nearly eight stops below white";
  const auto second = values(exposed("partial", exposures[1]), scene);
  EXPECT_EQ(second.lit, 1);
  EXPECT_LT(second.umbra_most, 0.02) << "more than five stops below white";
  const auto sensor = exposed("partial", exposures.back());
  const auto longest = values(sensor, scene);
  EXPECT_GT(longest.umbra_least, 0.01) << "25 of 255 behind sRGB's curve: to be seen";
  EXPECT_LT(longest.umbra_most, 1);
  expect_copper(sensor, scene, 3500);
}

TEST_F(PaperFigures, Figure4HoldsTheLightTimesTheTime) {
  const auto scene = scene_at(partial);
  frame("partial", partial, usual_dust);
  const auto half = exposed("partial", "0.500"), longest = exposed("partial", "1.509");
  std::size_t compared = 0;
  for (const auto& at : scene.ground)
    for (std::size_t k = 0; k < 3; ++k) {
      const double before = half(at.row, at.column, k), after = longest(at.row, at.column, k);
      if (before < 0.01 || after >= 1) continue;
      ++compared;
      ASSERT_NEAR(after / before, 1.509 / 0.5, 0.003) << "of 16 bits, a half in 655 of them";
    }
  EXPECT_GT(compared, 5000U);
}

// -- Figures 5 and 6

struct Totality {
  const char *instant, *time;
};

void PrintTo(const Totality& totality, std::ostream* out) { *out << totality.instant; }

class DustyFigures : public PaperFigures, public testing::WithParamInterface<Totality> {};

/// Grey dust takes exp(-α s) of light that went s through it, and of a sum of such exponentials the
/// logarithm is convex (Hölder): with some dust it is not above the line from none to much,
///
///     I(α) <= I(0) (I(β) / I(0))^(α / β)        0 <= α <= β
TEST_P(DustyFigures, AreTheDarkerTheMoreDustAsSumsOfExponentialsAre) {
  const auto scene = scene_at(GetParam().instant);
  std::vector<Image> frames;
  std::vector<double> saturated;
  for (const char* dust : {"0", "4.7e-6", "1e-5"}) {
    frames.push_back(frame("moon", GetParam().instant, {"--dust-extinction", dust}));
    saturated.push_back(saturated_share(exposed("moon", GetParam().time), scene));
    expect_copper(frames.back(), scene, 3000);
  }
  for (const auto& at : scene.ground) {
    const double none = luminance(frames[0], at), light = luminance(frames[1], at),
                 heavy = luminance(frames[2], at);
    ASSERT_GT(none, light) << at.axis_km;
    ASSERT_GT(light, heavy) << at.axis_km;
    ASSERT_LT(light, 1.01 * none * std::pow(heavy / none, 0.47)) << "each light within 0.3 %";
  }
  EXPECT_GT(saturated[0], 0.05) << "the bright rim";
  EXPECT_LT(saturated[1], 0.01) << "no rim";
  EXPECT_LE(saturated[2], saturated[1]);
}

INSTANTIATE_TEST_SUITE_P(PaperFiguresThoroughly, DustyFigures,
                         testing::Values(Totality{"2008-02-21T03:08:26Z", "4"},
                                         Totality{"2008-02-21T03:50:42Z", "3"}));

// -- Figure 7

const std::array<const char*, 3> forecast{"2010-12-21T07:22:17Z", "2010-12-21T07:40:21Z",
                                          "2010-12-21T08:16:56Z"};

TEST_F(PaperFigures, Figure7HasThePhasesThatItsCaptionNames) {
  const auto eclipse = json_of("almanac --from 2010-12-20 --to 2010-12-22")[0];
  const auto after = [](const nlohmann::json& event, const char* instant) {
    return almanac::seconds_between(almanac::instant_from_utc(event.get<std::string>()),
                                    almanac::instant_from_utc(instant));
  };
  EXPECT_GT(after(eclipse["contacts"]["U1"], forecast[0]), 0);
  EXPECT_WITHIN(after(eclipse["contacts"]["U2"], forecast[1]), 0, 60,
                "the conventions of the shadow's size are half a minute apart");
  EXPECT_WITHIN(after(eclipse["greatest"], forecast[2]), 0, 5,
                "printed to the second; the Moon's theories are seconds apart");
}

/// The part of the disc that is outside the umbra: two circles.
double sunlit_share(const Scene& scene) {
  return 1 - share_covered(moon_km, scene.bodies.umbra_km(), scene.moon_axis_km);
}

TEST_F(PaperFiguresThoroughly, Figure7aSaturatesInTheQuarterThatIsSunlit) {
  const auto scene = scene_at(forecast[0]);
  const double sunlit = sunlit_share(scene);
  EXPECT_WITHIN(sunlit, 0.25, 0.05, "a quarter, said in words");
  const auto full_moon = frame("full", forecast[0], {"--unshadowed"});
  frame("moon", forecast[0], no_dust);
  const auto sensor = exposed("moon", "0.8");
  expect_saturated_by_sunlight(sensor, full_moon, scene, 0.8);
  expect_copper(sensor, scene, 3500);
  EXPECT_LT(saturated_share(sensor, scene), sunlit);
  EXPECT_GT(saturated_share(sensor, scene), 0.75 * sunlit)
      << "a hundredth of the Sun saturates, and that is in view 150 km outside the umbra's edge";
}

TEST_F(PaperFiguresThoroughly, Figures7bAnd7cAreCopperAllOverAndTheSecondTheDarker) {
  EXPECT_LT(sunlit_share(scene_at(forecast[1])), 0.01) << "the last of it";
  EXPECT_EQ(sunlit_share(scene_at(forecast[2])), 0);
  std::vector<double> means;
  for (const auto& [instant, time] : {std::pair{forecast[1], "1.0"}, {forecast[2], "1.5"}}) {
    const auto scene = scene_at(instant);
    frame("moon", instant, no_dust);
    const auto sensor = exposed("moon", time);
    EXPECT_EQ(saturated_share(sensor, scene), 0);
    expect_copper(sensor, scene, 3500);
    means.push_back(json_of("brightness moon.exr")["mean_luminance_cd_m2"]);
  }
  EXPECT_LT(means[1], means[0]);
}

}  // namespace coppermoon::end_to_end::paper_figures_test
