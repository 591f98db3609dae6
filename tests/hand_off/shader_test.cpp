// SPDX-License-Identifier: MIT
// An eclipse's shader where other programs run it: MaterialX's own generator, and OSL in Cycles.
#include "end_to_end/eclipse_shader.h"
#include "support/testing.h"

namespace coppermoon::hand_off::shader_test {

using end_to_end::EclipseShader;
using end_to_end::ShaderTest;
using end_to_end::Vector;
using nlohmann::json;

class Shader : public ShaderTest {
 protected:
  EclipseShader shader() const {
    expect_done(coppermoon("shader 2018-07-27 --bands 20 -o eclipse"));
    return end_to_end::read_shader(here("eclipse"));
  }
};

TEST_F(Shader, OfMaterialXFindsTheLight) {
  const auto of = shader();
  const auto done = run({"node", "generate_mtlx.mjs", here("eclipse/eclipse.mtlx").string()},
                        {.folder = COPPERMOON_HAND_OFF_READERS});
  ASSERT_EQ(done.status, 0) << done.err;
  auto generated = json::parse(done.out);
  const auto places = end_to_end::places_on_moon();
  for (const double seconds : {-5400., 1000.}) {
    generated["uniforms"]["time"] = seconds;
    const auto found =
        shaded(generated["source"], generated["uniforms"], "strip", of.strip, true, places);
    end_to_end::expect_alike(found, of, places, seconds, 0.01,
                             "a GPU's filter has 256 steps between texels");
  }
}

TEST_F(Shader, OfOslFindsTheLightInCycles) {
  const auto of = shader();
  for (const double seconds : {-5400., 1000.}) {
    const auto done = run({COPPERMOON_HAND_OFF_BLENDER "/bin/python",
                           COPPERMOON_TEST_DATA "/hand_off/shade_in_cycles.py",
                           here("eclipse").string(), fmt::format("{}", seconds)});
    ASSERT_EQ(done.status, 0) << done.err << done.out;
    const auto light = texture::read_image(here("eclipse/light.exr")),
               halves = texture::read_image(here("eclipse/places.exr"));
    std::vector<Vector> found, places;
    for (std::size_t r = 0; r < light.height; ++r)
      for (std::size_t c = 0; c < light.width; ++c) {
        const Vector place{2. * halves(r, c, 0) - 1, 2. * halves(r, c, 1) - 1,
                           2. * halves(r, c, 2) - 1};
        if (std::abs(std::sqrt(end_to_end::dot(place, place)) - 1) > 0.01) continue;
        places.push_back(place);
        found.push_back({light(r, c, 0), light(r, c, 1), light(r, c, 2)});
      }
    EXPECT_GT(places.size(), 2000U);
    end_to_end::expect_alike(found, of, places, seconds, 0.005,
                             "floats, over the strip's steepest columns");
  }
}

}  // namespace coppermoon::hand_off::shader_test
