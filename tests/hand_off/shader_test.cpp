// SPDX-License-Identifier: MIT
// examples/shadow.mtlx, made a shader by MaterialX's own generator, finds the shadow's light.
#include "end_to_end/shadow_strip.h"

namespace coppermoon::hand_off {
namespace {

using end_to_end::ShaderTest;
using end_to_end::Strip;
using nlohmann::json;

class Shader : public ShaderTest {
 protected:
  Strip strip(const std::string& when) const {
    end_to_end::expect_done(coppermoon({"shadow", when, "--lookup", "strip.exr", "--bands", "20"}));
    return {texture::read_image(here("strip.exr")),
            json::parse(end_to_end::text_of(here("strip.json")))};
  }

  /// Its source, and its uniforms with their values.
  json generated() const {
    const auto done =
        run({"node", "generate_mtlx.mjs", COPPERMOON_TEST_DATA "/../examples/shadow.mtlx"},
            {.folder = COPPERMOON_HAND_OFF_READERS});
    EXPECT_EQ(done.status, 0) << done.err;
    return json::parse(done.out);
  }
};

TEST_F(Shader, OfMaterialXFindsTheLight) {
  auto shader = generated();
  const auto light = strip("2018-07-27T18:50:00Z");
  for (auto& [name, value] : shader["uniforms"].items())
    if (light.facts.contains(name)) value = light.facts[name];
  expect_shaded(shaded(shader["source"], shader["uniforms"], "strip", light, true,
                       end_to_end::places_on_moon()),
                light);
}

TEST_F(Shader, OfMaterialXHasTheNumbersOfTheStripThatItNames) {
  const auto uniforms = generated()["uniforms"];
  const auto facts = strip("2018-07-27T20:21:45Z").facts;
  int compared = 0;
  for (const auto& [name, value] : uniforms.items()) {
    if (!facts.contains(name)) continue;
    const auto ours = facts[name].is_array() ? facts[name] : json{facts[name]};
    const auto theirs = value.is_array() ? value : json{value};
    for (std::size_t i = 0; i < ours.size(); ++i, ++compared)
      EXPECT_NEAR(theirs[i].get<double>(), ours[i].get<double>(), 1e-5) << name;
  }
  EXPECT_EQ(compared, 4 * 3 + 7);
}

}  // namespace
}  // namespace coppermoon::hand_off
