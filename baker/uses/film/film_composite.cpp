// SPDX-License-Identifier: MIT
#include "uses/film/film_composite.h"

#include <fmt/format.h>

#include <algorithm>

#include "algebra/error.h"
#include "algebra/number.h"
#include "texture/read_image.h"
#include "texture/write_image.h"
#include "uses/light/spectral_bands.h"

namespace coppermoon::uses {
namespace {

namespace fs = std::filesystem;

double number_in_header(const fs::path& frame, const char* name) {
  const auto value = algebra::number_in(texture::read_attribute(frame, name).value_or(""));
  if (!value) throw algebra::Error(fmt::format("{}: its header has no {}", frame.string(), name));
  return *value;
}

double exposure_scale_of(const Development& development, const fs::path& frame) {
  return scale_of(development,
                  {number_in_header(frame, "expTime"), number_in_header(frame, "aperture"),
                   number_in_header(frame, "isoSpeed")});
}

/// Adds a frame's exposure to the film, which is empty before the first.
void expose(const Development& development, texture::Image& film, const fs::path& frame) {
  const auto image = texture::read_image(frame);
  if (film.values.empty()) film = texture::Image(image.width, image.height, image.channels);
  if (image.width != film.width || image.height != film.height || image.channels != film.channels)
    throw algebra::Error(fmt::format("{}: {} x {} pixels, allowed {} x {}, as the first frame",
                                     frame.string(), image.width, image.height, film.width,
                                     film.height));
  const auto scale = static_cast<float>(exposure_scale_of(development, frame));
  const bool sky = seen_by(frame).sky_cd_m2 > 0;
  for (std::size_t i = 0; i < film.values.size(); ++i) {
    float& value = film.values[i];
    value = sky ? std::max(value, scale * image.values[i]) : value + scale * image.values[i];
  }
}

}  // namespace

void write_composite(const fs::path& path, const Film& film,
                     const std::vector<std::size_t>& frames) {
  texture::Image exposed;
  for (const auto frame : frames) expose(film.development, exposed, film.linear_frame(frame));
  const auto& development = film.development;
  auto header = film.record.film_header();
  header["coppermoon:view"] = development.display + ", " + development.view;
  texture::write_png(path, shown(development, 1, exposed, space_of(film.content)), development.bits,
                     header);
}

}  // namespace coppermoon::uses
