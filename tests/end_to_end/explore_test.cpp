// SPDX-License-Identifier: MIT
// Pages of eclipses in a real browser, held against what the program itself computes.
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "almanac/gazetteer.h"
#include "almanac/observer.h"
#include "colour/difference.h"
#include "colour/display.h"
#include "end_to_end/browser.h"
#include "povray_scenes/scene_camera.h"
#include "support/testing.h"
#include "texture/read_image.h"

namespace coppermoon::end_to_end::explore_test {

using nlohmann::json;

constexpr std::size_t texture_rows = 1024;  // of a page's map

/// A texel, and the place of its middle.
struct Place {
  std::size_t row, column;
  double latitude() const { return 90 - (static_cast<double>(row) + 0.5) * 180 / texture_rows; }
  double longitude() const {
    return -180 + (static_cast<double>(column) + 0.5) * 360 / (2 * texture_rows);
  }
};

/// Places on the near side, evenly over the sphere.
std::vector<Place> places(std::size_t count) {
  std::mt19937 random(20180727);
  std::uniform_real_distribution<double> height(-0.99, 0.99), longitude(-80, 80);
  std::vector<Place> all;
  for (std::size_t i = 0; i < count; ++i) {
    const double latitude = std::asin(height(random)) * 180 / std::acos(-1.);
    all.push_back({static_cast<std::size_t>((90 - latitude) / 180 * texture_rows),
                   static_cast<std::size_t>((longitude(random) + 180) / 360 * 2 * texture_rows)});
  }
  return all;
}

json as_json(const std::vector<Place>& places) {
  json all;
  for (const auto& place : places)
    all.push_back({{"latitude", place.latitude()}, {"longitude", place.longitude()}});
  return all;
}

double luminance(double red, double green, double blue) {
  return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
}

/// A script that runs beside pages once they are ready; `page` is the first Page.
std::string beside_pages(const std::string& script) {
  return "const all = [...document.querySelectorAll('.coppermoon')];\n"
         "const pages = await Promise.all(all.map((one) => one.ready));\n"
         "const page = pages[0];\n{" +
         script + "}";
}

/// A page that is made once for all tests, and asked once: one browser runs all scripts, one after another, each
/// from what the page first shows. A script's problem fails the test that asks first.
class SharedPage {
 public:
  explicit SharedPage(Words words) : words_(std::move(words)) {}

  /// Returns its number among all scripts.
  std::size_t add(std::function<std::string()> script) {
    scripts_.push_back(std::move(script));
    return scripts_.size() - 1;
  }
  json answer(std::size_t script) {
    if (answers_.empty()) ask();
    return answers_.at(script);
  }
  const std::string& text() {
    if (text_.empty()) ask();
    return text_;
  }

 private:
  void ask() {
    const ProgramFolder folder;
    expect_done(folder.coppermoon(Words("explore -o a.html") + words_));
    EXPECT_EQ(folder.listing(), std::set<std::string>{"here/a.html"});
    text_ = text_of(folder.here("a.html"));
    std::string all;
    for (const auto& script : scripts_) all += "async () => {" + script() + "},\n";
    answers_ = answer_of(
        folder, text_,
        beside_pages("const place = page.state.place, first = JSON.stringify(page.state);\n"
                     "const answers = [];\n"
                     "for (const script of [" +
                     all +
                     "]) {\n"
                     "  try { answers.push(await script()); }\n"
                     "  catch (problem) { problems.push(String(problem.stack)); "
                     "answers.push(null); }\n"
                     "  Object.assign(page.state, JSON.parse(first), {place});\n"
                     "  page.marked = null;\n"
                     "  page.airIsOld = JSON.stringify(page.shadow.air) !== "
                     "JSON.stringify(page.state.air);\n"
                     "  page.panel.show();\n"
                     "  page.draw();\n"
                     "}\n"
                     "return answers;"),
        "1280,800");
    if (!answers_.is_array()) answers_ = std::vector<json>(scripts_.size());
  }

  Words words_;
  std::vector<std::function<std::string()>> scripts_;
  std::string text_;
  json answers_;
};

SharedPage page_2018("2018-07-27 --at Nairobi"), page_2022("2022-05-16");

/// What a script returns on a page that tests share.
class Asked {
 public:
  Asked(SharedPage& page, std::function<std::string()> script)
      : page_(page), number_(page.add(std::move(script))) {}
  Asked(SharedPage& page, const char* script)
      : Asked(page, [script] { return std::string(script); }) {}
  json answer() const { return page_.answer(number_); }

 private:
  SharedPage& page_;
  std::size_t number_;
};

class Explore : public ProgramTest {
 protected:
  /// Makes a page; of undated air in a quarter of the time.
  void make(const std::string& day, const Words& more = {}, const std::string& file = "a.html") {
    expect_done(coppermoon(Words{"explore", day, "-o", file} + more));
  }

  /// What a script returns on a page of the test's own.
  json in_browser(const std::string& script, const std::string& size = "1280,800") const {
    return answer_of(*this, text_of(here("a.html")), beside_pages(script), size);
  }

  texture::Image baked(const std::string& when, const Words& more = {}) const {
    const auto outcome =
        coppermoon(words_of("bake {} --texture-width 2048 --tolerance 0.2% -o b.exr", when) + more);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return texture::read_image(here("b.exr"));
  }
};

/// The page's light over the texture's, less 1: the mean square's root, and the worst; the worst of red
/// over luminance.
struct Error {
  double rms = 0, worst = 0, red = 0;
};

Error error_of(const json& radiances, const std::vector<Place>& places,
               const texture::Image& texture) {
  Error error;
  std::size_t count = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto at = [&](std::size_t c) { return texture(places[i].row, places[i].column, c); };
    const double there = luminance(at(0), at(1), at(2));
    if (there <= 0) continue;
    const auto& rgb = radiances[i];
    const double off = luminance(rgb[0], rgb[1], rgb[2]) / there - 1;
    error.rms += off * off;
    error.worst = std::max(error.worst, std::abs(off));
    const double red = rgb[0].get<double>() / at(0) / (1 + off) - 1;
    error.red = std::max(error.red, std::abs(red));
    ++count;
  }
  EXPECT_GT(count, places.size() * 9 / 10) << "on the near side";
  error.rms = std::sqrt(error.rms / static_cast<double>(count));
  return error;
}

/// What is done to the air, and how far the page's light may be off.
using Changes = std::vector<std::pair<std::string, double>>;

std::string light_at(const Words& times) {
  return fmt::format(
      "page.set({{place: null}});\nreturn {}.map((when) => {{ page.set({{ms: Date.parse(when)}});\n"
      "  return page.radianceAt({}); }});",
      json(times).dump(), as_json(places(1000)).dump());
}

std::string light_in_airs(const Changes& changes) {
  auto script =
      "const was = {...page.state.air}, all = [];\npage.set({place: null});\nconst where = " +
      as_json(places(500)).dump() + ";\n";
  for (const auto& change : changes)
    script += "page.set({air: {...was, ..." + change.first +
              "}});\nall.push({light: page.radianceAt(where), command: "
              "page.find('command').textContent});\n";
  return script + "return all;";
}

class ExploreLight : public Explore {
 protected:
  void expect_light_of_bakes(const json& all, const Words& times, const Words& air = {}) {
    const auto where = places(1000);
    for (std::size_t i = 0; i < times.size(); ++i) {
      const auto error = error_of(all[i], where, baked(times[i], air));
      EXPECT_LT(error.worst, 0.01)
          << times[i] << ": albedo in 255 steps, 0.5 %; light, 0.5 %; halves, 0.05 %";
      EXPECT_LT(error.rms, 0.004) << times[i];
      EXPECT_LT(error.red, 0.01) << times[i] << ": ground of one colour would err by 2 %";
    }
  }

  /// The command that the page shows makes the same Moon.
  void expect_airs_of_commands(const json& all, const Changes& changes) {
    const auto where = places(500);
    for (std::size_t i = 0; i < changes.size(); ++i) {
      // "coppermoon still WHEN --time … --iso … --f-number … AIR -o moon.png"
      std::istringstream command(all[i]["command"].get<std::string>());
      Words words;
      for (std::string word; command >> word;) words.push_back(word);
      const auto air = std::find(words.begin(), words.end(), "--f-number") + 2;
      const auto error =
          error_of(all[i]["light"], where, baked(words[2], Words(air, words.end() - 2)));
      EXPECT_LT(error.worst, changes[i].second) << changes[i].first << ": " << command.str();
      EXPECT_GT(words.end() - air, 3) << changes[i].first << " is in the command";
    }
  }
};

class ExploreLightThoroughly : public ExploreLight {};

/// Places and moments from which the Moon stands high, 3 and 5 degrees high.
const std::vector<std::pair<std::string, std::string>> sights{{"Nairobi", "2018-07-27T19:05:00Z"},
                                                              {"London", "2018-07-27T20:21:45Z"},
                                                              {"London", "2018-07-27T20:35:00Z"}};

const Asked seen_light(page_2018, [] {
  std::string script = "const seen = [], where = " + as_json(places(500)).dump() + ";\n";
  for (const auto& [city, when] : sights)
    script += fmt::format(
        "page.set({{place: page.panel.places.named('{}'), ms: Date.parse('{}')}});\n"
        "seen.push({{light: page.radianceAt(where), altitude: page.scene().view.trueAltitude, "
        "command: page.find('command').textContent, whole: page.find('whole').textContent}});\n",
        city, when);
  return script +
         "page.set({reddening: false});\n"
         "const command = page.find('command').textContent, above = page.radianceAt(where);\n"
         "page.set({place: null, reddening: true});\n"
         "return {seen, command, whole: page.find('whole').textContent, above, unobserved: "
         "page.radianceAt(where)};";
});

TEST_F(ExploreLightThoroughly, IsReddenedByTheObserversAirAsTheCommandReddensIt) {
  const auto said = seen_light.answer();
  for (std::size_t i = 0; i < sights.size(); ++i) {
    const auto& seen = said["seen"][i];
    const auto command = seen["command"].get<std::string>();
    EXPECT_SAYS_NOT(command, "--reddening") << "on, as without a word";
    const auto at = command.find("--at ") + 5;
    const auto error =
        error_of(seen["light"], places(500),
                 baked(sights[i].second, {"--at", command.substr(at, command.find(' ', at) - at)}));
    EXPECT_LT(error.worst, 0.01) << command;
    EXPECT_LT(error.rms, 0.004) << command;
    EXPECT_LT(error.red, 0.01) << command;
  }
  EXPECT_WITHIN(said["seen"][1]["altitude"].get<double>(), 3.24, 0.05, "the Moon is low");
  EXPECT_SAYS(said["command"].get<std::string>(), " --reddening off --flattening off ");
  EXPECT_EQ(said["above"], said["unobserved"]);
  const auto magnitude = [](const json& text) {
    const auto all = text.get<std::string>();
    return all.substr(0, all.find(" · mean"));
  };
  EXPECT_EQ(magnitude(said["whole"]), magnitude(said["seen"][2]["whole"])) << "above the air";
}

/// In the deepest umbra.
const Words deepest{"2018-07-27T20:21:45Z"};
const Asked light_when_deepest(page_2018, [] { return light_at(deepest); });

TEST_F(ExploreLight, IsThatOfABakedTexture) {
  expect_light_of_bakes(light_when_deepest.answer(), deepest);
}

/// At the umbra's edge.
const Words after_an_eruption{"2022-05-16T03:29:07Z"};
const Asked light_after_an_eruption(page_2022, [] { return light_at(after_an_eruption); });

TEST_F(ExploreLightThoroughly, IsThatOfABakedTextureAfterAnEruption) {
  expect_light_of_bakes(light_after_an_eruption.answer(), after_an_eruption);
}

TEST_F(ExploreLightThoroughly, IsThatOfABakedTextureInAPartialEclipseAndUndatedAir) {
  const Words undated = "--atmosphere undated", times{"2008-08-16T21:10:07Z"};
  make("2008-08-16", undated);
  expect_light_of_bakes(in_browser(light_at(times)), times, undated);
}

TEST_F(ExploreLightThoroughly, IsThatOfBakedTexturesAtAllPhases) {
  const std::map<std::string, Words> moments{
      {"2018-07-27", {"2018-07-27T17:54:28Z", "2018-07-27T19:27:17Z"}},
      {"2022-05-16", {"2022-05-16T02:57:56Z", "2022-05-16T04:11:32Z"}},
      {"2008-08-16", {"2008-08-16T18:40:00Z", "2008-08-16T19:36:05Z", "2008-08-16T21:10:07Z"}}};
  for (const auto& [day, times] : moments) {
    make(day);
    expect_light_of_bakes(in_browser(light_at(times)), times);
  }
}

const Changes changes{
    {"{cloud: 0.4, haze: 2}", 0.02}, {"{dust: 0.05}", 0.03}, {"{refraction: false}", 0.025}};
const Asked changed_light(page_2018, [] { return light_in_airs(changes); });

TEST_F(ExploreLight, IsThatOfTheCommandThatThePageShows) {
  expect_airs_of_commands(changed_light.answer(), changes);
}

/// Of each change the error that docs/explore.md states.
TEST_F(ExploreLightThoroughly, IsThatOfTheCommandThatThePageShowsInAnyAir) {
  const Changes all{{"{cloud: 0}", 0.02},
                    {"{clouds: false, aerosol: false}", 0.02},
                    {"{dust: 0.18}", 0.05},
                    {"{ozone: false}", 0.02},
                    {"{ozoneDu: 450}", 0.025},
                    {"{scattering: false}", 0.02},
                    {"{clearness: page.facts.danjon[0]}", 0.03},
                    {"{clearness: page.facts.danjon[1]}", 0.03}};
  make("2018-07-27");
  expect_airs_of_commands(in_browser(light_in_airs(all)), all);
}

const Asked developed(page_2018, [] {
  return "page.set({place: null, ms: Date.parse('2018-07-27T19:05:00Z')});\nconst where = " +
         as_json(places(300)).dump() +
         ";\nconst gl = page.picture.gl, frame = page.frame(), box = "
         "page.picture.canvas.getBoundingClientRect();\n"
         "const pixels = where.map((at) => page.pixelOf(at)).filter(Boolean).map((xy) => "
         "xy.map(Math.floor))\n"
         "  .map(([x, y]) => ({x, y, at: page.under({clientX: box.left + (x + 0.5) / frame.ratio, "
         "clientY: box.top + (y + 0.5) / frame.ratio})}))\n"
         "  .filter(({at}) => at);\n"
         "const light = page.radianceAt(pixels.map(({at}) => at));\n"
         "return page.facts.views.map((look) => {\n"
         "  page.set({look, exposure: {rule: 'fixed', time: 0.5, iso: 800, fNumber: 12.1}});\n"
         "  const bytes = new Uint8Array(4 * frame.width * frame.height);\n"
         "  gl.readPixels(0, 0, frame.width, frame.height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);\n"
         "  return pixels.map(({x, y}, i) => { const at = 4 * ((frame.height - 1 - y) * "
         "frame.width + "
         "x);\n"
         "    return {look, shown: [...bytes.slice(at, at + 3)], light: light[i]}; }); });";
});

TEST_F(Explore, PicturesAreDevelopedAsByTheProgram) {
  const double scale = 0.8333333 * 0.5 * 8 / (12.1 * 12.1);  // colour::exposure_scale
  for (const auto& view : developed.answer()) {
    ASSERT_GT(view.size(), 250U);
    double sum = 0;
    std::string look;
    for (const auto& pixel : view) {
      look = pixel["look"];
      colour::Image one(1, 1);
      for (std::size_t c = 0; c < 3; ++c) one(0, 0)[c] = pixel["light"][c].get<float>();
      auto expected =
          colour::developed(one, colour::WorkingSpace::linear_rec709, {scale, look})(0, 0);
      colour::Rgb shown;
      for (std::size_t c = 0; c < 3; ++c) {
        shown[c] = pixel["shown"][c].get<float>() / 255;
        expected[c] = std::clamp(expected[c], 0.F, 1.F);
      }
      sum += colour::delta_e_2000(colour::lab_from_srgb(shown), colour::lab_from_srgb(expected));
    }
    EXPECT_LT(sum / static_cast<double>(view.size()), 1)
        << look << ": in the mean less than is seen side by side";
  }
}

const std::vector<std::string> features{"Tycho", "Mare Crisium", "Plato"};
const Asked seen_features(page_2018, [] {
  json where;
  for (const auto& name : features) {
    const auto at = almanac::lunar_feature_named(name)->middle;
    where.push_back({{"latitude", algebra::in_degrees(at.latitude)},
                     {"longitude", algebra::in_degrees(at.longitude)}});
  }
  return "page.set({place: {...page.state.place, elevationKm: 0}});\n"
         "return ['north', 'zenith', 'moon'].map((up) => {\n"
         "  page.set({ms: Date.parse('2018-07-27T20:40:00Z'), up});\n"
         "  const {frame, view} = page.scene();\n"
         "  return {frame, view, seen: " +
         where.dump() +
         ".map((at) => page.pixelOf(at))};\n"
         "});";
});

TEST_F(Explore, PlacesAreSeenWhereTheCameraSeesThem) {
  const auto sky = almanac::sky_at(almanac::instant_from_utc("2018-07-27T20:40:00Z"));
  const auto nairobi = almanac::city_named("Nairobi")->place;
  const auto view = almanac::view_from({nairobi.latitude, nairobi.longitude, {}}, sky);
  const auto all = seen_features.answer();
  std::size_t way = 0;
  for (const auto up : {povray_scenes::Up::celestial_north, povray_scenes::Up::zenith,
                        povray_scenes::Up::moon_north}) {
    const auto& said = all[way++];
    const auto& frame = said["frame"];
    const auto width = frame["width"].get<std::size_t>(),
               height = frame["height"].get<std::size_t>();
    // the picture's half width in lunar radii at the Moon's distance is the tangent of half the field
    const double half = frame["pixel"].get<double>() * static_cast<double>(width) / 2 *
                        algebra::in_metres(almanac::lunar_radius) /
                        algebra::in_metres(view.moon_distance);
    const auto camera = povray_scenes::camera_at(
        sky, view, up, {algebra::radians(2 * std::atan(half)), width, height});
    for (std::size_t i = 0; i < features.size(); ++i) {
      const auto pixel =
          povray_scenes::pixel_of(camera, almanac::lunar_feature_named(features[i])->middle);
      ASSERT_TRUE(pixel);
      EXPECT_WITHIN(said["seen"][i][0].get<double>(), pixel->x, 1, features[i] + " within a pixel");
      EXPECT_WITHIN(said["seen"][i][1].get<double>(), pixel->y, 1, features[i] + " within a pixel");
    }
    EXPECT_WITHIN(said["view"]["azimuth"].get<double>(), algebra::in_degrees(view.azimuth), 0.02,
                  "refraction does not turn it; the vertical of WGS 84");
    EXPECT_WITHIN(said["view"]["altitude"].get<double>(), algebra::in_degrees(view.altitude), 0.02,
                  "refraction at 64 degrees is 0.008");
  }
}

const Words measured = "2022-05-16T03:00:00Z 2022-05-16T04:11:32Z";
const Asked magnitudes(page_2022, [] {
  return fmt::format(
      "return {}.map((when) => {{ page.set({{ms: Date.parse(when)}}); return "
      "page.find('whole').textContent; }});",
      json(measured).dump());
});

TEST_F(Explore, MagnitudesAreThoseOfBrightness) {
  const auto said = magnitudes.answer();
  for (std::size_t i = 0; i < measured.size(); ++i) {
    const auto outcome = coppermoon({"brightness", measured[i], "--json"});
    const double V = json::parse(outcome.out)["magnitudes"]["V"];
    // "V −0.83 · mean …"
    auto text = said[i].get<std::string>().substr(2);
    if (const std::string minus = "−"; text.starts_with(minus))
      text = "-" + text.substr(minus.size());
    EXPECT_WITHIN(std::stod(text), V, 0.02,
                  "96 pixels across the disc; two decimals; light to 0.5 %");
  }
}

const Asked light_of_the_sky(
    page_2018,
    "page.set({place: {latitude: 52.52, longitude: 13.41, elevationKm: 0, name: '', timeZone: "
    "''}});\n"
    "const said = ['19:00', '19:30', '20:00', '22:00'].map((time) => {\n"
    "  page.set({ms: Date.parse(`2018-07-27T${time}:00Z`)}); page.draw(); return page.around; });\n"
    "page.set({reddening: false}); page.draw(); said.push(page.around);\n"
    "page.set({reddening: true, ms: Date.parse('2018-07-27T18:30:00Z')}); page.draw();\n"
    "return [...said, page.around];");

TEST_F(Explore, SkyIsTheClearSkyAroundTheMoon) {
  const auto said = light_of_the_sky.answer();
  const auto outcome = coppermoon(
      "brightness 2018-07-27 --from 2018-07-27T19:00Z --to 2018-07-27T22:00Z --step 30 --at "
      "52.52,13.41 --json");
  const auto moments = json::parse(outcome.out)["moments"];
  for (const auto& [i, moment] : {std::pair{0, 0}, {1, 1}, {2, 2}, {3, 6}})
    EXPECT_WITHIN_RELATIVE(luminance(said[i][0], said[i][1], said[i][2]),
                           moments[moment]["sky_cd_m2"].get<double>(), 0.05,
                           "the Moon's 0.02 mag; nodes half a degree of the Sun apart: 0.02");
  EXPECT_GT(said[0][2], said[0][0]) << "blue at dusk";
  for (const int none : {4, 5})  // the observer's air is taken away; below the horizon
    EXPECT_EQ(said[none], json({0, 0, 0}));
}

const Asked controls(
    page_2018,
    "const fields = () => Object.fromEntries(Object.entries(page.state).map(([name, value]) => "
    "[name, JSON.stringify(value)]));\n"
    "const first = fields(), changed = {};\n"
    "const note = (name) => { changed[name] = Object.keys(first).filter((key) => fields()[key] "
    "!== first[key]);\n"
    "  Object.entries(first).forEach(([key, value]) => { page.state[key] = JSON.parse(value); "
    "}); page.panel.show(); };\n"
    "for (const part of ['who', 'exposure', 'air', 'why']) {\n"
    "  const count = page.find(part).querySelectorAll('input, select').length;\n"
    "  for (let i = 0; i < count; ++i) {\n"
    "    const control = page.find(part).querySelectorAll('input, select')[i];\n"
    "    const label = control.closest('label').textContent.slice(0, 12);\n"
    "    if (control.type === 'checkbox') control.click();\n"
    "    else { control.value = control.tagName === 'SELECT' ? [...control.options].find((o) => "
    "!o.selected).value\n"
    "        : control.type === 'range' ? 0.4 : 'Chicago';\n"
    "      control.dispatchEvent(new Event('input')); control.dispatchEvent(new "
    "Event('change')); }\n"
    "    note(`${part} ${i} ${label}`);\n"
    "  }\n"
    "}\n"
    "return changed;");

TEST_F(Explore, EachControlChangesWhatItSaysAndNothingElse) {
  const auto said = controls.answer();
  EXPECT_GE(said.size(), 16U);
  for (const auto& [control, fields] : said.items()) {
    ASSERT_EQ(fields.size(), 1U) << control << " changes " << fields;
    const std::string field = fields[0];
    if (control.starts_with("air") || control.starts_with("why")) {
      EXPECT_EQ(field, "air") << control;
    }
    if (control.starts_with("who 0")) {
      EXPECT_EQ(field, "place") << control;
    }
    if (control.starts_with("exposure 0")) {
      EXPECT_EQ(field, "exposure") << control;
    }
  }
}

const Asked touched(
    page_2018,
    "const {canvas} = page.picture, box = canvas.getBoundingClientRect();\n"
    "const touch = (kind, pointerId, clientX, clientY) => canvas.dispatchEvent(new "
    "PointerEvent(kind, {pointerId, clientX, clientY}));\n"
    "const crater = {longitude: -11.4, latitude: -43.3}, ratio = page.frame().ratio;\n"
    "const at = () => page.pixelOf(crater).map((x, i) => x / ratio + [box.left, box.top][i]);\n"
    "const off = (x, y) => Math.hypot(at()[0] - x, at()[1] - y);\n"
    "const [x, y] = at(), said = {};\n"
    "touch('pointerdown', 1, x - 20, y); touch('pointerdown', 2, x + 20, y);\n"
    "touch('pointermove', 1, x - 60, y); touch('pointermove', 2, x + 60, y);\n"
    "said.zoom = page.state.zoom; said.stays = off(x, y);\n"
    "touch('pointermove', 1, x - 60 + 30, y + 10); touch('pointermove', 2, x + 60 + 30, y + 10);\n"
    "said.follows = off(x + 30, y + 10);\n"
    "touch('pointerup', 1, x - 30, y + 10);\n"
    "touch('pointermove', 2, x + 100, y + 10);\n"
    "said.dragged = off(x + 40, y + 10);\n"
    "touch('pointerup', 2, x + 100, y + 10);\n"
    "touch('pointermove', 2, x, y);\n"
    "said.left = off(x + 40, y + 10);\n"
    "touch('pointerdown', 1, x - 60, y); touch('pointerdown', 2, x + 60, y);\n"
    "touch('pointermove', 2, x - 58, y);\n"
    "said.whole = [page.state.zoom, ...page.state.middle];\n"
    "touch('pointercancel', 1, x, y); touch('pointercancel', 2, x, y);\n"
    "return said;");

TEST_F(Explore, TwoFingersEnlargeTheMoonAboutThePlaceBetweenThem) {
  const auto said = touched.answer();
  EXPECT_WITHIN(said["zoom"].get<double>(), 3, 1e-9, "they moved three times as far apart");
  for (const char* how : {"stays", "follows", "dragged", "left"})
    EXPECT_LT(said[how].get<double>(), 1.) << how << ", in pixels of the page";
  EXPECT_EQ(said["whole"], json({1, 0, 0})) << "pinched, the whole Moon is in the middle again";
}

const Asked saved(page_2018,
                  "const kept = HTMLAnchorElement.prototype.click;\n"
                  "const said = await new Promise((take) => {\n"
                  "  HTMLAnchorElement.prototype.click = async function () {\n"
                  "    const bitmap = await createImageBitmap(await (await "
                  "fetch(this.href)).blob());\n"
                  "    const drawn = new OffscreenCanvas(bitmap.width, bitmap.height);\n"
                  "    const context = drawn.getContext('2d');\n"
                  "    context.drawImage(bitmap, 0, 0);\n"
                  "    const middle = context.getImageData(bitmap.width / 2, bitmap.height / 2, 1, "
                  "1).data;\n"
                  "    take({name: this.download, size: [bitmap.width, bitmap.height], "
                  "middle: [...middle]});\n"
                  "  };\n"
                  "  page.find('save').click();\n"
                  "});\n"
                  "HTMLAnchorElement.prototype.click = kept;\n"
                  "const {width, height} = page.picture.canvas;\n"
                  "return {...said, canvas: [width, height]};");

TEST_F(Explore, SavesThePictureThatItShows) {
  const auto said = saved.answer();
  EXPECT_EQ(said["name"], "moon_2018-07-27T202145Z.png");
  EXPECT_EQ(said["size"], said["canvas"]);
  const auto middle = said["middle"].get<std::vector<int>>();
  EXPECT_GT(middle.at(0), 20) << "the Moon is in the middle";
  EXPECT_GT(middle.at(0), middle.at(2)) << "and red";
}

const Asked links(
    page_2018,
    "page.set({ms: Date.parse('2018-07-27T19:05:00Z'), up: 'zenith', look: 'Filmic', circle: "
    "true,\n"
    "  exposure: {rule: 'fixed', time: 0.25, iso: 400, fNumber: 5.6}, air: {...page.state.air, "
    "cloud: 0.5, ozone: false}});\n"
    "page.drawBeside();\n"
    "const until = async (done) => { for (let i = 0; i < 4000 && !done(); ++i) await new "
    "Promise(requestAnimationFrame); };\n"
    "const before = JSON.stringify(page.state), hash = location.hash;\n"
    "const picture = () => page.picture.canvas.toDataURL();\n"
    "const seen = picture();\n"
    "history.replaceState(null, '', '#');\n"
    "page.set({ms: Date.parse('2018-07-27T20:05:00Z'), circle: false, look: 'Un-tone-mapped', "
    "up: 'north'});\n"
    "const other = picture() !== seen;\n"
    "location.hash = hash;\n"
    "await until(() => picture() === seen);\n"
    "const again = JSON.stringify(page.state), restored = picture() === seen;\n"
    "const key = (name, shiftKey = false) => page.find('moon').dispatchEvent(\n"
    "  new KeyboardEvent('keydown', {key: name, shiftKey, bubbles: true, composed: true}));\n"
    "key('ArrowRight');\n"
    "document.body.dispatchEvent(new KeyboardEvent('keydown', {key: 'ArrowRight', shiftKey: true, "
    "bubbles: true}));\n"
    "page.marked = {longitude: -11.2, latitude: -43.3};\n"
    "page.find('nearer').click();\n"
    "const nearer = page.pixelOf(page.marked).map((x, i) => x - [page.frame().width, "
    "page.frame().height][i] / 2);\n"
    "page.find('farther').click();\n"
    "const whole = [page.state.zoom, ...page.state.middle];\n"
    "page.marked = null;\n"
    "const moved = page.state.ms - Date.parse('2018-07-27T19:05:00Z');\n"
    "location.hash = '#t=1900-01-01T00:00:00Z';\n"
    "await until(() => page.state.ms < Date.parse('2018-07-27T17:30:00Z'));\n"
    "const first = page.state.ms - page.motion.fromMs;\n"
    "location.hash = hash;\n"
    "await until(() => JSON.stringify(page.state) === before);\n"
    "page.draw();\n"
    "const lose = page.picture.gl.getExtension('WEBGL_lose_context');\n"
    "lose.loseContext();\n"
    "await until(() => page.picture.gl.isContextLost());\n"
    "const lost = page.picture.gl.isContextLost();\n"
    "await until(() => { try { lose.restoreContext(); } catch {} return "
    "!page.picture.gl.isContextLost(); });\n"
    "await until(() => picture() === seen);\n"
    "return {before, again, other, restored, moved, first, nearer, whole, lost, back: picture() "
    "=== "
    "seen};");

TEST_F(Explore, LinksKeysAndALostContextBringBackWhatWasSeen) {
  const auto said = links.answer();
  EXPECT_EQ(said["before"], said["again"]) << "a link keeps all settings";
  EXPECT_TRUE(said["other"].get<bool>());
  EXPECT_TRUE(said["restored"].get<bool>());
  EXPECT_EQ(said["moved"], 11 * 60000) << "keys work on the Moon, and where nothing has the focus";
  EXPECT_EQ(said["first"], 0) << "before the eclipse there is nothing to show";
  for (const auto& away : said["nearer"])
    EXPECT_WITHIN(away.get<double>(), 0, 1e-6, "the place that is marked comes to the middle");
  EXPECT_EQ(said["whole"], json({1, 0, 0}));
  EXPECT_TRUE(said["lost"].get<bool>());
  EXPECT_TRUE(said["back"].get<bool>()) << "after a lost context the picture is the same";
}

const Asked sayings(
    page_2018,
    "const slider = (title) => page.find('air').querySelector(`input[aria-label='${title}']`);\n"
    "const command = () => page.find('command').textContent;\n"
    "const first = {...page.state.air};\n"
    "const readout = () => page.find('readout').textContent;\n"
    "const shown = command(), follows = page.seconds;\n"
    "page.marked = {longitude: -11.2, latitude: -43.3};\n"
    "page.draw();\n"
    "const before = {readout: readout(), dust: Number(slider('Volcanic dust').value),\n"
    "  cloud: slider('Cloud').parentElement.querySelector('output').textContent};\n"
    "page.set({ms: page.state.ms + 18e5});\n"
    "const later = readout(), told = page.described(page.marked);\n"
    "page.set({ms: page.state.ms - 18e5});\n"
    "page.find('steps').querySelectorAll('button')[0].click();\n"
    "page.draw();\n"
    "const dark = {readout: readout(), seconds: page.seconds, command: command(),\n"
    "  dust: Number(slider('Volcanic dust').value)};\n"
    "page.find('steps').querySelectorAll('button')[4].click();\n"
    "page.draw();\n"
    "const bright = {readout: readout(), cloud: "
    "slider('Cloud').parentElement.querySelector('output').textContent, pressed: "
    "page.find('steps').querySelectorAll('[aria-pressed=true]').length};\n"
    "slider('Haze').value = 0.5;\n"
    "slider('Haze').dispatchEvent(new Event('input'));\n"
    "bright.slid = page.find('steps').querySelectorAll('[aria-pressed=true]').length;\n"
    "page.set({place: page.panel.places.named('Mexico City')});\n"
    "page.drawBeside();\n"
    "const link = decodeURIComponent(location.hash), noneShown = command();\n"
    "page.set({place: page.facts.place, air: {...first}});\n"
    "const nairobi = page.find('when').textContent, up = page.find('note').textContent;\n"
    "page.set({place: page.panel.places.named('Chicago')});\n"
    "return {command: shown, follows, before, later, told, dark, bright, link, none_shown: "
    "noneShown,\n"
    "  nairobi, up, below: page.find('note').textContent, chicago: "
    "page.find('when').textContent,\n"
    "  unnamed: (page.set({place: page.panel.places.named('Buenos Aires')}), "
    "page.find('when').textContent),\n"
    "  title: page.root.querySelector('header').getBoundingClientRect().bottom > "
    "page.find('moon').getBoundingClientRect().top,\n"
    "  altitude: (page.set({place: page.panel.places.named('Chicago')}), "
    "page.scene().view.altitude),\n"
    "  pair: page.panel.places.named('-1.3, 36.8').timeZone, none: "
    "page.panel.places.named('Nowhere at all')};");

TEST_F(Explore, PlaceTimeAndAirAreSaidAsTheyAreSeen) {
  const auto said = sayings.answer();
  EXPECT_SAYS(said["nairobi"].get<std::string>(), "23:21:45 EAT");
  EXPECT_EQ(said["up"], "");
  EXPECT_EQ(said["below"], "The Moon is below the horizon there.");
  EXPECT_SAYS(said["chicago"].get<std::string>(), "15:21:45 CDT");
  EXPECT_SAYS(said["unnamed"].get<std::string>(), "17:21:45 UTC−3")
      << "the zone's abbreviation is -03: " << said["unnamed"];
  EXPECT_FALSE(said["title"].get<bool>()) << "the title lies over no Moon on a wide screen either";
  const auto chicago =
      almanac::view_from(almanac::city_named("Chicago")->place,
                         almanac::sky_at(almanac::instant_from_utc("2018-07-27T20:21:45Z")));
  EXPECT_WITHIN(
      said["altitude"].get<double>(), algebra::in_degrees(chicago.altitude), 0.01,
      "cities' coordinates to 0.01 degrees; the true altitude, for no light comes from there");
  EXPECT_EQ(said["pair"], "Africa/Nairobi");
  EXPECT_TRUE(said["none"].is_null());
  EXPECT_SAYS(said["command"].get<std::string>(), " --at -1.2800,36.8200,1684 --flattening off ")
      << said["command"];
  EXPECT_EQ(said["later"], said["told"]) << "at the moment that is shown";
  EXPECT_NE(said["later"], said["before"]["readout"]);
  EXPECT_NE(said["dark"]["readout"], said["before"]["readout"]);
  EXPECT_EQ(said["dark"]["seconds"], said["follows"]) << "a darker Moon is seen darker";
  EXPECT_SAYS(said["dark"]["command"].get<std::string>(), "--danjon 0");
  EXPECT_GT(said["dark"]["dust"], said["before"]["dust"]) << "the sliders show the air of a step";
  EXPECT_EQ(said["before"]["cloud"], "× 1");
  EXPECT_NE(said["bright"]["cloud"], "× 1");
  EXPECT_EQ(said["bright"]["pressed"], 1);
  EXPECT_EQ(said["bright"]["slid"], 0) << "the air is that of a step no more";
  EXPECT_EQ(said["none_shown"], "none: from that place the Moon is below the horizon");
  EXPECT_SAYS(said["link"].get<std::string>(), "|America/Mexico_City|2.2")
      << "the elevation: " << said["link"];
}

TEST_F(Explore, PagesAreOneFileNeedNoNetworkAndFitAPhone) {
  const auto& page = page_2018.text();
  file("a.html", page);
  EXPECT_LT(page.size(), 4e6);
  for (const char* fetched : {"http://", "https://", "src=", "@import", "import("})
    EXPECT_SAYS_NOT(page, fetched);
  const auto said = in_browser(
      "const frame = () => new Promise(requestAnimationFrame), box = (part) => "
      "part.getBoundingClientRect();\n"
      "const wide = document.documentElement.scrollWidth;\n"
      "document.body.style.width = '358px';\n"
      "page.set({place: page.panel.places.named('Honolulu'), look: 'stops'});\n"
      "for (let i = 0; i < 4; ++i) await frame();\n"
      "const slider = box(page.find('moment'));\n"
      "let covered = 0;\n"
      "for (let x = slider.left + 1; x < slider.right; ++x)\n"
      "  for (const y of [slider.top + 1, slider.bottom - 1])\n"
      "    if (page.root.elementFromPoint(x, y) !== page.find('moment')) ++covered;\n"
      "const marks = [...page.find('marks').children].map(box);\n"
      "const meet = (a, b) => Math.min(a.right, b.right) > Math.max(a.left, b.left) + 0.01 &&\n"
      "  Math.min(a.bottom, b.bottom) > Math.max(a.top, b.top) + 0.01;\n"
      "const legend = page.find('legend'), steps = legend.querySelectorAll('li').length, shown = "
      "box(legend).height > 0;\n"
      "page.set({look: page.facts.views[0]});\n"
      "const copied = [], click = async (clipboard, execCommand, name) => {\n"
      "  Object.defineProperty(navigator, 'clipboard', {value: clipboard, configurable: true});\n"
      "  document.execCommand = execCommand;\n"
      "  page.find(name).click();\n"
      "  for (let i = 0; i < 3; ++i) await frame();\n"
      "  const field = page.find('to-copy');\n"
      "  copied.push([page.find('copied').textContent, field.hidden,\n"
      "    field.value.slice(field.selectionStart, field.selectionEnd) === (name === 'copy' ?\n"
      "      page.find('command').textContent : location.href)]);\n"
      "};\n"
      "page.root.querySelector('.make').open = true;\n"
      "page.drawBeside();\n"
      "await click({writeText: async () => {}}, () => false, 'copy');\n"
      "await click({writeText: async () => { throw Error('denied'); }}, () => true, 'copy');\n"
      "await click(undefined, () => true, 'link');\n"
      "await click(undefined, () => false, 'link');\n"
      "const silent = document.createElement('iframe');\n"
      "silent.srcdoc = `<meta http-equiv=Content-Security-Policy content=\"script-src 'self'\">` "
      "+\n"
      "  page.root.host.parentElement.outerHTML;\n"
      "await new Promise((loaded) => { silent.onload = loaded; document.body.append(silent); });\n"
      "const word = silent.contentDocument.body.innerText;\n"
      "return {copied, word, wide, covered, width: slider.width, legend: shown && steps, hidden: "
      "box(legend).height,\n"
      "  meeting: marks.filter((a, i) => marks.some((b, j) => j > i && meet(a, b))).length,\n"
      "  title: meet(box(page.root.querySelector('header')), box(page.find('moon'))),\n"
      "  options: page.facts.options, when: page.find('when').textContent,\n"
      "  lines: [...page.find('when').children].map((part) => "
      "part.getClientRects().length)};",
      "500,900");
  EXPECT_LE(said["wide"].get<int>(), 500) << "on a phone nothing stands beside the screen";
  EXPECT_GT(said["width"], 300);
  EXPECT_EQ(said["covered"], 0) << "all of the slider can be grabbed";
  EXPECT_EQ(said["meeting"], 0) << "the contacts stand beside each other";
  EXPECT_FALSE(said["title"].get<bool>()) << "the title lies over no Moon";
  EXPECT_SAYS(said["when"].get<std::string>(), " HST");
  EXPECT_EQ(said["lines"], json({1, 1})) << "no zone is broken";
  EXPECT_EQ(said["legend"], 10) << "false colours say what they are";
  EXPECT_EQ(said["hidden"], 0);
  EXPECT_EQ(said["options"], "");
  const std::string selected =
      "The browser does not let this page copy. The text is selected: copy it yourself.";
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(said["copied"][i][0], "Copied.") << i;
    EXPECT_TRUE(said["copied"][i][1].get<bool>()) << i;
  }
  EXPECT_EQ(said["copied"][3], json({selected, false, true}));
  EXPECT_TRUE(said["word"].get<std::string>().starts_with(
      "Total eclipse of the Moon, 2018-07-27, drawn by this page's script. It has not begun"))
      << "under a policy that forbids scripts: " << said["word"];
  EXPECT_SAYS(page, "<noscript><p>Scripts are switched off in this browser.</p></noscript>");
}

using ExploreThoroughly = Explore;

TEST_F(ExploreThoroughly, FragmentsStandBesideEachOther) {
  make("2018-07-27", "--embed --atmosphere clear", "one.html");
  make("2025-03-14", "--embed --atmosphere undated", "other.html");
  EXPECT_SAYS_NOT(text_of(here("one.html")), "<html");
  file("a.html", "<body><style>canvas { border: 9px solid red; }</style>" +
                     text_of(here("one.html")) + text_of(here("other.html")));
  const auto said = in_browser(
      "history.replaceState(null, '', '#anchor');\n"
      "const before = page.state.ms;\n"
      "document.body.dispatchEvent(new KeyboardEvent('keydown', {key: 'ArrowRight', bubbles: "
      "true}));\n"
      "const own = page.state.ms - before;\n"
      "page.find('moon').dispatchEvent(new KeyboardEvent('keydown', {key: 'ArrowRight', bubbles: "
      "true, composed: true}));\n"
      "pages.forEach((one) => one.drawBeside());\n"
      "const host = [location.hash, own, page.state.ms - before, pages[1].state.ms - "
      "pages[1].facts.contacts.find(({name}) => name === 'greatest').ms];\n"
      "return [...pages.map((one) => [one.find('eclipse').querySelector('h1').textContent, "
      "one.facts.options,\n"
      "  getComputedStyle(one.find('moon')).borderTopWidth]), host];");
  EXPECT_EQ(said[0], json({"Total eclipse of the Moon, 2018-07-27", "--atmosphere clear", "0px"}));
  EXPECT_EQ(said[1],
            json({"Total eclipse of the Moon, 2025-03-14", "--atmosphere undated", "0px"}));
  EXPECT_EQ(said[2], json({"#anchor", 0, 60000, 0}))
      << "the address is the host's, and so are keys but those on the Moon";
}

TEST_F(Explore, NamesOfFilesBreakNoPage) {
  const auto map = file("<!--<script> & '.png", "");
  ASSERT_EQ(
      run(words_of("oiiotool --pattern constant:color=0.2,0.2,0.2 64x32 3 -o {}", map)).status, 0);
  make("2018-07-27", words_of("--albedo-map {} --atmosphere undated", map));
  const auto said = in_browser("return page.facts.options;");
  EXPECT_SAYS(said.get<std::string>(), "<!--<script> & ");
  EXPECT_SAYS_NOT(text_of(here("a.html")), here().string())
      << "a page for all shows no folder of its maker's";
}

TEST_F(Explore, ACalendarListsItsPages) {
  const auto calendar = [](const char* from, const char* to) {
    return words_of("explore --from {} --to {} -o year --atmosphere undated", from, to);
  };
  const auto year = calendar("2025-01-01", "2025-12-31");
  const auto outcome = coppermoon(year);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(listing(),
            (std::set<std::string>{"here/year", "here/year/index.html", "here/year/2025-03-14.html",
                                   "here/year/2025-09-07.html"}));
  const auto index = text_of(here("year/index.html"));
  EXPECT_SAYS(index, "<a href=\"2025-03-14.html\">2025-03-14</a></td><td>06:59</td><td>total");
  file("year/2025-09-07.html", "<p>my own</p>\n");
  EXPECT_EQ(coppermoon(year).err,
            "coppermoon: year/2025-09-07.html: is not as coppermoon wrote it, and would be "
            "overwritten; move it, or choose another folder\n");
  file("year/index.html", "<h1>my own</h1>\n");
  EXPECT_EQ(coppermoon(year).status, 1);
  EXPECT_EQ(text_of(here("year/index.html")), "<h1>my own</h1>\n");
  std::filesystem::remove(here("year/2025-09-07.html"));
  file("year/index.html", index);
  const auto again = coppermoon(calendar("2025-03-01", "2025-03-31") + Words{"--json"});
  EXPECT_EQ(again.status, 0) << "its own pages and list are made anew: " << again.err;
  const auto told = nlohmann::json::parse(again.out);
  EXPECT_EQ(told["file"], "year/index.html");
  ASSERT_EQ(told["pages"].size(), 1U);
  EXPECT_EQ(told["pages"][0]["file"], "year/2025-03-14.html");
  EXPECT_EQ(told["pages"][0]["title"], "Total eclipse of the Moon, 2025-03-14");
  const auto bytes = std::filesystem::file_size(here("year/2025-03-14.html"));
  EXPECT_EQ(told["pages"][0]["bytes"], bytes);
  EXPECT_EQ(coppermoon(calendar("2025-03-01", "2025-03-31") + Words{"--csv"}).out,
            fmt::format("file,title,bytes\nyear/2025-03-14.html,\"Total eclipse of the Moon, "
                        "2025-03-14\",{}\n",
                        bytes));
}

TEST_F(Explore, WhatIsNoPageIsRefused) {
  EXPECT_EQ(coppermoon("explore 2018-07-27 -o a.png").err,
            "coppermoon: a.png: a page ends in .html\n");
  EXPECT_EQ(coppermoon("explore -o a.html").status, 2);
  EXPECT_EQ(coppermoon("explore 2018-07-27 --from 2020-01-01 -o a.html").status, 2);
  EXPECT_EQ(coppermoon("explore --from 2020-01-01 -o a").status, 2);
  EXPECT_EQ(coppermoon("explore --from 2020-01-20 --to 2020-01-30 -o a").err,
            "coppermoon: from 2020-01-20 to 2020-01-30: no eclipse of the Moon\n");
  EXPECT_EQ(listing(), std::set<std::string>{});
}

}  // namespace coppermoon::end_to_end::explore_test
