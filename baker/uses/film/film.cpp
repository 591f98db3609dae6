// SPDX-License-Identifier: MIT
#include "uses/film/film.h"

#include <fmt/format.h>

#include "povray_scenes/sequence.h"
#include "uses/film/film_scene.h"
#include "uses/picture/lit_scene.h"

namespace coppermoon::uses {

using povray_scenes::numbered_file;

almanac::SkyState Film::sky(std::size_t frame) const { return almanac::sky_at(moments.at(frame)); }

namespace {

std::filesystem::path linear_file(const Film& film, const char* kind, std::size_t frame) {
  return film.folder /
         numbered_file(fmt::format("{}_{}", kind, colour::name(space_of(film.content))), frame,
                       film.moments.last_frame());
}

}  // namespace

std::filesystem::path Film::texture(std::size_t frame) const {
  return linear_file(*this, "moon", frame).replace_extension(products.mipmapped ? ".tx" : ".exr");
}

std::filesystem::path Film::linear_frame(std::size_t frame) const {
  return linear_file(*this, "frame", frame);
}

std::filesystem::path Film::picture(std::size_t frame, const char* stem) const {
  return (folder / numbered_file(stem, frame, moments.last_frame())).replace_extension(".png");
}

std::filesystem::path Film::high_range_picture(std::size_t frame) const {
  return picture(frame, "frame_hdr");
}

std::vector<std::filesystem::path> Film::files(std::size_t frame) const {
  std::vector<std::filesystem::path> all;
  if (products.textures) all.push_back(texture(frame));
  if (products.frames) all.push_back(linear_frame(frame));
  if (products.pictures) all.push_back(picture(frame));
  if (products.pictures && products.high_range) all.push_back(high_range_picture(frame));
  if (products.pictures && bracket_ev)
    for (const char* stem : {"frame_under", "frame_over"}) all.push_back(picture(frame, stem));
  return all;
}

View view_of(const Film& film, const almanac::SkyState& sky) {
  auto view = film.scene.empty() ? view_for_frame(film.view, sky).view : scene_view(film, sky);
  view.response = film.moon.response.value_or("");
  return view;
}

LitMoon moon_of(const Film& film, const almanac::SkyState& sky, const View& view) {
  return {film.moon,     sky,
          film.albedo,   film.ground,
          film.light,    film.moon.unshadowed ? std::nullopt : range_at(*film.light, sky),
          view.observer, view.sightline};
}

}  // namespace coppermoon::uses
