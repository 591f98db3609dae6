// SPDX-License-Identifier: MIT
#include "verbs/film_composite.h"

#include "algebra/error.h"
#include "algebra/number.h"
#include "texture/read_image.h"
#include "texture/write_image.h"

namespace coppermoon::verbs {
namespace {

namespace fs = std::filesystem;

double number_in_header(const fs::path& frame, const char* name) {
  const auto value = algebra::number_in(texture::read_attribute(frame, name).value_or(""));
  if (!value) throw algebra::Error(fmt::format("{}: its header has no {}", frame.string(), name));
  return *value;
}

double exposure_scale_of(const DevelopOptions& develop, const fs::path& frame) {
  return scale_of(develop, {number_in_header(frame, "expTime"), number_in_header(frame, "aperture"),
                            number_in_header(frame, "isoSpeed")});
}

void expose(const DevelopOptions& develop, texture::Image& film, const fs::path& frame) {
  const auto image = texture::read_image(frame);
  if (film.values.empty()) film = texture::Image(image.width, image.height, image.channels);
  if (image.width != film.width || image.height != film.height || image.channels != film.channels)
    throw algebra::Error(fmt::format("{}: {} x {} pixels, allowed {} x {}, as the first frame",
                                     frame.string(), image.width, image.height, film.width,
                                     film.height));
  const auto scale = static_cast<float>(exposure_scale_of(develop, frame));
  for (std::size_t i = 0; i < film.values.size(); ++i) film.values[i] += scale * image.values[i];
}

}  // namespace

void write_composite(const fs::path& path, const Film& film,
                     const std::vector<std::size_t>& frames) {
  texture::Image exposed;
  for (const auto frame : frames) expose(film.develop, exposed, film.linear_frame(frame));
  texture::write_png(path, shown(film.develop, 1, exposed, colour::WorkingSpace::linear_rec709),
                     film.develop.bits,
                     {{"coppermoon:recipe", film.recipe},
                      {"coppermoon:view", film.develop.display + ", " + film.develop.view}});
}

}  // namespace coppermoon::verbs
