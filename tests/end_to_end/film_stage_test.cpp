// SPDX-License-Identifier: MIT
// A film as one stage of USD. Its material is run by tests/hand_off.
#include <nlohmann/json.hpp>
#include <regex>

#include "support/program.h"
#include "texture/read_image.h"

namespace coppermoon::end_to_end::film_stage_test {

using nlohmann::json;

class FilmStage : public ProgramTest {
 protected:
  Words film(const Words& more) const {
    return Words(
               "animate 2018-07-27 --from U1 --to U4 --frames 5 --texture-width 64 --bands 20 "
               "--atmosphere undated -o film") +
           more;
  }

  std::string stage(const Words& more = {}) const {
    expect_done(coppermoon(film(Words("--make textures --stage film/eclipse.usda") + more)));
    return text_of(here("film/eclipse.usda"));
  }

  /// Numbers of an attribute's samples, frame by frame.
  static std::vector<std::vector<double>> samples(const std::string& text,
                                                  const std::string& name) {
    const auto from = text.find(name + ".timeSamples = {");
    EXPECT_NE(from, text.npos) << name;
    std::istringstream lines(text.substr(from, text.find('}', from) - from));
    std::vector<std::vector<double>> all;
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line)) {
      std::vector<double> numbers;
      const auto values = line.substr(std::min(line.find(':'), line.size() - 1) + 1);
      const std::regex number("-?[0-9.]+(e[-+][0-9]+)?");
      for (auto it = std::sregex_iterator(values.begin(), values.end(), number);
           it != std::sregex_iterator(); ++it)
        numbers.push_back(std::stod(it->str()));
      if (!numbers.empty()) all.push_back(numbers);
    }
    return all;
  }

  static double number(const std::string& text, const std::string& name) {
    std::smatch found;
    EXPECT_TRUE(std::regex_search(text, found, std::regex(name + " = (-?[0-9.e+-]+)"))) << name;
    return found.size() > 1 ? std::stod(found[1]) : std::nan("");
  }
};

TEST_F(FilmStage, StandsAmongTheTexturesWithImagesOfItsOwn) {
  const auto text = stage("--fps 23.976 --start-frame 1001");
  for (const char* file : {"eclipse_shadow.exr", "eclipse_sunlit_first_lin_rec709.exr",
                           "eclipse_sunlit_last_lin_rec709.exr", "moon_lin_rec709.1005.exr"}) {
    EXPECT_TRUE(std::filesystem::exists(here("film") / file)) << file;
    EXPECT_SAYS(text, std::string("@./") + file + "@") << file;
  }
  // importers that read no samples of a file, as Blender's, show the first frame
  EXPECT_SAYS(text, "asset inputs:file = @./moon_lin_rec709.1001.exr@");
  EXPECT_EQ(number(text, "startTimeCode"), 1001);
  EXPECT_EQ(number(text, "endTimeCode"), 1005);
  EXPECT_EQ(number(text, "timeCodesPerSecond"), 24000. / 1001);
  EXPECT_EQ(number(text, "framesPerSecond"), 24000. / 1001);
  EXPECT_EQ(texture::read_attribute(here("film/moon_lin_rec709.1005.exr"), "framesPerSecond"),
            "24000/1001");
  EXPECT_EQ(number(text, "double U1"), 1001);
  EXPECT_EQ(number(text, "double U4"), 1005);
  // Published contacts (Espenak): U1 18:24:27, U2 19:30:15, U4 22:19:00.
  EXPECT_WITHIN(number(text, "double U2"), 1001 + 4 * 65.8 / 234.55, 0.01,
                "12 s of 234 minutes in four steps: ours are within 6 s of the published");
  EXPECT_SAYS_NOT(text, "double P1") << "before the film";
}

TEST_F(FilmStage, ItsMoonlightIsThatOfBrightness) {
  const auto text = stage();
  const auto light = samples(text, "float inputs:intensity");
  ASSERT_EQ(light.size(), 5U);
  EXPECT_EQ(number(text, "float inputs:intensity"), light[0][0]) << "without a time: the first";
  const std::vector<std::string> files{"film/moon_lin_rec709.0001.exr",
                                       "film/moon_lin_rec709.0003.exr"};
  for (const std::size_t frame : {0U, 2U}) {
    const auto listed = coppermoon(words_of("brightness {} --json --bands 20", files[frame / 2]));
    const auto lux = json::parse(listed.out)["illuminance_lx"].get<double>();
    EXPECT_WITHIN(light[frame][0], lux, 0.01 * lux, "as stated: lux on a white card within 1 %");
  }
  EXPECT_LT(light[2][0], 1e-3 * light[0][0]) << "totality, or all were alike";
}

using FilmStageThoroughly = FilmStage;

TEST_F(FilmStageThoroughly, ItsCameraLooksAtTheMoonFromWhereTheObserverIs) {
  const auto text = stage("--at Nairobi --field 0.8 --width 300 --height 200");
  EXPECT_WITHIN(number(text, "float horizontalAperture") / number(text, "float focalLength") / 2,
                std::tan(0.4 * std::numbers::pi / 180), 1e-7, "seven digits");
  EXPECT_WITHIN(number(text, "float verticalAperture"), 24, 1e-9, "two thirds of 36");
  const auto cameras = samples(text.substr(text.find("def Camera")), "matrix4d xformOp:transform");
  ASSERT_EQ(cameras.size(), 5U);
  const auto listed = coppermoon("sky film/moon_lin_rec709.0003.exr --at Nairobi --json");
  const auto sky = json::parse(listed.out);
  const auto& m = cameras[2];  // rows of a matrix: right, up, back, place
  const double distance = std::hypot(m[12], m[13], m[14]);
  EXPECT_WITHIN(distance * 1737.4, sky["observer_moon_distance_km"].get<double>(), 1.,
                "six digits");
  const double radian = 180 / std::numbers::pi;
  EXPECT_WITHIN(std::asin(m[13] / distance) * radian,
                sky["sub_observer_latitude_deg"].get<double>(), 1e-4, "Y is north; six digits");
  EXPECT_WITHIN(std::atan2(m[12], m[14]) * radian, sky["sub_observer_longitude_deg"].get<double>(),
                1e-4, "Z is longitude 0, X 90 degrees east");
  for (int k = 0; k < 3; ++k)
    EXPECT_WITHIN(m[8 + static_cast<std::size_t>(k)],
                  m[12 + static_cast<std::size_t>(k)] / distance, 1e-6,
                  "it looks along -Z at the Moon's centre");
}

TEST_F(FilmStage, SaysWhatItCannotBeMadeOf) {
  expect_refused(film("--make textures --stage film/a.usd"), "film/a.usd: a stage ends in .usda");
  expect_refused(film("--make textures --stage a.usda"), "allowed in the folder of its textures");
  expect_refused(film("--make textures --space lin_ciexyzd65_scene --stage film/a.usda"),
                 "allowed in lin_rec709 or acescg");
  expect_refused(film("--make textures --shard 1/2 --stage film/a.usda"),
                 "--stage needs every frame");
  EXPECT_TRUE(listing().empty());
}

}  // namespace coppermoon::end_to_end::film_stage_test
