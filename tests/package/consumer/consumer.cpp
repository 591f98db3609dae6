// SPDX-License-Identifier: MIT
#include "texture/image.h"

#include <coppermoon/almanac/instant.h>
#include <coppermoon/almanac/sky.h>
#include <coppermoon/colour/display.h>
#include <coppermoon/eclipse/contacts.h>
#include <coppermoon/povray_scenes/scene_camera.h>
#include <coppermoon/shadow/lookup.h>
#include <coppermoon/surface/albedo_map.h>
#include <coppermoon/texture/read_image.h>
#include <coppermoon/texture/write_image.h>
#include <cstdio>
#include <filesystem>

#if __has_include("almanac/sky.h")
#error "headers are <coppermoon/almanac/sky.h>, and by no other name"
#endif

using namespace coppermoon;

/// The greatest eclipse of February 2008.
void print_eclipse() {
  const auto eclipses = eclipse::eclipses_between(almanac::instant_from_utc("2008-02-01"),
                                                  almanac::instant_from_utc("2008-03-01"),
                                                  eclipse::ShadowConvention::danjon);
  for (const auto& e : eclipses)
    std::printf("greatest %s\n", almanac::utc_text(e.greatest).c_str());
}

/// Two by two pixels of mid-grey, developed at half the light: 0.25 is 0.5371 in sRGB.
void print_picture() {
  colour::Image frame(2, 2);
  for (auto& pixel : frame.values()) pixel = {0.5F, 0.5F, 0.5F};
  const auto picture =
      colour::developed(frame, colour::WorkingSpace::linear_rec709, {.scale = 0.5});
  std::printf("developed %.4f\n", double{picture(1, 1)[0]});
}

/// A texture written and read again.
void print_texture(const std::filesystem::path& file) {
  texture::Image image(2, 1, {"R", "G", "B"});
  image(0, 1, 2) = 0.25F;
  texture::write_exr(file, image, {});
  std::printf("texel %.2f\n", double{texture::read_image(file)(0, 1, 2)});
}

/// The middle of the Moon is in the middle of a picture.
void print_pixel() {
  const auto sky = almanac::sky_at(almanac::instant_from_utc("2008-02-21T03:26:05Z"));
  const auto camera =
      povray_scenes::camera_at(sky, povray_scenes::Up::moon_north, {algebra::degrees(1), 64, 64});
  const auto pixel = povray_scenes::pixel_of(camera, sky.sub_earth);
  std::printf("pixel %.2f %.2f\n", pixel->x, pixel->y);
}

int main(int, char** words) {
  std::puts(consumer::texture);
  print_eclipse();
  print_picture();
  print_texture(std::filesystem::path(words[0]).replace_filename("texture.exr"));
  print_pixel();
  const algebra::Grid<float> map(2, 4);
  const shadow::Lookup sunlight(shadow::ChannelWeights(1, 1));
  std::printf("channels %zu, albedo %.1f\n", sunlight.channels(),
              surface::geometric_albedo(map, surface::Photometry::yapo_cutler));
}
