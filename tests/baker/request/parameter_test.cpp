// SPDX-License-Identifier: MIT
#include "request/parameter.h"
#include "support/testing.h"

namespace coppermoon::request::parameter_test {

/// A request with a lamp, whose brightness counts where the lamp is lit, and a file of a picture.
struct Fields {
  double step_km = 1;
  std::optional<double> brightness{};
  std::string lamp = "off", output;
  bool dark = false;
  Parameters parameters;

  Fields() {
    parameters.add(parameter("step-km", step_km, "step of a path [km], 0.001 to 100"))
        .within(0.001, 100);
    parameters.add(parameter("brightness", brightness, "brightness [cd/m2], 0 to 10"))
        .within(0, 10)
        .not_beside({{"dark"}})
        .only_with({{"lamp", {"candle", "oil"}}, {"output", {".png"}}});
    parameters
        .add(choice("lamp", lamp, {{"off", "off"}, {"candle", "candle"}, {"oil", "oil"}}, "lamp"))
        .not_beside({{"dark"}}, {"oil"});
    parameters.add(parameter("output", output, "file"));
    parameters.add(presence("dark", dark, "no light at all"));
  }

  void take(const char* name, const char* text) { parameters.find(name)->take({text}); }

  Texts said() const {
    return without_effect(
        parameters, [](const Parameter& each) { return "--" + each.name; },
        [](const Parameter&) { return true; });
  }
};

std::string refusal(const char* name, const char* text) {
  Fields fields;
  const auto said = refusal_of([&] { fields.take(name, text); });
  EXPECT_TRUE(said.empty() || !fields.parameters.find(name)->given) << "it is not taken";
  return said;
}

TEST(Parameter, RefusesANumberOutsideItsRangeWhenItIsTaken) {
  EXPECT_EQ(refusal("step-km", "-5"), "step [km] = -5, allowed 0.001 to 100");
  EXPECT_EQ(refusal("step-km", "nan"), "step [km] = nan, allowed 0.001 to 100");
  EXPECT_EQ(refusal("brightness", "inf"), "brightness [cd/m2] = inf, allowed 0 to 10");
  EXPECT_EQ(refusal("step-km", "100"), "");
}

TEST(WithoutEffect, IsSilentOfWhatNobodyGave) { EXPECT_EQ(Fields().said(), Texts{}); }

TEST(WithoutEffect, NamesWhatIsMissing) {
  Fields fields;
  fields.take("brightness", "3");
  EXPECT_EQ(fields.said(),
            Texts{"--brightness: no effect without --lamp candle or oil or --output .png"});
  fields.take("output", "moon.png");
  EXPECT_EQ(fields.said(), Texts{}) << "an ending counts";
  fields.take("output", "moon.exr");
  fields.take("lamp", "oil");
  EXPECT_EQ(fields.said(), Texts{});
}

TEST(WithoutEffect, NamesWhatStandsInTheWayOnceForAll) {
  Fields fields;
  fields.take("lamp", "oil");
  fields.take("brightness", "3");
  fields.take("dark", "true");
  EXPECT_EQ(fields.said(), Texts{"--brightness, --lamp: no effect beside --dark"});
  fields.take("lamp", "candle");
  EXPECT_EQ(fields.said(), Texts{"--brightness: no effect beside --dark"}) << "of oil alone";
}

TEST(WithoutEffect, PassesOverParametersThatTheCommandHasNot) {
  double number = 0;
  Parameters parameters;
  parameters.add(parameter("brightness", number, "brightness"))
      .only_with({{"lamp"}})
      .not_beside({{"dark"}});
  parameters.begin()->take({"1"});
  const auto said = [&] {
    return without_effect(
        parameters, [](const Parameter& each) { return each.name; },
        [](const Parameter&) { return true; });
  };
  EXPECT_EQ(said(), Texts{});
  parameters.begin()->only_with({});
  EXPECT_EQ(said(), Texts{"brightness: no effect in this command"});
}

}  // namespace coppermoon::request::parameter_test
