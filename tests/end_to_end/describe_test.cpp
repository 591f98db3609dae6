// SPDX-License-Identifier: MIT
// Other programs rely on what `describe --json` says of parameters; the library keeps the ranges that it tells.
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <regex>

#include "support/program.h"

namespace coppermoon::end_to_end::describe_test {

using nlohmann::json;
using Names = std::set<std::string>;

constexpr const char* eclipsed = "2018-07-27T20:21:45Z";

class Describe : public ProgramTest {
 protected:
  json commands(const Words& chosen = {}) const {
    return json_of(Words("describe") + chosen).at("commands");
  }

  /// Parameters and parts of all commands, each name once.
  std::map<std::string, json> parameters() const {
    std::map<std::string, json> all;
    for (const auto& command : commands())
      for (const auto& parameter : command["parameters"]) {
        all.emplace(parameter["name"], parameter);
        if (parameter.contains("parts"))
          for (const auto& part : parameter["parts"]) all.emplace(part["name"], part);
      }
    return all;
  }
};

TEST_F(Describe, HasEachCommandInTheOrderOfHelp) {
  const auto help = coppermoon({"--help"}).out;
  std::size_t at = 0;
  const auto all = commands();
  EXPECT_EQ(all.size(), 21U);
  for (const auto& command : all) {
    const auto next = help.find("\n  " + command["name"].get<std::string>() + " ", at);
    ASSERT_NE(next, std::string::npos) << command["name"];
    at = next;
    EXPECT_SAYS(help, command["meaning"].get<std::string>().substr(0, 20));
  }
}

TEST_F(Describe, SaysTheSameFieldsOfEachParameter) {
  const Names kinds{"number", "whole",    "natural",   "word",         "on-off",
                    "text",   "presence", "file-read", "file-written", "folder-written"},
      affected{"photons", "light", "ground", "sight", "frame", "picture", "share", "run"};
  for (const auto& [name, parameter] : parameters()) {
    for (const char* field : {"name", "kind", "many", "required", "recipe", "affects", "meaning"})
      EXPECT_TRUE(parameter.contains(field)) << name << " without " << field;
    EXPECT_TRUE(kinds.contains(parameter["kind"])) << parameter;
    EXPECT_TRUE(affected.contains(parameter["affects"])) << parameter;
    EXPECT_EQ(parameter["recipe"],
              parameter["affects"] != "run" && parameter["affects"] != "share");
    if (parameter["kind"] == "word" || parameter["kind"] == "on-off") {
      EXPECT_TRUE(parameter.contains("words")) << parameter;
    }
    if (parameter.contains("range")) {
      EXPECT_LT(parameter["range"][0], parameter["range"][1]) << name;
    }
  }
}

TEST_F(Describe, SaysWhatAReaderOfTheFlagKnows) {
  const auto all = parameters();
  EXPECT_EQ(all.at("ozone-du"),
            json::parse(R"({"name": "ozone-du", "kind": "number", "unit": "DU", "range": [0, 1000],
                            "many": false, "required": false, "heading": "The Earth's air",
                            "recipe": true, "table": "atmosphere", "affects": "photons",
                            "effect": [{"not_beside": [{"name": "atmosphere", "values": ["none"]}]},
                                       {"not_beside": [{"name": "unshadowed"}]}],
                            "meaning": "vertical column of ozone [DU], 0 to 1000"})"));
  EXPECT_EQ(all.at("earth")["words"], json({"sphere", "ellipsoid"}));
  EXPECT_EQ(all.at("width")["default"], 1500);
  EXPECT_EQ(all.at("quality")["default"], "standard");
  EXPECT_EQ(all.at("output")["required"], true);
  EXPECT_EQ(all.at("albedo-map")["kind"], "file-read");
  Names parts;
  for (const auto& part : all.at("region")["parts"]) parts.insert(part["name"]);
  for (const char* part : {"from-latitude", "to-position-angle", "ozone-du", "cirrus"})
    EXPECT_TRUE(parts.contains(part)) << part;
}

TEST_F(Describe, OfOneCommandIsThatOfAll) {
  const auto one = commands({"night"});
  ASSERT_EQ(one.size(), 1U);
  for (const auto& command : commands())
    if (command["name"] == "night") {
      EXPECT_EQ(command, one[0]);
    }
  const auto refused = coppermoon("describe eclipse");
  EXPECT_EQ(refused.status, 2);
  EXPECT_EQ(std::ranges::count(refused.err, '\n'), 1);
}

TEST_F(Describe, WithoutJsonIsATable) {
  const auto outcome = coppermoon("describe bake");
  expect_done(outcome);
  for (const char* row :
       {"bake\n", "  ozone-du                 photons  -              0 to 1000 DU\n",
        "    from-latitude          photons  -              -90 to 90 degrees\n",
        "  quality                  light    standard       draft, standard, "})
    EXPECT_SAYS(outcome.out, row) << row << outcome.out;
}

TEST_F(Describe, MeaningsTellTheRange) {
  static const std::regex number("-?[0-9][0-9.]*(e[-+]?[0-9]+)?");
  for (const auto& [name, parameter] : parameters()) {
    const std::string meaning = parameter["meaning"];
    std::set<double> told;
    for (std::sregex_iterator found(meaning.begin(), meaning.end(), number), end; found != end;
         ++found)
      told.insert(std::stod(found->str()));
    if (!parameter.contains("range")) continue;
    for (const auto& end : parameter["range"])
      EXPECT_TRUE(told.contains(end.get<double>())) << name << " to " << end << ": " << meaning;
  }
}

/// Command lines that do little, and read all that is asked of them.
class Ranges : public Describe {
 protected:
  const Words air = "--atmosphere molecular", small{"--width", "8", "--height", "8"};

  void SetUp() override { expect_done(coppermoon(still() + "--frame frame.exr")); }

  Words still() const {
    return words_of("still {} --texture-width 16 --tolerance 50% -o still.png", eclipsed) + air +
           small;
  }

  Words shadow() const {
    return words_of("shadow {} --axis-distances 0 --wavelengths 550", eclipsed) + air;
  }

  /// The command line that one parameter's value is put behind.
  Words command_for(const std::string& name, bool end) const {
    static const Names of_camera{
        "aperture",  "obstruction",        "transmission", "seeing",      "pixel",
        "full-well", "quantum-efficiency", "read-noise",   "sensor-bits", "f-number",
        "iso",       "converter-noise"},
        of_photons{"ring-km", "smoothing-km"},
        of_still{"albedo-exponent", "focal-length", "sensor-width"},
        of_shadow{"moon-distance-km", "sun-distance-km", "position-angle"};
    if (name == "black-level")
      return {"develop",       "frame.exr", "--camera", "refractor",
              "--sensor-bits", "16",        "-o",       "picture.png"};
    if (name == "sensor-bits")
      return {"develop",       "frame.exr", "--camera", "refractor",
              "--black-level", "0",         "-o",       "picture.png"};
    if (of_camera.contains(name))
      return {"develop", "frame.exr", "--camera", "refractor", "-o", "picture.png"};
    if (name == "step-km")  // without air no step is taken, which would be ten million at the least
      return words_of(
          "shadow {} --axis-distances 0 --wavelengths 550 --atmosphere none --solver literal "
          "--photons 1",
          eclipsed);
    if (of_photons.contains(name)) return shadow() + "--solver photons --photons 1";
    if (of_still.contains(name)) return still();
    if (name.starts_with("observer")) return still() + "--at Nairobi";
    if (!end && (name == "width" || name == "height")) return still();
    if (of_shadow.contains(name)) return shadow() + "--rays 20";
    if (name == "scale") return words_of("ring {} -o ring.exr", eclipsed) + air;
    if (name == "ground-albedo")
      return words_of("dome {} --at Nairobi -o sky.exr --width 16", eclipsed) + air;
    if (name == "spectral")
      return words_of("bake {} -o moon.exr --texture-width 16 --tolerance 50%", eclipsed) + air;
    auto plan = Words{"plan", eclipsed} + air;
    if (name == "dust-top-km") plan = plan + Words{"--dust-bottom-km=0"};
    if (name == "dust-bottom-km") plan = plan + Words{"--dust-top-km=86"};
    return plan;
  }

  Outcome with(const std::string& name, double value, bool end) const {
    const auto text = fmt::format("{}", value);
    if (name.find("-latitude") != std::string::npos ||
        name.find("-position-angle") != std::string::npos) {
      const bool from = name.starts_with("from-");
      auto other = name;
      other.replace(0, from ? 4 : 2, from ? "to" : "from");
      const auto edge = name.ends_with("latitude") ? (from ? 90 : -90) : 10;
      return coppermoon(Words{"plan", eclipsed} + air +
                        Words{fmt::format("--region={}={},{}={}", name, text, other, edge)});
    }
    return coppermoon(command_for(name, end) + Words{"--" + name + "=" + text});
  }
};

using RangesThoroughly = Ranges;

TEST_F(RangesThoroughly, AreThoseThatTheLibraryKeeps) {
  /// Commands that take files or long, and where the ends of their own numbers are tested.
  static const std::map<std::string, const char*> elsewhere{
      {"frames", "uses/film/film_times"},
      {"year", "end_to_end/night"},
      {"fps", "uses/film/film_times"},
      {"duration", "uses/film/film_times"},
      {"start-frame", "uses/film/film_times"},
      {"time-scale", "uses/film/film_times"},
      {"bracket", "end_to_end/film_files"},
      {"step", "end_to_end/json"},
      {"aperture", "colour/exposure: with the focal length it makes the f-number"},
      {"f-number", "colour/exposure: with the focal length it makes the aperture"},
      {"bins", "uses/compare/comparison"},
      {"exposure-error", "end_to_end/fit"},
      {"shutter-error", "end_to_end/fit"},
      {"white-balance-error", "end_to_end/fit"},
      {"clock-error", "end_to_end/fit"},
      {"weather-error", "end_to_end/fit"},
      {"limit", "end_to_end/cache"},
      {"longest", "end_to_end/tradeoff"},
      {"repeat", "end_to_end/tradeoff"}};
  for (const auto& [name, parameter] : parameters()) {
    if (!parameter.contains("range") || elsewhere.contains(name)) continue;
    const double low = parameter["range"][0], high = parameter["range"][1];
    const bool whole = parameter["kind"] != "number";
    const double beyond = name == "texture-width" ? 2 : whole ? 1 : 1e-3 * (high - low);
    for (const double end : {low, high}) {
      const auto outcome = with(name, end, true);
      EXPECT_EQ(outcome.status, 0) << name << " = " << end << ": " << outcome.err;
    }
    for (const double outside : {low - beyond, high + beyond}) {
      const auto outcome = with(name, outside, false);
      EXPECT_TRUE(outcome.status == 1 || outcome.status == 2) << name << " = " << outside;
      EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
      EXPECT_SAYS(outcome.err, fmt::format("allowed {:g} to {:g}", low, high))
          << name << " = " << outside << ": " << outcome.err;
    }
  }
}

}  // namespace coppermoon::end_to_end::describe_test
