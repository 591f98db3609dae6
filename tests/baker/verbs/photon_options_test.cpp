// SPDX-License-Identifier: MIT
#include "verbs/photon_options.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <filesystem>

#include "algebra/error.h"
#include "support/within.h"
#include "verbs/light_options.h"

namespace coppermoon::verbs {
namespace {

const shadow::Arrangement february_2008{1.479e11, {3.83e8}};
const std::vector<double> waves{500, 650};

shadow::RefractedLight light(const PhotonOptions& options) {
  shadow::PhotonSettings settings;
  settings.photons = 50'000;
  settings.trace = shadow::Trace::table;
  settings.ring_width_m = 500e3;
  return light_of_photons(options, {}, february_2008, waves, settings, {});
}

class PhotonFiles : public testing::Test {
 protected:
  PhotonFiles() { std::filesystem::create_directory(folder); }
  ~PhotonFiles() override { std::filesystem::remove_all(folder); }

  std::string file(const std::string& name) const { return (folder / name).string(); }

  std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("photon_options_" + std::to_string(getpid()));
};

TEST_F(PhotonFiles, OfThreeShardsMakeTheLightOfOneRun) {
  PhotonOptions all;
  for (const std::string part : {"1", "2", "3"}) {
    EXPECT_LT(light({part + "/3", file(part), {}, {}}).photons, 18'000U);
    all.add.push_back(file(part));
  }
  const auto together = light(all), whole = light({});
  EXPECT_EQ(together.photons, whole.photons);
  for (std::size_t i = 0; i < whole.ratio[0].values().size(); ++i)
    EXPECT_WITHIN_RELATIVE(together.ratio[0].values()[i], whole.ratio[0].values()[i], 1e-12,
                           "rounding of sums in another order");
}

TEST_F(PhotonFiles, OfTheSamePhotonsAreRefused) {
  light({"1/3", file("one"), {}, {}});
  EXPECT_THROW(light({"", "", {file("one"), file("one")}, {}}), algebra::Error);
}

TEST_F(PhotonFiles, OfAnotherSceneAreRefused) {
  light({"1/3", file("one"), {}, [] { return std::string("its air"); }});
  EXPECT_THROW(light({"", "", {file("one")}, [] { return std::string("other air"); }}),
               algebra::Error);
}

TEST(PhotonOptions, RefuseAShardThatIsNone) {
  for (const std::string shard : {"3", "a/b", "0/3", "4/3", "1/0", "-1/3", "/", "1/2/3"})
    EXPECT_THROW(light({shard, "", {}, {}}), algebra::Error) << shard;
}

TEST(PhotonOptions, HaveAKeyThatKnowsTheAirAndNotTheNumber) {
  const auto key = [](const std::string& flags) {
    CLI::App verb;
    LightOptions options;
    add_light_options(verb, options);
    verb.parse(flags);
    return options.photon_files.key();
  };
  const auto usual = key("");
  EXPECT_EQ(key("--photons 5 --shard 1/3 --keep a --add b --add c --starlight on"), usual);
  for (const std::string other : {"--ozone-du 300", "--seed 2", "--rays 99", "--trace each",
                                  "--trace marched", "--precision single", "--step-km 3",
                                  "--ring-km 7", "--limb-darkening off", "--atmosphere paper"})
    EXPECT_NE(key(other), usual) << other;
}

}  // namespace
}  // namespace coppermoon::verbs
