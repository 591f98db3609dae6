// SPDX-License-Identifier: MIT
// Alpha and passes of scene-linear frames, for compositing.
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include "end_to_end/parts_of.h"
#include "support/program.h"
#include "texture/read_image.h"

namespace coppermoon::end_to_end::frame_passes_test {

using texture::Image;

using Parts = std::map<std::string, Image>;

std::string first_part_of(const std::filesystem::path& path) {
  return OIIO::ImageInput::open(path)->spec().get_string_attribute("oiio:subimagename");
}

/// Light of the sky in a pixel; 0 where no part holds a sky.
double sky_at(const Parts& parts, std::size_t r, std::size_t c, std::size_t k) {
  const auto found = parts.find("sky");
  return found == parts.end() ? 0 : found->second(r, c, k);
}

/// Sum of a function over all pixels.
template <class Of>
double sum(const Image& image, Of of) {
  double all = 0;
  for (std::size_t r = 0; r < image.height; ++r)
    for (std::size_t c = 0; c < image.width; ++c) all += of(r, c);
  return all;
}

double alpha_sum(const Image& image) {
  return sum(image, [&](auto r, auto c) { return double{image(r, c, 3)}; });
}

void expect_sums(const Parts& parts) {
  const auto &whole = parts.at("rgba"), &moon = parts.at("moon"), &stars = parts.at("stars");
  double most = 0;
  for (std::size_t r = 0; r < whole.height; ++r)
    for (std::size_t c = 0; c < whole.width; ++c) {
      ASSERT_EQ(whole(r, c, 3), moon(r, c, 3));
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_WITHIN(moon(r, c, k) + sky_at(parts, r, c, k) + stars(r, c, k), whole(r, c, k),
                      1e-7 * whole(r, c, k), "float precision");
        EXPECT_GE(stars(r, c, k), 0);
        EXPECT_TRUE(whole(r, c, 3) > 0 || moon(r, c, k) == 0) << r << ", " << c;
        most = std::max<double>(most, stars(r, c, k));
      }
    }
  EXPECT_GT(most, 1e-3) << "there are stars";
}

class FramePasses : public ProgramTest {
 protected:
  static Words still(const Words& more) {
    return Words(
               "still 2018-07-27T20:22Z --width 300 --height 200 --texture-width 512 --atmosphere "
               "undated -o moon.png") +
           more;
  }
  static Words film(const Words& more) {
    return Words(
               "animate 2018-07-27 --at Nairobi --frames 2 --width 60 --height 40 --texture-width "
               "64 --from U2 --to U3 --atmosphere undated --field 2 -o film") +
           more;
  }
};

TEST_F(FramePasses, OfAStillMakeUpTheFrameThatThereIsWithoutThem) {
  expect_done(coppermoon(still("--field 2 --frame plain.exr")));
  expect_done(coppermoon(still("--field 2 --frame passes.exr --passes")));
  const auto plain = texture::read_image(here("plain.exr")),
             frame = texture::read_image(here("passes.exr"));
  const auto parts = parts_of(here("passes.exr"));
  EXPECT_EQ(first_part_of(here("passes.exr")), "rgba");
  EXPECT_EQ(frame.channels, (Words("R G B A")));
  EXPECT_EQ(parts.at("moon").channels, (Words("moon.R moon.G moon.B moon.A")));
  ASSERT_EQ(frame.width, plain.width);
  for (std::size_t r = 0; r < frame.height; ++r)
    for (std::size_t c = 0; c < frame.width; ++c)
      for (std::size_t k = 0; k < 3; ++k)
        ASSERT_EQ(frame(r, c, k), plain(r, c, k)) << r << " " << c;
  expect_sums(parts);
  expect_done(coppermoon("develop plain.exr -o plain.png"));
  expect_done(coppermoon("develop passes.exr -o passes.png"));
  EXPECT_EQ(texture::read_image(here("plain.png")).values,
            texture::read_image(here("passes.png")).values);
}

TEST_F(FramePasses, HaveTheDiscAsAlphaAndItsPlacesAsData) {
  expect_done(coppermoon(still("--frame frame.exr --passes --field 0.9")));
  const auto parts = parts_of(here("frame.exr"));
  const auto &frame = parts.at("rgba"), &place = parts.at("position");
  const auto number = [&](const char* name) {
    return std::stod(*texture::read_attribute(here("frame.exr"), name));
  };
  constexpr double radius_km = 1737.4, degree = std::numbers::pi / 180;
  const double sine = radius_km / number("coppermoon:distance_km"),
               radius_px = std::tan(std::asin(sine)) / std::tan(0.45 * degree) * 150;
  EXPECT_WITHIN_RELATIVE(alpha_sum(frame), std::numbers::pi * radius_px * radius_px, 1e-3,
                         "25 rays in each of 540 pixels of the edge: 1e-4 expected by chance");
  for (std::size_t r = 0; r < frame.height; ++r)
    for (std::size_t c = 0; c < frame.width; ++c) {
      const double away =
          std::hypot(static_cast<double>(c) + 0.5 - 150, static_cast<double>(r) + 0.5 - 100);
      const double length = std::hypot(place(r, c, 0), place(r, c, 1), place(r, c, 2));
      if (std::abs(away - radius_px) < 1) continue;
      ASSERT_EQ(frame(r, c, 3), away < radius_px ? 1 : 0) << r << ", " << c;
      EXPECT_WITHIN(length, away < radius_px ? 1 : 0, 1e-6, "float");
    }
  // the four pixels about the middle, each half a pixel off: the sub-observer point is their mean
  std::array<double, 3> middle{};
  for (const std::size_t r : {99, 100})
    for (const std::size_t c : {149, 150})
      for (std::size_t k = 0; k < 3; ++k) middle[k] += place(r, c, k) / 4;
  EXPECT_WITHIN(std::asin(middle[2]) / degree, number("coppermoon:sub_observer_latitude"), 0.01,
                "a pixel is 0.7 degrees of the middle's ground");
  EXPECT_WITHIN(std::atan2(middle[1], middle[0]) / degree,
                number("coppermoon:sub_observer_longitude"), 0.01, "the same");
  const auto input = OIIO::ImageInput::open(here("frame.exr"));
  ASSERT_TRUE(input->seek_subimage(3, 0));
  EXPECT_EQ(input->spec().get_string_attribute("colorInteropID"), "data");
  EXPECT_EQ(input->spec().find_attribute("chromaticities"), nullptr);
}

TEST_F(FramePasses, EndWithTheMoonAtTheHorizon) {
  const Words rising =
      "still --unshadowed 2018-07-27T15:30:20Z --at -1.28,36.82 --up zenith --width 150 --height "
      "150 --texture-width 256 --atmosphere undated -o moon.png --frame frame.exr --passes";
  EXPECT_EQ(coppermoon(rising).status, 0);
  const auto parts = parts_of(here("frame.exr"));
  const auto &frame = parts.at("rgba"), &place = parts.at("position");
  const double seen = alpha_sum(frame);
  EXPECT_GT(seen, 1000);
  EXPECT_LT(seen, 12000) << "some is below the horizon";
  for (std::size_t r = 0; r < frame.height; ++r)
    for (std::size_t c = 0; c < frame.width; ++c)
      if (frame(r, c, 3) == 0)
        for (std::size_t k = 0; k < 3; ++k) {
          EXPECT_EQ(parts.at("moon")(r, c, k), 0);
          EXPECT_EQ(place(r, c, k), 0);
        }
  EXPECT_GT(sky_at(parts, 0, 75, 2), 0);
  EXPECT_EQ(sky_at(parts, 149, 75, 2), 0);
}

TEST_F(FramePasses, OfAFilmAddUpInItsSpaceAndAreKept) {
  const Words words = film("--make frames,pictures --passes --space acescg");
  expect_done(coppermoon(words));
  expect_done(coppermoon(film("--make frames --space acescg") + "-o plain"));
  for (const char* name : {"frame_acescg.0001.exr", "frame_acescg.0002.exr"}) {
    const auto file = here(std::string("film/") + name);
    expect_sums(parts_of(file));
    const auto parts = parts_of(file);
    EXPECT_EQ(parts.count("sky"), 1);
    const auto plain = texture::read_image(here(std::string("plain/") + name)).values,
               whole = texture::read_channels(file, {"R", "G", "B"}).values;
    ASSERT_EQ(whole.size(), plain.size());
    for (std::size_t i = 0; i < whole.size(); ++i)
      EXPECT_WITHIN_RELATIVE(whole[i], plain[i], 1.5e-3, "half floats, of each space once");
  }
  const auto bytes = text_of(here("film/frame_acescg.0001.exr"));
  const auto again = coppermoon(words);
  expect_done(again);
  EXPECT_EQ(text_of(here("film/frame_acescg.0001.exr")), bytes);
  expect_done(coppermoon(words + "--iso 100 --replace"));
  expect_sums(parts_of(here("film/frame_acescg.0002.exr")));
  EXPECT_EQ(texture::read_attribute(here("film/frame_acescg.0002.exr"), "isoSpeed"), "100");
}

TEST_F(FramePasses, AreOfFramesAlone) {
  for (const auto& words :
       {still({"--passes"}), Words("still moon.png -o again.png")}) {  // its own recipe
    const auto done = coppermoon(words);
    EXPECT_EQ(done.status, 0);
    EXPECT_EQ(done.err, "coppermoon: --passes: no effect without --frame\n");
  }
  EXPECT_EQ(text_of(here("again.png")), text_of(here("moon.png")));
  const auto both = coppermoon(film("--make textures,frames --passes"));
  EXPECT_EQ(both.status, 1);
  EXPECT_EQ(both.err, "coppermoon: passes need a film of textures alone, or of frames\n");
}

}  // namespace coppermoon::end_to_end::frame_passes_test
