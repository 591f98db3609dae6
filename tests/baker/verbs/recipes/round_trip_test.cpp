// SPDX-License-Identifier: MIT
// A recipe of any command, with every parameter away from its default, comes back as the same request.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include "algebra/error.h"
#include "algebra/random.h"
#include "verbs/command_line.h"
#include "verbs/recipes/recipe_file.h"

namespace coppermoon::verbs::round_trip_test {

using request::Kind, request::Parameter, request::Texts;

/// Values of parameters that are texts, by name; two of each, where there are two.
const std::map<std::string, Texts>& texts_by_name() {
  static const std::map<std::string, Texts> all{
      {"aim", {"12,180", "-3.5,90.25"}},
      {"albedo-map", {"it's a \"map\".tif", "#x.png", "true", "12"}},
      {"at", {"1.5,103.75", "Nairobi", "-33.9,18.4,1000"}},
      {"axis-distances", {"0,2000", "4700"}},
      {"budget", {"2s", "500ms"}},
      {"camera", {"refractor", "400mm"}},
      {"config", {"mine.ocio"}},
      {"config-space", {"ACEScg"}},
      {"display", {"Rec.1886 Rec.709 - Display"}},
      {"duration", {"10s", "2min"}},
      {"eclipse", {"2018-07-27", "2026-03-03"}},
      {"exposure", {"exif"}},
      {"feature", {"Tycho", "-43.3,-11.4"}},
      {"field", {"moon", "2", "0.75"}},
      {"fps", {"24000/1001", "25", "23.976"}},
      {"from", {"U1", "U2-10min", "2018-07-27T19:00Z"}},
      {"glow", {"auto", "0.3"}},
      {"instant", {"2018-07-27T20:21:45Z", "2018-07-27 U2+10min"}},
      {"instants", {"from-header", "2018-07-27T20:00Z,2018-07-27T21:00Z"}},
      {"isos", {"100,200"}},
      {"leave-out", {"ellipsoid,regions", "none"}},
      {"magnitudes", {"night.csv"}},
      {"moments", {"U1,U2+5min,greatest"}},
      {"on", {"Tycho", "-43.3,-11.4"}},
      {"recipe-in", {"moon.exr"}},
      {"region",
       {"from-latitude=-90,to-latitude=0,cloud-cover=1",
        "from-position-angle=330,to-position-angle=30,stratospheric-aerosol=high"}},
      {"render", {"frame.exr"}},
      {"response", {"luminance", "canon-300d"}},
      {"scene", {"mine.pov"}},
      {"shutter", {"1/30"}},
      {"sky", {"auto", "off", "12.5"}},
      {"space", {"acescg", "lin_ciexyzd65_scene"}},
      {"stars", {"off", "4"}},
      {"stratospheric-aerosol", {"extreme", "none", "0.1"}},
      {"time", {"2", "1/30", "follow"}},
      {"times", {"1/30,2"}},
      {"to", {"U4", "greatest+1.5h"}},
      {"tolerance", {"0.2%", "3%"}},
      {"view", {"Filmic", "Raw"}},
      {"wavelengths", {"550", "450,550,650"}},
      {"zone", {"local", "Europe/Berlin"}}};
  return all;
}

/// Values of a parameter, from which one is drawn; of numbers one in its range, at random.
Texts values_of(const Parameter& parameter, algebra::Random& random) {
  if (const auto found = texts_by_name().find(parameter.name); found != texts_by_name().end())
    return found->second;
  if (parameter.kind == Kind::presence) return {"true"};
  if (!parameter.words.empty()) return parameter.words;
  const auto [low, high] = parameter.range.value_or(request::Range{0, 1e6});
  const double value = low + (high - low) * random.uniform();
  if (parameter.kind == Kind::number) return {request::text_of(value)};
  if (is_number(parameter.kind)) return {request::text_of(static_cast<int>(std::min(value, 2e9)))};
  return {};
}

/// Gives a parameter a value other than its default; two of one that may be given again.
///
/// Returned  whether it has one
bool give(Parameter& parameter, algebra::Random& random) {
  Texts given;
  for (int tries = 0; tries < 50 && given.size() < (parameter.many ? 2U : 1U); ++tries) {
    const auto values = values_of(parameter, random);
    if (values.empty()) return false;
    const auto& text = values[static_cast<std::size_t>(random.uniform() * double(values.size()))];
    try {
      parameter.take({text});
      if (parameter.text() != parameter.usual) given.push_back(text);
    } catch (const algebra::Error&) {  // not allowed, as an odd width
    }
  }
  if (!given.empty()) parameter.take(given);
  return !given.empty();
}

/// What fields hold, by the names of their parameters.
std::map<std::string, Texts> request_of(const Verb& verb) {
  std::map<std::string, Texts> all;
  for (const auto& parameter : verb.parameters)
    if (in_recipes(parameter)) all[parameter.name] = parameter.read();
  return all;
}

TEST(RecipeOfEveryParameter, ComesBackAsTheSameRequest) {
  const auto path = testing::TempDir() + "round_trip_" + std::to_string(::getpid()) + ".toml";
  std::set<std::string> without_value;
  for (std::uint64_t draw = 0; draw < 20; ++draw) {
    Program first, second;
    add_verbs(first);
    add_verbs(second);
    for (auto& verb : first.verbs) {
      algebra::Random random(66, 100 * draw + verb.parameters.size());
      for (auto& parameter : verb.parameters)
        if (in_recipes(parameter) && !give(parameter, random))
          without_value.insert(verb.name + " " + parameter.name);
      const auto recipe = recipe_of(verb);
      std::ofstream(path) << recipe;
      auto& again = *find_verb(second, verb.name);
      ASSERT_NO_THROW(take_recipe(again, path)) << verb.name << "\n" << recipe;
      EXPECT_EQ(recipe_of(again), recipe) << verb.name;
      EXPECT_EQ(request_of(again), request_of(verb)) << verb.name << "\n" << recipe;
    }
  }
  std::filesystem::remove(path);
  EXPECT_EQ(without_value, std::set<std::string>{}) << "give them values in texts_by_name";
}

}  // namespace coppermoon::verbs::round_trip_test
