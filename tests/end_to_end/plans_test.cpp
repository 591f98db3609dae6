// SPDX-License-Identifier: MIT
// Six scenes that require different work, as examples/plans.sh has them.
#include <nlohmann/json.hpp>

#include "support/program.h"

namespace coppermoon::end_to_end::plans_test {

using nlohmann::json;

const Words penumbral{"2009-02-09T12:40:00Z"}, deep{"2011-06-15T20:13:00Z"},
    volcanic{"2018-07-27T20:21:45Z", "--region",
             "from-latitude=-90,to-latitude=0,stratospheric-aerosol=high"},
    alike{"2018-07-27T20:21:45Z", "--atmosphere", "clear"},
    low{"2018-07-27T20:21:45Z", "--at", "51.5,0", "--width", "450", "--height", "300"},
    preview{"2008-02-21T03:26:05Z", "--quality", "draft", "--width", "256", "--height", "256"},
    map{"2008-02-21T03:26:05Z", "--texture-width", "16384"};

class Plans : public ProgramTest {
 protected:
  /// Once for all tests of a scene.
  json plan(const Words& words) const {
    static std::map<Words, json> made;
    auto& plan = made[words];
    if (plan.is_null()) plan = json_of(Words("plan --albedo-map built-in") + words);
    return plan;
  }
};

bool computes(const json& plan, const std::string& term) {
  return plan["chosen"]["leave-out"].get<std::string>().find(term) == std::string::npos;
}

/// What was left out under a name that begins so; null: nothing was.
json left_out(const json& plan, const std::string& name) {
  for (const auto& term : plan["left_out"])
    if (term["term"].get<std::string>().starts_with(name)) return term;
  return nullptr;
}

TEST_F(Plans, OfThePenumbraAloneSendNoLightThroughTheAir) {
  const auto plan = this->plan(penumbral);
  EXPECT_FALSE(computes(plan, "refracted-light"));
  const auto term = left_out(plan, "light through the air");
  ASSERT_FALSE(term.is_null());
  EXPECT_GT(term["size"], 0);
  EXPECT_LT(term["size"], 0.01);
  EXPECT_TRUE(computes(this->plan(deep), "refracted-light"));
}

TEST_F(Plans, OfADeepEclipseHaveScatteredLight) {
  EXPECT_TRUE(computes(plan(deep), "scattered-light"));
  EXPECT_FALSE(computes(plan(penumbral), "scattered-light"));
}

TEST_F(Plans, WithoutAnyLightSendNoPhotonsAfterIt) {
  // cloud over the whole limb, and air that scatters nothing: the disc is black
  const auto plan = this->plan(
      "2010-12-21T08:19:28Z --atmosphere molecular --rayleigh off --cloud-cover 1 --tolerance 6%");
  EXPECT_FALSE(computes(plan, "scattered-light"));
  EXPECT_EQ(left_out(plan, "scattered light")["size"], 0);
  EXPECT_LE(plan["predicted"]["error"], 0.06);
  EXPECT_FALSE(plan["chosen"].contains("photons")) << plan["chosen"];
}

TEST_F(Plans, ThatAreNotToBeHadSaySo) {
  const auto plan = this->plan({deep[0], "--tolerance", "0.01%"});
  EXPECT_GT(plan["predicted"]["error"], 1e-4);
  EXPECT_EQ(plan["gave_way"], "tolerance");
  EXPECT_FALSE(this->plan({deep[0]}).contains("gave_way"));
  EXPECT_EQ(this->plan({deep[0], "--budget", "1ms"})["gave_way"], "budget");
  const auto text = coppermoon(words_of("plan {} --tolerance 0.01%", deep[0]));
  EXPECT_SAYS(text.out, "not reached tolerance: 0.0");
}

TEST_F(Plans, OfAToleranceAndAQualityThatSaysAnotherAreRefused) {
  const auto refused = [&](const Words& flags, const std::string& why) {
    expect_refusal(Words{"plan", deep[0]} + flags, why);
  };
  const auto both = "tolerance = 0.1%, allowed with quality standard, not draft";
  file("both.toml", "quality = 'draft'\ntolerance = '0.1%'\n");
  file("number.toml", "tolerance = 0.1\n");
  refused("--tolerance 0.1% --quality draft", both);
  refused("--recipe both.toml", both);
  refused("--recipe number.toml", "tolerance = 0.1, allowed a percentage as 0.1%");
}

TEST_F(Plans, OfAVolcanosAirHaveRegions) {
  const auto with = plan(volcanic), without = plan({volcanic[0], "--atmosphere", "undated"});
  EXPECT_TRUE(computes(with, "regions"));
  EXPECT_FALSE(computes(without, "regions"));
  EXPECT_GT(with["predicted"]["seconds"], without["predicted"]["seconds"]);
}

TEST_F(Plans, OfALowMoonFlattenIt) {
  auto high = low;
  high[2] = "-1.29,36.82";
  EXPECT_TRUE(left_out(plan(low), "flattening").is_null());
  EXPECT_FALSE(left_out(plan(high), "flattening").is_null()) << "high over Nairobi, of 260 pixels";
}

TEST_F(Plans, OfAPreviewAreCoarseAndSmall) {
  const auto draft = plan(preview),
             standard = plan(words_of("{} --width 256 --height 256", preview[0]));
  EXPECT_LE(draft["chosen"]["rays"], standard["chosen"]["rays"]);
  EXPECT_LT(draft["chosen"]["texture-width"], standard["chosen"]["texture-width"]);
  EXPECT_GT(draft["predicted"]["error"], standard["predicted"]["error"]);
  EXPECT_LE(draft["chosen"]["texture-width"], 512);
}

TEST_F(Plans, OfAPictureHaveTheTextureThatItShows) {
  for (const char* flag : {"--focal-length", "--sensor-width"})
    EXPECT_LT(plan({preview[0], flag, "400"})["chosen"]["texture-width"], 4096) << flag;
}

TEST_F(Plans, OfALargeMapDoTheSameLightForMoreTexels) {
  const auto large = plan(map), usual = plan({map[0]});
  EXPECT_EQ(large["chosen"]["texture-width"], 16384);
  EXPECT_EQ(usual["chosen"]["texture-width"], 4096);
  EXPECT_EQ(large["chosen"]["bands"], usual["chosen"]["bands"]);
  EXPECT_EQ(large["chosen"]["rays"], usual["chosen"]["rays"]);
  EXPECT_GT(large["predicted"]["seconds"], 2 * usual["predicted"]["seconds"].get<double>());
}

TEST_F(Plans, OfSixScenesAreSixDifferentOnes) {
  std::set<std::string> different;
  for (const auto& scene : {penumbral, deep, alike, low, preview, map}) {
    const auto plan = this->plan(scene);
    std::string work;
    for (const char* knob : {"bands", "rays", "sun-terms", "planes", "leave-out", "texture-width"})
      work += plan["chosen"][knob].dump() + " ";
    different.insert(work);
  }
  EXPECT_EQ(different.size(), 6U);
}

}  // namespace coppermoon::end_to_end::plans_test
