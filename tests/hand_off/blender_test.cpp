// SPDX-License-Identifier: MIT
// Blender itself reads what a bake hands it: the light, the place and the colour of each texel come
// out of a render as they went in.
#include <fmt/format.h>

#include "end_to_end/spotted_moon.h"
#include "hand_off/agreement.h"
#include "hand_off/blender.h"
#include "hand_off/reference_projection.h"
#include "support/testing.h"

namespace coppermoon::hand_off::blender_test {

using enum povray_scenes::Up;
using texture::ExrType;

class Blender : public BlenderTest {
 protected:
  /// A texture of these values in the header's colour space.
  void write(const std::string& name, const texture::Image& image,
             const texture::Attributes& attributes) const {
    texture::write_exr(here(name), image, attributes, {ExrType::floating});
  }

  /// As coppermoon bakes it for an observer, header and all: folder/moon_lin_rec709.exr.
  std::string baked(const Look& look, Words more) const {
    Words words{"scene",    look.instant,
                "--at",     at(look.observer),
                "-o",       "folder",
                "--width",  std::to_string(side),
                "--height", std::to_string(side),
                "--field",  std::to_string(field_deg)};
    words += more;
    expect_done(coppermoon(words));
    return "folder/moon_lin_rec709.exr";
  }
};

texture::Image uniform(const Rgb& colour) {
  texture::Image image(64, 32, {"R", "G", "B"});
  for (std::size_t i = 0; i < image.values.size(); ++i)
    image.values[i] = static_cast<float>(colour[static_cast<int>(i % 3)]);
  return image;
}

/// The spots of end_to_end, shining.
texture::Image spotted(float brightest) {
  const auto map = end_to_end::spotted_map(360);
  texture::Image image(map.width, map.height, {"R", "G", "B"});
  for (std::size_t i = 0; i < image.values.size(); ++i)
    image.values[i] = brightest * map.values[i / 3];
  return image;
}

/// The farthest that a spot is from where our camera has it, in pixels.
double worst_distance(const texture::Image& frame, const Look& look) {
  const auto camera = look.camera();
  const auto found = end_to_end::blobs(frame);
  if (found.size() != 3) return side;
  double worst = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const auto place = *povray_scenes::pixel_of(camera, end_to_end::spots()[i].at);
    worst = std::max(worst, glm::distance(found[i].centre, place));
  }
  return worst;
}

/// The farthest that a channel is from a uniform disc before a black sky, over itself; the pixels
/// within 2 of the limb apart.
double worst_channel(const texture::Image& frame, const Rgb& colour, double radius) {
  double worst = 0;
  for (std::size_t r = 0; r < side; ++r)
    for (std::size_t c = 0; c < side; ++c) {
      const double out = glm::length(glm::dvec2(c, r) + 0.5 - side / 2.) - radius;
      if (std::abs(out) < 2) continue;
      for (int k = 0; k < 3; ++k) {
        const double expected = out < 0 ? colour[k] : 0;
        const double off = std::abs(frame(r, c, static_cast<std::size_t>(k)) - expected);
        worst = std::max(worst, off / colour[k]);
      }
    }
  return worst;
}

TEST_F(Blender, LeavesTheLightOfAUniformMoonAsItIs) {
  const auto look = from_the_north(celestial_north);
  const double radius = radius_px(look.camera());
  for (const double scale : {1e-4, 5000.}) {
    const Rgb colour = scale * Rgb(1, 0.5, 0.25);
    write("moon.exr", uniform(colour), header(look));
    const auto frame = rendered("moon.exr", look.up, "scene.view_settings.exposure = 3\n");
    EXPECT_WITHIN(worst_channel(frame, colour, radius), 0, 1e-5, "floats, and means of 64 of them");
  }
}

TEST_F(Blender, MakesADiscAsLargeAsTheMoon) {
  const auto look = from_the_north(celestial_north);
  write("moon.exr", uniform({1, 1, 1}), header(look));
  const double disc = total(luminances(rendered("moon.exr", look.up)));
  const double radius = radius_px(look.camera());
  EXPECT_WITHIN_RELATIVE(disc, std::numbers::pi * radius * radius, 5e-4,
                         "64 random rays in each of 700 pixels of the limb: 1.5e-4");
}

TEST_F(Blender, ShowsTheTexelsOfAnEclipsedMoon) {
  const auto look = from_the_north(celestial_north);
  const auto name = baked(look, "--texture-width 1024");
  const auto frame = luminances(rendered(name, look.up));
  const auto reference =
      luminances(reference_projection(texture::read_image(here(name)), look.camera()));
  const double differing = part_that_differs(frame, reference, radius_px(look.camera()), 0.01);
  EXPECT_LT(differing, 0.01);
  EXPECT_WITHIN_RELATIVE(total(frame), total(reference), 0.01, "what is asked of a hand-off");
  EXPECT_LT(glm::length(shift(frame, reference)), 0.1);
}

TEST_F(Blender, PutsSpotsInPlaceWithNorthOrZenithUp) {
  texture::write_exr(here("spots.exr"), end_to_end::spotted_map(360), {}, {ExrType::floating});
  for (const auto& look : {from_the_north(celestial_north), from_the_south(zenith)}) {
    const auto name = baked(look, "--unshadowed --albedo-map spots.exr --texture-width 720");
    const auto frame = rendered(name, look.up);
    EXPECT_LT(worst_distance(frame, look), 0.5) << word(look.up);
    EXPECT_GT(worst_distance(end_to_end::mirrored(frame), look), 20) << word(look.up);
  }
}

TEST_F(Blender, PutsSpotsInPlaceWithTheMoonsNorthUp) {
  const auto look = from_the_south(moon_north);
  write("moon.exr", spotted(1), header(look));
  const auto frame = rendered("moon.exr", look.up);
  EXPECT_LT(worst_distance(frame, look), 0.5);
  EXPECT_GT(worst_distance(end_to_end::mirrored(frame), look), 20);
}

class BlenderColours : public Blender, public testing::WithParamInterface<bool> {
 protected:
  BlenderColours() {
    if (GetParam()) configuration = project("colour/config.ocio");
  }
};

TEST_P(BlenderColours, AreTheSameFromEveryColourSpace) {
  using enum colour::WorkingSpace;
  const auto look = from_the_north(celestial_north);
  const Rgb red{0.07, 0.02, 0.01};
  const auto xyz = glm::inverse(colour::channels_from_xyz(linear_rec709)) * red;
  for (const auto space : {linear_rec709, acescg, ciexyz_d65}) {
    auto texture = uniform(colour::channels_from_xyz(space) * xyz);
    if (space == ciexyz_d65) texture.channels = {"X", "Y", "Z"};
    auto attributes = header(look);
    attributes["coppermoon:colour_space"] = std::string(colour::name(space));
    write("moon.exr", texture, attributes);
    EXPECT_WITHIN(worst_channel(rendered("moon.exr", look.up), red, radius_px(look.camera())), 0,
                  0.005, colour::name(space));
  }
}

TEST_P(BlenderColours, KeepTheLuminanceOfAnEclipsedMoon) {
  const auto frame_from = [&](const std::string& space) {
    expect_done(coppermoon(
        words_of("bake 2008-02-21T03:08:26Z --texture-width 256 --type float --space {} -o {}",
                 space, space + ".exr")));
    return luminances(rendered(space + ".exr", celestial_north));
  };
  const auto reference = frame_from("lin_rec709"), frame = frame_from("acescg");
  double worst = 0;
  for (std::size_t i = 0; i < frame.values().size(); ++i)
    if (reference.values()[i] > 0)
      worst = std::max(worst, std::abs(frame.values()[i] / reference.values()[i] - 1));
  EXPECT_WITHIN(worst, 0, 0.002, "reds outside Rec.709 are paler there, not brighter or darker");
}

INSTANTIATE_TEST_SUITE_P(WithOurConfigurationOrBlendersOwn, BlenderColours, testing::Bool());

TEST_F(Blender, PutsEachFramesOwnTextureBeforeItsOwnCamera) {
  const std::vector<std::string> instants{"2018-07-27T18:30:00Z", "2018-07-27T20:30:00Z",
                                          "2018-07-27T22:30:00Z"};
  std::filesystem::create_directory(here("film"));
  std::vector<Look> looks;
  for (std::size_t i = 0; i < instants.size(); ++i) {
    looks.push_back(from_the_south(zenith));
    looks[i].instant = instants[i];
    auto attributes = header(looks[i]);
    attributes["framesPerSecond"] = std::vector{24000.F, 1001.F};
    write(fmt::format("film/moon_lin_rec709.{:04}.exr", i + 7), spotted(static_cast<float>(i + 1)),
          attributes);
  }
  const auto outcome = python(import_eclipse("film", zenith) + square() +
                                  "print('rate', scene.render.fps, scene.render.fps_base)",
                              {"-o", here("frame.####").string(), "-a"});
  ASSERT_EQ(outcome.status, 0) << outcome.out;
  EXPECT_SAYS(outcome.out, "rate 24 1.001");
  for (std::size_t i = 0; i < instants.size(); ++i) {
    const auto frame = texture::read_image(here(fmt::format("frame.{:04}.exr", i + 7)));
    EXPECT_LT(worst_distance(frame, looks[i]), 0.5) << instants[i];
    EXPECT_GT(worst_distance(frame, looks[(i + 1) % 3]), 5) << "or all were alike";
    const auto found = end_to_end::blobs(frame);
    EXPECT_WITHIN_RELATIVE(found[0].brightest, static_cast<double>(i + 1), 0.01, "its own texture");
  }
}

TEST_F(Blender, HasOneLineForAWrongFile) {
  const auto said = [&](const std::string& name) {
    const auto outcome = python(import_eclipse(name, celestial_north));
    EXPECT_EQ(outcome.status, 3) << name;
    return outcome.out;
  };
  file("not.exr", "nothing of the kind");
  EXPECT_SAYS(said("not.exr"), "\nError: not.exr: is not an OpenEXR file\n");
  EXPECT_SAYS(said("none.exr"), "\nError: none.exr: No such file or directory\n");
  write("bare.exr", uniform({1, 1, 1}), {});
  EXPECT_SAYS(said("bare.exr"), "its header has no coppermoon:colour_space\n");
}

}  // namespace coppermoon::hand_off::blender_test
