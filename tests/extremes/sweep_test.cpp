// SPDX-License-Identifier: MIT
// Ten thousand random recipes over all that may be asked for, and a little beyond: every one ends in a valid file or in
// one clear line. A hundred tests of 100 each.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "algebra/random.h"
#include "end_to_end/program.h"
#include "extremes/tried.h"
#include "texture/read_image.h"

namespace coppermoon::extremes {
namespace {

using algebra::Random;
using end_to_end::Outcome;
using end_to_end::text_of;
namespace fs = std::filesystem;

constexpr std::uint64_t seed = 10000, recipes_a_test = 100;

double between(Random& random, double low, double high) {
  return low + (high - low) * random.uniform();
}

template <std::size_t size>
const char* one_of(Random& random, const std::array<const char*, size>& words) {
  return words[static_cast<std::size_t>(random.uniform() * static_cast<double>(size))];
}

using Value = std::function<std::string(Random&)>;

/// A number of a range: often an end of it, seldom beyond; of one that spans decades, evenly in its
/// logarithm.
Value number(double low, double high) {
  return [low, high](Random& random) {
    const double which = random.uniform();
    if (which < 0.06) return fmt::format("{}", low);
    if (which < 0.12) return fmt::format("{}", high);
    if (which < 0.13) return fmt::format("{}", low - 1 - std::abs(low));
    if (which < 0.14) return fmt::format("{}", 2 * std::abs(high) + 1);
    if (low > 0 && high > 100 * low)
      return fmt::format("{}", low * std::pow(high / low, random.uniform()));
    return fmt::format("{}", between(random, low, high));
  };
}

Value integer(double low, double high) {
  return [low, high](Random& random) {
    return fmt::format("{:.0f}", std::stod(number(low, high)(random)));
  };
}

template <typename... Words>
Value word(Words... words) {
  const std::array<const char*, sizeof...(Words)> all{words...};
  return [all](Random& random) { return fmt::format("\"{}\"", one_of(random, all)); };
}

Value on_or_off() { return word("on", "off"); }

struct Key {
  const char *name, *of;  ///< of the verbs that have it: a letter for each group
  double chance;
  Value value;
};

/// a: the air, l: how light is computed, m: the Moon, v: who looks, p: the picture.
const std::vector<Key>& keys() {
  static const std::vector<Key> all{
      {"atmosphere", "a", 0.6, word("paper", "molecular", "clear", "standard", "none")},
      {"earth", "a", 0.3, word("sphere", "ellipsoid")},
      {"density", "a", 0.2, word("us-1976", "yapo-cutler")},
      {"refraction", "a", 0.1, on_or_off()},
      {"dispersion", "a", 0.2, word("ciddor", "crc")},
      {"rayleigh", "a", 0.1, on_or_off()},
      {"king-factor", "a", 0.2, word("bates", "fixed")},
      {"ozone-path", "a", 0.2, word("bent", "filter")},
      {"danjon", "a", 0.1, integer(0, 4)},
      {"ozone-du", "a", 0.3, number(0, 1000)},
      {"tropospheric-aerosol", "a", 0.3, number(0, 10)},
      {"stratospheric-aerosol", "a", 0.3,
       word("none", "background", "moderate", "high", "extreme")},
      {"cloud-cover", "a", 0.3, number(0, 1)},
      {"cloud-top-km", "a", 0.3, number(0, 30)},
      {"dust-extinction", "a", 0.3, number(1e-9, 1)},
      {"dust-bottom-km", "a", 0.1, number(0, 30)},
      {"dust-top-km", "a", 0.1, number(0, 60)},
      {"limb-darkening", "a", 0.2, on_or_off()},
      {"scattered-light", "a", 0.2, word("auto", "on", "off")},
      {"starlight", "a", 0.2, on_or_off()},
      {"tolerance", "l", 0.9,
       [](Random& r) { return fmt::format("\"{}%\"", std::pow(10., between(r, 0, 1.69))); }},
      {"budget", "l", 0.1, word("1ms", "50ms", "0.3s", "0.01min", "1 fortnight")},
      {"bands", "l", 0.15, integer(1, 400)},
      {"rays", "l", 0.15, integer(2, 1500)},
      {"sun-terms", "l", 0.15, integer(1, 6)},
      {"planes", "l", 0.15, integer(1, 9)},
      {"place-error", "l", 0.15, number(1e-3, 1)},
      {"leave-out", "l", 0.1,
       word("none", "ellipsoid", "refracted-light", "regions,scattered-light", "the-moon")},
      {"seed", "l", 0.1, integer(0, 1e9)},
      {"step-km", "l", 0.2, number(0.3, 100)},
      {"precision", "l", 0.2, word("single", "full")},
      {"ring-km", "l", 0.2, number(10, 2000)},
      {"smoothing-km", "l", 0.2, number(0, 2000)},
      {"photometry", "m", 0.3, word("lommel-seeliger-rolo", "yapo-cutler")},
      {"albedo-map-centre", "m", 0.1, word("0", "180")},
      {"albedo-exponent", "m", 0.1, number(0.1, 10)},
      {"albedo-encoding", "m", 0.1,
       word("image", "normal-albedo", "cgi-moon-kit-2019", "cgi-moon-kit-2025")},
      {"ground", "m", 0.3, word("by-place", "mean")},
      {"at", "v", 0.5,
       [](Random& r) {
         return fmt::format("\"{},{}\"", number(-90, 90)(r), number(-180, 180)(r));
       }},
      {"focal-length", "v", 0.2, number(10, 10000)},
      {"width", "v", 1, integer(8, 64)},
      {"height", "v", 1, integer(8, 64)},
      {"up", "v", 0.3, word("celestial-north", "zenith", "moon-north")},
      {"observer-aerosol", "v", 0.2, number(0, 10)},
      {"flattening", "v", 0.2, on_or_off()},
      {"time", "p", 0.3, number(1e-6, 1e6)},
      {"iso", "p", 0.3, number(1, 1e7)},
      {"bits", "p", 0.3,
       [](Random& r) {
         return one_of(r, std::array{"8", "16", "12"});
       }},
  };
  return all;
}

/// A word of the program, the groups of its keys, and what it makes.
struct Verb {
  const char *name, *groups, *output;
  double chance;
};

constexpr std::array verbs{
    Verb{"bake", "alm", "moon.exr", 0.62},    Verb{"brightness", "alm", "", 0.1},
    Verb{"shadow", "al", "", 0.13},           Verb{"scene", "almv", "folder", 0.08},
    Verb{"still", "almvp", "moon.png", 0.04}, Verb{"plan", "almv", "", 0.03}};

/// Near the middle of an eclipse; seldom any moment.
std::string random_instant(Random& random) {
  constexpr std::array days{"1963-12-30T11:0", "1982-07-06T07:3", "1992-12-09T23:4",
                            "2000-07-16T13:5", "2004-10-28T03:0", "2007-03-03T23:2",
                            "2008-02-21T03:2", "2009-02-09T14:3", "2010-12-21T08:1",
                            "2011-06-15T20:1", "2015-09-28T02:4", "2018-07-27T20:2",
                            "2021-11-19T09:0", "2029-12-20T22:4", "2048-01-01T06:5"};
  if (random.uniform() < 0.03)
    return fmt::format("{:04.0f}-{:02.0f}-{:02.0f}T{:02.0f}:00:00Z", between(random, 1, 3000),
                       between(random, 0, 13), between(random, 0, 32), between(random, 0, 24));
  const auto minute = fmt::format("{}{:.0f}:{:02.0f}Z", one_of(random, days),
                                  between(random, -0.5, 9.4), between(random, 0, 59));
  return minute;
}

std::string random_region(Random& random) {
  std::string text = "[[atmosphere.region]]\n";
  if (random.uniform() < 0.5)
    text += fmt::format("from-latitude = {}\nto-latitude = {}\n", number(-90, 90)(random),
                        number(-90, 90)(random));
  else
    text += fmt::format("from-position-angle = {}\nto-position-angle = {}\n",
                        number(0, 360)(random), number(0, 360)(random));
  if (random.uniform() < 0.5)
    text += fmt::format("dust-extinction = {}\n", number(1e-8, 1e-3)(random));
  if (random.uniform() < 0.5) text += fmt::format("cloud-cover = {}\n", number(0, 1)(random));
  return text;
}

/// Photons in a number that a sweep has time for.
std::string random_photons(Random& random) {
  const char* trace = one_of(random, std::array{"each", "marched", "table"});
  const double most = trace == std::string("each") ? 2e3 : 2e4;
  return fmt::format("solver = \"photons\"\ntrace = \"{}\"\nphotons = {}\n", trace,
                     number(1, most)(random));
}

/// What a baked texture holds: from numbers of its own, so that all else of a recipe stays as it was.
std::string random_texture(std::uint64_t index) {
  Random random(seed + 1, index);
  std::string text;
  if (random.uniform() < 0.2)
    text += fmt::format("space = {}\n", word("acescg", "lin_ciexyzd65_scene", "srgb")(random));
  if (random.uniform() < 0.2) text += fmt::format("type = {}\n", word("half", "float")(random));
  if (random.uniform() < 0.2)
    text += fmt::format("spectral = {}\n",
                        one_of(random, std::array{"1", "7", "10", "40", "100", "400"}));
  if (random.uniform() < 0.2) text += "passes = true\n";
  return text;
}

/// A still's camera, from numbers of its own too.
std::string random_camera(std::uint64_t index) {
  static const std::vector<std::pair<const char*, Value>> keys{
      {"f-number", number(0.5, 512)},
      {"aperture", number(0.1, 1e5)},
      {"obstruction", number(0, 0.9)},
      {"transmission", number(0.01, 1)},
      {"diffraction", on_or_off()},
      {"seeing", number(0, 600)},
      {"sky", word("auto", "off", "4", "22.5", "-30", "30", "dark")},
      {"pixel", number(0.1, 1000)},
      {"quantum-efficiency", number(0.001, 1)},
      {"response",
       word("colorimetric", "luminance", "canon-300d", "canon-6d", "canon-5d3", "sony-a7r2")},
      {"full-well", number(10, 1e9)},
      {"read-noise", number(0, 1e4)},
      {"converter-noise", number(0, 1e4)},
      {"black-level", number(0, 2000)},
      {"sensor-bits", integer(1, 16)},
      {"noise", on_or_off()},
      {"noise-seed", integer(0, 1e9)},
  };
  Random random(seed + 2, index);
  if (random.uniform() < 0.3) return {};
  auto text = fmt::format("camera = {}\n",
                          word("paper", "400mm", "schmidt-cassegrain", "refractor")(random));
  for (const auto& [name, value] : keys)
    if (random.uniform() < 0.15) text += fmt::format("{} = {}\n", name, value(random));
  return text;
}

struct Recipe {
  Verb verb;
  std::string text;
};

Recipe random_recipe(std::uint64_t index) {
  Random random(seed, index);
  double which = random.uniform();
  std::size_t chosen = 0;
  while (chosen + 1 < verbs.size() && which >= verbs[chosen].chance)
    which -= verbs[chosen++].chance;
  Recipe recipe{verbs[chosen], fmt::format("instant = {}\n", random_instant(random))};
  if (recipe.verb.name == std::string("bake")) recipe.text += random_texture(index);
  if (recipe.verb.name == std::string("still")) recipe.text += random_camera(index);
  for (const auto& key : keys())
    if (std::string_view(recipe.verb.groups).find(key.of) != std::string_view::npos &&
        random.uniform() < key.chance)
      recipe.text += fmt::format("{} = {}\n", key.name, key.value(random));
  const bool moon = std::string_view(recipe.verb.groups).find('m') != std::string_view::npos;
  if (moon)
    recipe.text += "albedo-map = \"built-in\"\n" +
                   fmt::format("texture-width = {}\n", 2 * std::stoi(integer(2, 32)(random)));
  if (random.uniform() < 0.15) recipe.text += random_photons(random);
  if (recipe.text.find("\natmosphere") != std::string::npos)
    return recipe;  // either a word or a table
  while (random.uniform() < 0.4) recipe.text += random_region(random);
  return recipe;
}

class Sweep : public end_to_end::ProgramTest, public testing::WithParamInterface<int> {
 protected:
  Outcome made(const Recipe& recipe) const {
    file("recipe.toml", recipe.text);
    std::vector<std::string> words{"timeout",        "600",      COPPERMOON_PROGRAM,
                                   recipe.verb.name, "--recipe", "recipe.toml"};
    if (*recipe.verb.output != 0)
      words.insert(words.end(), {"-o", recipe.verb.output});
    else
      words.emplace_back("--json");
    return run(words, {.processor_limit = 120});
  }

  /// What is wrong with what was made; empty when nothing is.
  std::string flaw_of_file(const Verb& verb, const Outcome& outcome) const {
    if (*verb.output == 0) return nlohmann::json::accept(outcome.out) ? "" : "no JSON";
    const auto at = here(verb.output);
    if (fs::is_directory(at))
      return fs::exists(at / "eclipse.pov") && fs::exists(at / "eclipse.ini")
                 ? flaw_of_image(at / "moon_lin_rec709.exr")
                 : "an empty folder";
    return flaw_of_image(at);
  }

  static std::string flaw_of_image(const fs::path& path) {
    const auto image = texture::read_image(path);
    const bool finite = std::ranges::all_of(image.values, [](float v) { return std::isfinite(v); });
    return finite && !image.values.empty() ? "" : "values that are no numbers";
  }

  /// Standard error without the warnings that a sound recipe may have.
  static std::string without_warnings(const std::string& err) {
    std::istringstream lines(err);
    std::string rest;
    for (std::string line; std::getline(lines, line);) {
      const auto has = [&](const char* words) { return line.find(words) != std::string::npos; };
      if (!has("the tolerance cannot be reached") && !has("on Danjon's scale; the nearest is taken") &&
          !has("times as bright as the Moon, which hardly shows"))
        rest += line + '\n';
    }
    return rest;
  }

  std::string flaw_of_refusal(const Outcome& outcome) const {
    if (outcome.status != 1 && outcome.status != 2) return fmt::format("status {}", outcome.status);
    const auto said = without_warnings(outcome.err);
    if (!said.starts_with("coppermoon: ") || std::ranges::count(said, '\n') != 1)
      return "not one line";
    return listing() == std::set<std::string>{"here/recipe.toml"} ? "" : "something is left";
  }

  /// Nothing but the recipe and the output, neither of them another's.
  std::string flaw_of_folder(const Recipe& recipe) const {
    if (text_of(here("recipe.toml")) != recipe.text) return "the recipe is another";
    const auto output = std::string("here/") + recipe.verb.output;
    for (const auto& name : listing())
      if (name != "here/recipe.toml" && name != output && !name.starts_with(output + "/"))
        return name + " is left";
    return "";
  }

  void tidy(const Verb& verb) const {
    if (*verb.output != 0) fs::remove_all(here(verb.output));
  }
};

TEST_P(Sweep, EndsInAValidFileOrOneLine) {
  int files = 0, lines = 0;
  double most_mb = 0;
  const auto first = static_cast<std::uint64_t>(GetParam()) * recipes_a_test;
  for (std::uint64_t i = first; i < first + recipes_a_test; ++i) {
    const auto recipe = random_recipe(i);
    const auto outcome = made(recipe);
    const bool done = outcome.status == 0;
    auto flaw = done ? flaw_of_file(recipe.verb, outcome) : flaw_of_refusal(outcome);
    if (done && flaw.empty()) flaw = flaw_of_folder(recipe);
    if (done && !without_warnings(outcome.err).empty()) flaw = "done, with a complaint";
    EXPECT_EQ(flaw, "") << "seed " << seed << ", recipe " << i << ": " << recipe.verb.name << "\n"
                        << recipe.text << outcome.err;
    EXPECT_LT(outcome.most_memory_mb, 4000)
        << "400 bands on 9 planes, all kept, take 3700: " << seed << ", " << i << "\n"
        << recipe.text;
    most_mb = std::max(most_mb, outcome.most_memory_mb);
    if (flaw.empty()) ++(done ? files : lines);
    tidy(recipe.verb);
  }
  EXPECT_GT(files, 35) << "58 in 100 are valid: so few by chance three times in a million";
  tried(fmt::format("random recipes {} to {}", first, first + recipes_a_test - 1),
        fmt::format("{} valid files, {} refused in one line, {:.0f} MB", files, lines, most_mb));
}

INSTANTIATE_TEST_SUITE_P(TenThousand, Sweep, testing::Range(0, 100));

}  // namespace
}  // namespace coppermoon::extremes
