// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <cstring>

#include "support/testing.h"
#include "uses/light/light_parameters.h"

namespace coppermoon::uses::light_parameters_test {

Effort toleranced(const char* text) { return {.tolerance = text}; }
Effort budgeted(const char* text) { return {.budget = text}; }

constexpr const char* rounding = "a decimal times a hundredth or a thousandth";

TEST(WishOf, ReadsATolerancePerHundred) {
  EXPECT_WITHIN(*wish_of(toleranced("1%")).tolerance, 0.01, 1e-17, rounding);
  EXPECT_WITHIN(*wish_of(toleranced("0.05%")).tolerance, 5e-4, 1e-18, rounding);
  EXPECT_WITHIN(*wish_of(toleranced("1e-1%")).tolerance, 1e-3, 1e-18, rounding);
  EXPECT_WITHIN(*wish_of(toleranced("0.01%")).tolerance, 1e-4, 0, "the finest");
}

TEST(WishOf, RefusesATolerancePerHundredOutOfRange) {
  for (const char* text : {"60%", "0.009%", "-1%"})
    EXPECT_EQ(
        refusal_of([&] { wish_of(toleranced(text)); }),
        "tolerance [%] = " + std::string(text, std::strlen(text) - 1) + ", allowed 0.01 to 50");
}

TEST(WishOf, RefusesAToleranceWithAQualityThatSaysAnother) {
  for (const char* quality : {"draft", "reference", "paper"}) {
    auto options = toleranced("0.1%");
    options.quality = quality;
    EXPECT_EQ(refusal_of([&] { wish_of(options); }),
              "tolerance = 0.1%, allowed with quality standard, not " + std::string(quality));
  }
}

TEST(WishOf, ReadsABudgetInSecondsUnlessItSaysOtherwise) {
  for (const char* text : {"500ms", "0.5s", "0.5", "5e-1", "0.5e3ms"})
    EXPECT_WITHIN(*wish_of(budgeted(text)).budget_s, 0.5, 1e-15, rounding) << text;
  EXPECT_WITHIN(*wish_of(budgeted("2min")).budget_s, 120, 1e-12, rounding);
}

TEST(WishOf, RefusesOtherWordsInOneLineThatNamesThem) {
  for (const char* text : {"", "%", "fine", "0.1", "1 percent", "1%%", "one%", "1s"}) {
    const auto error = refusal_of([&] { wish_of(toleranced(text)); });
    EXPECT_EQ(error, "tolerance = " + std::string(text) + ", allowed a percentage as 0.1%");
  }
  for (const char* text : {"", "s", "soon", "2h", "1%", "2 s s", "ms"}) {
    const auto error = refusal_of([&] { wish_of(budgeted(text)); });
    EXPECT_EQ(error, "budget = " + std::string(text) + ", allowed a time as 500ms, 2s or 1min");
  }
}

TEST(WishOf, IsTheQualitysUnlessToleranceOrBudgetAreGiven) {
  const auto tolerance = [](const char* quality) {
    return *wish_of(Effort{.quality = quality}).tolerance;
  };
  EXPECT_EQ(tolerance("draft"), 0.05);
  EXPECT_EQ(tolerance("standard"), 0.01);
  EXPECT_EQ(tolerance("reference"), 5e-4);
  EXPECT_FALSE(wish_of(toleranced("1%")).budget_s);
  EXPECT_FALSE(wish_of(budgeted("2s")).tolerance) << "the best that time allows, not standard";
}

/// Knobs that texts give, as a command line or a recipe would.
plan::ByHand knobs(const std::vector<std::pair<const char*, const char*>>& given) {
  plan::ByHand hand;
  request::Parameters all;
  describe_knobs(all, hand);
  for (const auto& [name, text] : given) all.find(name)->take({text});
  require_knobs(hand);
  return hand;
}

TEST(Knobs, AreWhatTheTextsSay) {
  const auto none = knobs({});
  EXPECT_FALSE(none.bands || none.rays || none.sun_terms || none.planes || none.place_error ||
               none.terms || none.solver != Solver::automatic || none.photons);
  const auto hand = knobs({{"bands", "40"},
                           {"rays", "500"},
                           {"sun-terms", "3"},
                           {"planes", "5"},
                           {"place-error", "1e-3"}});
  EXPECT_EQ(hand.bands, 40);
  EXPECT_EQ(hand.rays, 500);
  EXPECT_EQ(hand.sun_terms, 3);
  EXPECT_EQ(hand.planes, 5);
  EXPECT_EQ(hand.place_error, 1e-3);
}

TEST(Knobs, AreRefusedOutsideTheirRanges) {
  plan::ByHand hand;
  request::Parameters all;
  describe_knobs(all, hand);
  int ranges = 0;
  for (const auto& knob : all) {
    if (!knob.range) continue;
    ++ranges;
    const auto text = [&](double value) { return fmt::format("{}", value); };
    const bool whole = knob.kind == request::Kind::whole;
    const auto [low, high] = *knob.range;
    for (const double allowed : {low, high})
      EXPECT_NO_THROW(knobs({{knob.name.c_str(), text(allowed).c_str()}})) << knob.name;
    for (const double outside : {whole ? low - 1 : 0.9 * low, whole ? high + 1 : 1.1 * high, -1.})
      EXPECT_THROW(knobs({{knob.name.c_str(), text(outside).c_str()}}), algebra::Error)
          << knob.name << " " << outside;
  }
  EXPECT_EQ(ranges, 5);
  const auto error = refusal_of([] { knobs({{"bands", "401"}}); });
  for (const char* part : {"bands", "401", "400"}) EXPECT_SAYS(error, part);
}

plan::Work without(const std::string& words) {
  return *knobs({{"leave-out", words.c_str()}}).terms;
}

TEST(LeaveOut, SwitchesOffWhatItNamesAndNothingElse) {
  const auto some = without("ellipsoid,scattered-light");
  EXPECT_TRUE(some.refracted && some.regions);
  EXPECT_FALSE(some.ellipsoid || some.scattered_light);
  EXPECT_FALSE(without("refracted-light").refracted);
  EXPECT_FALSE(without("regions").regions);
}

TEST(LeaveOut, OfNoneKeepsAllTermsWhateverTheirSize) {
  const auto all = without("none");
  EXPECT_TRUE(all.refracted && all.ellipsoid && all.regions && all.scattered_light);
}

TEST(LeaveOut, RefusesOtherWordsAndSaysWhichThereAre) {
  for (const char* words : {"elipsoid", "ellipsoid,moon", "ellipsoid, regions", "none,regions"})
    EXPECT_EQ(refusal_of([&] { without(words); }),
              "leave-out = " + std::string(words) +
                  ", allowed none or refracted-light, ellipsoid, regions, scattered-light, with "
                  "commas between");
}

/// Knobs that a recipe gives.
plan::ByHand knobs_in(const request::Recipe& recipe) {
  plan::ByHand hand;
  request::Parameters all;
  describe_knobs(all, hand);
  for (auto& knob : all)
    if (const auto* setting = setting_in(recipe, knob.name)) knob.take(setting->texts);
  return hand;
}

const plan::Work planned{.regions = false,
                         .scattered_light = true,
                         .bands = 40,
                         .rays = 300,
                         .sun_terms = 2,
                         .planes = 3,
                         .place_error = 3e-4};

const auto asked = request::recipe_in(
    "instant = '2008-02-21'\ntolerance = '1%'\nbudget = '2s'\nbands = 7\nphotons = 5\n"
    "quality = 'draft'\n\n[atmosphere]\nmodel = 'clear'\n\n[[atmosphere.region]]\n"
    "from-latitude = -90\nto-latitude = 0\n");

TEST(WithWork, ComesBackAsTheSameWork) {
  const auto hand = knobs_in(with_work(asked, planned));
  EXPECT_EQ(hand.bands, planned.bands);
  EXPECT_EQ(hand.rays, planned.rays);
  EXPECT_EQ(hand.sun_terms, planned.sun_terms);
  EXPECT_EQ(hand.planes, planned.planes);
  EXPECT_EQ(hand.place_error, planned.place_error);
  for (const auto term : {&plan::Work::refracted, &plan::Work::ellipsoid, &plan::Work::regions,
                          &plan::Work::scattered_light})
    EXPECT_EQ((*hand.terms).*term, planned.*term);
}

TEST(WithWork, TakesThePlaceOfWhatWasAskedFor) {
  const auto recipe = text_of(with_work(asked, planned));
  for (const char* gone : {"tolerance", "budget", "bands = 7", "photons"})
    EXPECT_SAYS_NOT(recipe, gone);
  for (const char* kept :
       {"instant = '2008-02-21'\n", "quality = 'draft'\n", "\n[[atmosphere.region]]\n"})
    EXPECT_SAYS(recipe, kept);
}

TEST(WithWork, DoneTwiceIsDoneOnce) {
  const auto once = with_work(asked, planned);
  EXPECT_EQ(text_of(with_work(once, planned)), text_of(once));
}

TEST(WithWork, SaysHowManyPhotonsWhereThereAreAny) {
  auto work = planned;
  EXPECT_EQ(setting_in(with_work(asked, work), "solver")->texts, request::Texts{"quadrature"});
  work.solver = plan::Solver::table, work.photons = 2048;
  const auto recipe = text_of(with_work(asked, work));
  EXPECT_SAYS(recipe, "solver = 'photons'\nphotons = 2048\n");
}

using Given = std::vector<std::pair<const char*, const char*>>;

std::string air_with(const Given& given) {
  LightRequest light;
  request::Parameters all;
  describe(all, light.air);
  describe_sunlight(all, light);
  for (const auto& [name, text] : given) all.find(name)->take({text});
  return air_in_words(all);
}

TEST(AirInWords, NamesWhatIsNotAsUsualAndNothingElse) {
  EXPECT_EQ(air_with({}), "standard air");
  EXPECT_EQ(
      air_with({{"atmosphere", "standard"}, {"refraction", "on"}, {"scattered-light", "auto"}}),
      "standard air");
  EXPECT_EQ(air_with({{"atmosphere", "none"}}), "no air");
  EXPECT_EQ(air_with({{"stratospheric-aerosol", "high"}, {"stratospheric-aerosol", "extreme"}}),
            "standard air, stratospheric aerosol extreme");
  EXPECT_EQ(air_with({{"atmosphere", "undated"},
                      {"ozone-du", "300"},
                      {"cloud-top-km", "4"},
                      {"refraction", "off"}}),
            "undated air, refraction off, ozone 300 DU, cloud top 4 km");
  EXPECT_EQ(air_with({{"region", "from-latitude=-90,to-latitude=0,dust-extinction=1e-5"}}),
            "standard air, 1 region");
}

}  // namespace coppermoon::uses::light_parameters_test
