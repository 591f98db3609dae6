// SPDX-License-Identifier: MIT
// An eclipse as one strip and a formula: the Moon that `bake` makes, at every moment and in every language.
#include <cstdio>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "almanac/calendar.h"
#include "almanac/sky.h"
#include "eclipse/shadow_axis.h"
#include "end_to_end/eclipse_shader.h"
#include "support/testing.h"

namespace coppermoon::end_to_end::shader_test {

using nlohmann::json;
using std::numbers::pi;

/// The largest of |light × sunlit − baked| over the baked texel's brightest channel.
struct Misses {
  double umbra = 0;  ///< with less than 1e-3 of sunlight
  double bright = 0;
};

/// An eclipse whose light takes little time.
const Words quick = "2018-07-27 --atmosphere undated --bands 20";

class Shader : public ShaderTest {
 protected:
  EclipseShader shader(Words flags) const {
    expect_done(coppermoon(Words{"shader"} + flags + "-o eclipse"));
    return read_shader(here("eclipse"));
  }

  /// Given  flags  moment, air and quality
  texture::Image baked(const Words& flags) const {
    expect_done(coppermoon(Words{"bake"} + flags + "--type float --texture-width 256 -o moon.exr"));
    return texture::read_image(here("moon.exr"));
  }

  std::string moment(const EclipseShader& of, double seconds) const {
    const auto greatest = almanac::instant_from_utc(of.facts["greatest"].get<std::string>());
    return almanac::utc_text(almanac::later(greatest, seconds), 3);
  }

  Misses misses(const EclipseShader& of, double seconds, const Words& air, const Words& how) const {
    const auto when = moment(of, seconds);
    const auto shadowed = baked(Words{when} + air + how),
               full = baked(Words{when, "--unshadowed"} + air + how);
    Misses worst;
    for (std::size_t r = 0; r < full.height; ++r)
      for (std::size_t c = 0; c < full.width; ++c) {
        const double most = brightest(shadowed, r, c);
        if (most <= 0) continue;
        const auto light = of.at(place_of(r, c, full.height), seconds);
        const double share = most / brightest(full, r, c);
        auto& miss = share < 1e-3 ? worst.umbra : worst.bright;
        for (std::size_t k = 0; k < 3; ++k)
          miss = std::max(miss, std::abs(light[k] * full(r, c, k) - shadowed(r, c, k)) / most);
      }
    return worst;
  }
};

using ShaderThoroughly = Shader;

TEST_F(Shader, TimesTheSunlitMoonIsTheBakedMoon) {
  const Words air = "--scattered-light off";
  const auto of = shader(Words{"2018-07-27"} + air);
  EXPECT_LT(of.facts["error"], 0.005) << "its ground is the other half";
  EXPECT_LE(std::filesystem::file_size(here("eclipse/eclipse.exr")), 1000000U) << "as asked";
  EXPECT_EQ(listing(),
            (std::set<std::string>{"here/eclipse", "here/eclipse/eclipse.exr",
                                   "here/eclipse/eclipse.glsl", "here/eclipse/eclipse.inc",
                                   "here/eclipse/eclipse.json", "here/eclipse/eclipse.mtlx",
                                   "here/eclipse/eclipse.osl", "here/eclipse/eclipse.pov"}));
  const auto worst = misses(of, -4000, air, "--tolerance 0.3%");
  EXPECT_WITHIN(worst.umbra, 0., 0.01, "as stated; ground of another colour than the mean");
  EXPECT_WITHIN(worst.bright, 0., 0.01, "as stated, also where sunlight begins");
}

TEST_F(ShaderThoroughly, TimesTheSunlitMoonIsTheBakedMoonAtAllTimes) {
  struct Case {
    Words eclipse;
    std::vector<double> seconds;
    std::string tolerance = "0.3%";
  };
  const std::string region = "from-latitude=-90,to-latitude=10,ozone-du=350,cloud-cover=0.7",
                    sector = "from-position-angle=20,to-position-angle=110,dust-extinction=3e-6";
  const std::vector<Case> cases{
      {{"2018-07-27"}, {-9600, -7500, -5400, -3600, -1800, 0, 2400, 4800, 7200, 9000}},
      {{"1992-12-09"}, {-6500, -4000, -1500, 1000, 3500}, "0.6%"},  // 0.59 % is predicted
      {{"1963-12-30"}, {-5000, -2500, -1200, 0, 1500, 4000}, "0.6%"},
      {{"2018-07-27", "--danjon", "0"}, {-4800, -2400, 0, 2400, 4800}},
      {{"2021-11-19", "--region", region, "--region", sector},
       {-8000, -3000, 0, 2500, 6000},
       "0.5%"}};
  for (const auto& [eclipse, moments, tolerance] : cases) {
    const Words air(eclipse.begin() + 1, eclipse.end());
    const auto of = shader(eclipse);
    EXPECT_LE(of.facts["error"], 0.01) << eclipse[0];
    for (const double seconds : moments) {
      const auto worst =
          misses(of, seconds, air, words_of("--tolerance {} --ground mean", tolerance));
      EXPECT_WITHIN(std::max(worst.umbra, worst.bright), 0., 0.01, "as stated")
          << fmt::format("{} at {} s", eclipse[0], seconds);
    }
    const auto coloured = misses(of, moments[moments.size() / 2], air, {"--tolerance", tolerance});
    EXPECT_WITHIN(std::max(coloured.umbra, coloured.bright), 0., 0.02,
                  "as stated: the strip's light is for ground of the mean colour")
        << eclipse[0];
  }
}

TEST_F(Shader, IsFullSunlightBeforeAndAfter) {
  const auto of = shader(quick);
  const double half = of.facts["half_s"];
  for (const double seconds : {-1e6, -half, half, 1e6})
    for (const auto& place : places_on_moon()) {
      if (place[0] < 0) continue;  // the far side, in the night
      for (const double channel : of.at(place, seconds))
        EXPECT_WITHIN(channel, 1., 1e-6, "a half float holds 1 exactly");
    }
}

TEST_F(Shader, ItsMotionIsTheAlmanacs) {
  const auto of = shader(quick);
  // steps by name, run on the way to the light
  for (const double seconds : {-11000., -3000., 0., 8000.}) {
    const auto sky = almanac::sky_at(almanac::instant_from_utc(moment(of, seconds)));
    const auto axis = eclipse::shadow_axis(sky);
    for (const auto& place : {Vector{1, 0, 0}, Vector{0.6, 0, 0.8}, Vector{0.6, -0.8, 0}}) {
      const auto truth = eclipse::place_of_ground(axis, sky, {place[0], place[1], place[2]});
      const double km = algebra::in_kilometres(truth.axis_distance);
      EXPECT_WITHIN(of.step("from_axis", place, seconds) * 1737.4, km, 0.1, "as stated");
      EXPECT_WITHIN(of.step("depth", place, seconds) * 1737.4, algebra::in_kilometres(truth.depth),
                    0.1, "as stated");
      EXPECT_WITHIN(std::cos(2 * pi * of.step("turns", place, seconds) -
                             algebra::in_radians(truth.position_angle)),
                    1., 1e-6, "0.1 km in 100 km, squared");
    }
  }
}

TEST_F(Shader, OfGlslFindsTheLight) {
  const auto of = shader(quick);
  const auto source =
      "#version 300 es\nprecision highp float;\nin vec3 positionObject;\n"
      "uniform float seconds;\nout vec4 colour;\n" +
      text_of(here("eclipse/eclipse.glsl")) +
      "void main() { colour = vec4(eclipse_light(positionObject, seconds), 1); }\n";
  const auto places = places_on_moon();
  for (const double seconds : {-5400., 1000.}) {
    const auto found =
        shaded(source, {{"seconds", seconds}}, "eclipse_strip", of.strip, false, places);
    expect_alike(found, of, places, seconds, 0.01, "a GPU's filter has 256 steps between texels");
  }
}

TEST_F(Shader, OfPovRayFindsTheLight) {
  auto places = places_on_moon();
  places.resize(400);
  const auto expect_in_povray = [&](const EclipseShader& of, double seconds) {
    auto scene = fmt::format(
        "#version 3.7;\nglobal_settings {{ assumed_gamma 1.0 }}\n#include \"eclipse.inc\"\n"
        "Eclipse_At(0)\nEclipse_At({})\n",
        seconds);
    for (const auto& [x, y, z] : places)  // its y is north, its z 90 degrees east
      scene += fmt::format(
          "#debug concat(\"light \", vstr(3, <Eclipse_Red({0},{1},{2}), "
          "Eclipse_Green({0},{1},{2}), "
          "Eclipse_Blue({0},{1},{2})>, \" \", 0, 9), \"\\n\")\n",
          x, z, y);
    file("eclipse/print.pov", scene);
    const auto said = run("povray +Iprint.pov +W1 +H1 -D -F", {.folder = here("eclipse")});
    std::vector<Vector> found;
    std::istringstream lines(said.err);
    for (std::string line; std::getline(lines, line);) {
      Vector light;
      if (std::sscanf(line.c_str(), "light %lf %lf %lf", &light[0], &light[1], &light[2]) == 3)
        found.push_back(light);
    }
    ASSERT_EQ(found.size(), places.size()) << said.err.substr(0, 2000);
    expect_alike(found, of, places, seconds, 1e-4, "six digits");
  };
  const auto of = shader(quick);
  expect_in_povray(of, -5400);
  expect_in_povray(of, 1000);
  expect_in_povray(shader("2018-07-27T19:00:00Z --atmosphere undated --bands 20"), 1000);
}

/// The Moon of eclipse.pov, pixel by pixel, by rays of our own.
TEST_F(Shader, OfPovRayIsAFilm) {
  const auto of = shader(quick);
  const double seconds = -4000;
  const auto done = run("povray eclipse.pov +K-4000 +W40 +H40 +FE +Oframe.exr -D -A",
                        {.folder = here("eclipse")});
  ASSERT_EQ(done.status, 0) << done.err.substr(0, 2000);
  const auto frame = texture::read_image(here("eclipse/frame.exr"));
  const auto sky = almanac::sky_at(almanac::instant_from_utc(moment(of, seconds)));
  const auto& from_gcrs = sky.selenographic_from_gcrs;
  const auto eye = -from_gcrs * sky.moon_m / 1737400.;
  const auto forward = -glm::normalize(eye);
  const auto pole = from_gcrs * glm::transpose(sky.equator_from_gcrs)[2];
  const auto right = glm::normalize(glm::cross(forward, pole)),
             up = glm::cross(right, forward);  // celestial north; east is to the left
  const double half = std::tan(0.4 * pi / 180);
  int seen = 0;
  for (std::size_t r = 0; r < 40; ++r)
    for (std::size_t c = 0; c < 40; ++c) {
      const double x = (static_cast<double>(c) + 0.5) / 20 - 1,
                   y = 1 - (static_cast<double>(r) + 0.5) / 20;
      const auto ray = glm::normalize(forward + half * (x * right + y * up));
      const double along = -glm::dot(eye, ray), inside = 1 - glm::dot(eye, eye) + along * along;
      if (inside < 0.1) continue;  // the limb
      const auto p = eye + (along - std::sqrt(inside)) * ray;
      const auto light = of.at({p.x, p.y, p.z}, seconds);
      for (std::size_t k = 0; k < 3; ++k, ++seen)
        EXPECT_WITHIN(frame(r, c, k), 4000 * light[k], 4000 * light[k] * 5e-3 + 1e-3,
                      "half floats, and a column of the strip's slope in what a camera is off");
    }
  EXPECT_GT(seen, 1000);
}

TEST_F(ShaderThoroughly, OfOneMomentIsOnePlaneWhateverTheTime) {
  const Words air{"--scattered-light", "off"};
  for (const auto* when : {"2008-02-21T03:26:05Z", "2008-02-21T02:30:00Z"}) {
    const auto of = shader(Words{when} + air);
    EXPECT_EQ(of.strip.height, 97U);
    const auto greatest = almanac::instant_from_utc(of.facts["greatest"].get<std::string>());
    const double seconds = almanac::seconds_between(greatest, almanac::instant_from_utc(when));
    const auto worst = misses(of, seconds, air, {"--tolerance", "0.3%"});
    EXPECT_WITHIN(worst.umbra, 0., 0.03, "light at another depth than the plane's, near the axis");
    EXPECT_WITHIN(worst.bright, 0., 0.015, "the same, farther out");
    EXPECT_EQ(of.at({1, 0, 0}, -5000), of.at({1, 0, 0}, 5000));
  }
  EXPECT_EQ(run({"povray", "eclipse.pov", "+W40", "+H40", "-F", "-D"}, {.folder = here("eclipse")})
                .status,
            0);
}

TEST_F(Shader, WritesOverNothingOfYours) {
  shader(quick);
  file("eclipse/eclipse.glsl", "mine");
  const auto outcome = coppermoon(Words{"shader"} + quick + "-o eclipse");
  EXPECT_NE(outcome.status, 0);
  EXPECT_SAYS(outcome.err, "eclipse.glsl");
  EXPECT_EQ(text_of(here("eclipse/eclipse.glsl")), "mine");
}

TEST_F(Shader, ItsStripsHeaderMakesItAgain) {
  shader(quick);
  expect_done(coppermoon("shader --recipe eclipse/eclipse.exr -o again"));
  for (const auto* name : {"eclipse.exr", "eclipse.osl", "eclipse.json"})
    EXPECT_EQ(text_of(here("again") / name), text_of(here("eclipse") / name)) << name;
}

}  // namespace coppermoon::end_to_end::shader_test
