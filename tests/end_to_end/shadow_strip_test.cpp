// SPDX-License-Identifier: MIT
// The shadow as a look-up, read as a shader reads it.
#include <nlohmann/json.hpp>

#include "end_to_end/shadow_strip.h"
#include "support/luther_camera.h"
#include "support/testing.h"

namespace coppermoon::end_to_end {
namespace {

using nlohmann::json;
using std::numbers::pi;

/// The largest of |strip × unshadowed − baked| over the baked texel's brightest channel.
struct Misses {
  double dim = 0, bright = 0;  ///< with less and more than 1 % of sunlight
};

class ShadowStrip : public ShaderTest {
 protected:
  Strip strip(Words flags, const char* name = "strip.exr") const {
    flags = Words{"shadow"} + flags;
    flags.insert(flags.end(), {"--lookup", name});
    expect_done(coppermoon(flags));
    return {texture::read_image(here(name)),
            json::parse(text_of(here(name).replace_extension(".json")))};
  }

  texture::Image baked(Words flags, const char* name) const {
    flags = Words{"bake"} + flags;
    flags.insert(flags.end(), {"--type", "float", "--texture-width", "512", "--albedo-map",
                               "built-in", "--quality", "reference", "-o", name});
    expect_done(coppermoon(flags));
    return texture::read_image(here(name));
  }

  Misses misses(const Words& flags) const {
    auto sunlit = flags;
    sunlit.push_back("--unshadowed");
    const auto light = strip(flags);
    const auto shadowed = baked(flags, "shadowed.exr"), full = baked(sunlit, "full.exr");
    Misses worst;
    for (std::size_t r = 0; r < full.height; ++r)
      for (std::size_t c = 0; c < full.width; ++c) {
        const double most = brightest(shadowed, r, c);
        if (most <= 0) continue;
        const auto ratio = light.at(place_of(r, c, full.height));
        auto& miss = most < 1e-2 * brightest(full, r, c) ? worst.dim : worst.bright;
        for (std::size_t k = 0; k < 3; ++k)
          miss = std::max(miss, std::abs(ratio[k] * full(r, c, k) - shadowed(r, c, k)) / most);
      }
    return worst;
  }
};

using ShadowStripThoroughly = ShadowStrip;

TEST_F(ShadowStripThoroughly, TimesTheSunlitMoonIsTheBakedMoon) {
  for (const auto* instant : {"2008-02-21T03:26:05Z", "2008-02-21T02:30:00Z"}) {
    const auto worst = misses({instant, "--scattered-light", "off"});
    EXPECT_WITHIN(worst.dim, 0., 0.025,
                  "light at another depth than the strip's one plane: up to 3 % near the axis; "
                  "measured 1.5 %");
    EXPECT_WITHIN(worst.bright, 0., 0.005, "the same, where light is nearly white");
  }
}

TEST_F(ShadowStrip, StraightLinesBetweenColumnsAreCloseEnough) {
  const auto light = strip({"2008-02-21T03:26:05Z"}).light;
  double worst = 0;
  for (std::size_t r = 0; r < light.height; ++r)
    for (std::size_t c = 1; c + 1 < light.width; ++c)
      for (std::size_t k = 0; k < 3 && brightest(light, r, c) > 1e-4; ++k) {
        const double line = (double{light(r, c - 1, k)} + light(r, c + 1, k)) / 2;
        worst = std::max(worst, std::abs(light(r, c, k) - line) / 4 / brightest(light, r, c));
      }
  EXPECT_WITHIN(worst, 0., 0.005,
                "as stated; over one column a line errs by a quarter of what it does over two");
}

TEST_F(ShadowStrip, LightAtAnotherDepthStandsOnLinesFromTheLimb) {
  const auto at_depth = [&](const char* km, const char* name) {
    return strip({"--sun-distance-km", "147922178", "--moon-distance-km", km, "--earth", "sphere",
                  "--atmosphere", "undated"},
                 name);
  };
  const auto here = at_depth("383736.2", "here.exr");
  for (const auto& there : {at_depth("382867.5", "near.exr"), at_depth("384604.9", "far.exr")}) {
    const double depth = there.fact("depth_lunar_radii"), step = there.fact("step_lunar_radii");
    double near_axis = 0, beyond = 0;
    for (std::size_t c = 0; c < 1024; ++c) {
      const double d = static_cast<double>(c) * step;
      const auto found = here.at(d, 0, depth);
      auto& worst = d < here.fact("one_limb_lunar_radii") ? near_axis : beyond;
      for (std::size_t k = 0; k < 3; ++k)
        worst = std::max(worst,
                         std::abs(found[k] - there.light(0, c, k)) / brightest(there.light, 0, c));
    }
    EXPECT_WITHIN(near_axis, 0., 0.03, "half a lunar radius away; light of both limbs is there");
    EXPECT_WITHIN(beyond, 0., 0.015, "the same, and straight lines where direct light begins");
  }
}

TEST_F(ShadowStrip, IsSeenThroughACamerasFilters) {
  file("luther.csv", luther_camera());
  const auto with = [&](const char* response, const char* name) {
    return strip({"2018-07-27T20:21:45Z", "--bands", "20", "--atmosphere", "undated", "--response",
                  response},
                 name);
  };
  const auto cie = with("colorimetric", "cie.exr"), luther = with("luther.csv", "luther.exr"),
             canon = with("canon-eos-600d", "canon.exr");
  for (std::size_t i = 0; i < cie.light.values.size(); ++i)
    EXPECT_WITHIN(luther.light.values[i], cie.light.values[i], 1e-5 * cie.light.values[i] + 1e-10,
                  "rounding of matrices and floats");
  EXPECT_SAYS(canon.facts["recipe"].get<std::string>(), "response = 'canon-eos-600d'");
  const auto red_over_blue = [](const Strip& strip, double km) {
    const auto c = static_cast<std::size_t>(km / strip.fact("step_km"));
    double red = 0, blue = 0;
    for (std::size_t r = 0; r < strip.light.height; ++r)
      red += strip.light(r, c, 0), blue += strip.light(r, c, 2);
    return red / blue;
  };
  EXPECT_LT(red_over_blue(canon, 4500), 1) << "the blue rim: light over that of the full Moon";
  EXPECT_GT(red_over_blue(canon, 4500), red_over_blue(cie, 4500));
  EXPECT_WITHIN(red_over_blue(canon, 6000), 1, 0.05, "penumbra: sunlight of the Sun's limb");
}

/// The lines of docs/textures.md in a browser's OpenGL.
TEST_F(ShadowStrip, ThePagesShaderFindsTheLight) {
  const auto page = text_of(COPPERMOON_TEST_DATA "/../docs/textures.md");
  const std::string before = "```glsl\n";
  const auto from = page.find(before) + before.size();
  const auto lines = page.substr(from, page.find("```", from) - from);
  const auto light = strip({"2018-07-27T18:50:00Z", "--bands", "20", "--atmosphere", "undated"});
  const json uniforms{{"axis_point", light.facts["axis_point_lunar_radii"]},
                      {"axis_direction", light.facts["axis_direction"]},
                      {"axis_east", light.facts["axis_east"]},
                      {"axis_north", light.facts["axis_north"]},
                      {"axis_point_depth", light.facts["axis_point_depth_lunar_radii"]},
                      {"limb", light.facts["limb_lunar_radii"]},
                      {"depth", light.facts["depth_lunar_radii"]},
                      {"one_limb", light.facts["one_limb_lunar_radii"]},
                      {"step", light.facts["step_lunar_radii"]},
                      {"columns", light.facts["columns"]},
                      {"rows", light.facts["rows"]}};
  std::string source =
      "#version 300 es\nprecision highp float;\nin vec3 positionObject;\nout vec4 colour;\n"
      "uniform sampler2D strip;\n";
  for (const auto& [name, value] : uniforms.items())
    source += fmt::format("uniform {} {};\n", value.is_array() ? "vec3" : "float", name);
  source += lines + "void main() { colour = vec4(shadow(positionObject), 1); }\n";
  expect_shaded(shaded(source, uniforms, "strip", light, false, places_on_moon()), light);
}

TEST_F(ShadowStrip, EndsInFullSunlight) {
  const auto strip_ = strip({"2008-02-21T03:26:05Z", "--atmosphere", "undated"});
  EXPECT_EQ(strip_.light.height, 96U);
  for (std::size_t r = 0; r < strip_.light.height; ++r)
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(strip_.light(r, 1023, k), 1.F);
}

TEST_F(ShadowStrip, WithoutAirIsTheEclipsedSun) {
  const auto dark = strip({"2008-02-21T03:26:05Z", "--atmosphere", "none", "--earth", "sphere",
                           "--limb-darkening", "off"});
  ASSERT_EQ(dark.light.height, 1U);
  const double depth = dark.fact("depth_km"), sun = dark.fact("sun_distance_km");
  constexpr double solar_radius_km = 695700, earth_radius_km = 6378.137;
  const double umbra = earth_radius_km - (solar_radius_km - earth_radius_km) * depth / sun,
               penumbra = earth_radius_km + (solar_radius_km + earth_radius_km) * depth / sun;
  EXPECT_WITHIN(dark.fact("end_km"), penumbra, 30.,
                "cones drawn to the limb of a sphere, not its equator");
  double dark_to = 0;
  for (std::size_t c = 0; c < 1024 && dark.light(0, c, 1) <= 0; ++c)
    dark_to = static_cast<double>(c) * dark.fact("step_km");
  EXPECT_WITHIN(dark_to, umbra, 30., "the same, and a column");
  const double disc = (penumbra - umbra) / 2, middle = (umbra + penumbra) / 2;
  const auto half = static_cast<std::size_t>(std::lround(middle / dark.fact("step_km")));
  EXPECT_WITHIN(dark.light(0, half, 1), 0.5 + disc / (3 * pi * earth_radius_km), 0.003,
                "half the disc and what a limb as curved as the Earth's leaves free of it: the "
                "integral of x²/2R across; half a column");
}

TEST_F(ShadowStrip, ACubeIsTheSameRow) {
  const auto row =
      strip({"2008-02-21T03:26:05Z", "--earth", "sphere", "--atmosphere", "undated"}).light;
  expect_done(coppermoon({"shadow", "2008-02-21T03:26:05Z", "--earth", "sphere", "--atmosphere",
                          "undated", "--lookup", "strip.cube"}));
  const double end = json::parse(text_of(here("strip.json")))["end_lunar_radii"];
  for (const double part : {0.25, 0.5, 0.6, 0.75}) {
    const auto in = std::to_string(part * end);
    const auto said = run({"ociochecklut", here("strip.cube"), in, in, in});
    EXPECT_EQ(said.status, 0) << said.err;
    std::istringstream numbers(said.out);
    double red = -1;
    numbers >> red;
    const double column = part * 1023;
    const auto c = static_cast<std::size_t>(column);
    EXPECT_WITHIN(
        red,
        std::lerp(row(0, c, 0), row(0, c + 1, 0), static_cast<float>(column - std::floor(column))),
        1e-5, "it prints six digits")
        << said.out;
  }
}

TEST_F(ShadowStrip, ItsHeaderMakesItAgain) {
  strip({"2008-02-21T03:26:05Z", "--bands", "20", "--atmosphere", "undated"}, "a.exr");
  strip({"a.exr"}, "b.exr");
  EXPECT_EQ(text_of(here("a.exr")), text_of(here("b.exr")));
}

TEST_F(ShadowStrip, SaysWhatItCannotWrite) {
  const auto refused = [&](Words words, const char* why) {
    words.insert(words.begin(), {"shadow", "2008-02-21T03:26:05Z"});
    const auto outcome = coppermoon(words);
    EXPECT_NE(outcome.status, 0);
    EXPECT_SAYS(outcome.err, why);
  };
  refused({"--lookup", "a.png"}, "a.png: a look-up ends in .exr or .cube");
  refused({"--lookup", "a.exr", "--response", "canon-6d"},
          "response = canon-6d, allowed colorimetric, canon-eos-5d-mark-ii");
  refused({"--response", "canon-eos-600d"}, "response: allowed with --lookup");
  refused({"--lookup", "a.cube"}, "allowed with a spherical Earth");
  refused({"--lookup", "no/a.exr"}, "no: no such directory");
  EXPECT_TRUE(listing().empty());
}

}  // namespace
}  // namespace coppermoon::end_to_end
