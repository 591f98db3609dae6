// SPDX-License-Identifier: MIT
#include "verbs/photo_file.h"

#include "algebra/number.h"
#include "texture/read_image.h"
#include "verbs/silence.h"

namespace coppermoon::verbs {
namespace {

/// The first of some names that a photograph's header knows a number by.
std::optional<double> number_in_header(const std::string& photo,
                                       std::initializer_list<const char*> names) {
  for (const char* name : names) {
    const auto value = algebra::number_in(texture::read_attribute(photo, name).value_or(""));
    if (value && *value > 0) return value;
  }
  return std::nullopt;
}

}  // namespace

std::optional<colour::Exposure> exif_of(const std::string& photo) {
  const Silence silence;
  const auto time_s = number_in_header(photo, {"expTime", "Exif:ExposureTime"}),
             f_number = number_in_header(photo, {"aperture", "Exif:FNumber"}),
             iso = number_in_header(
                 photo, {"isoSpeed", "Exif:PhotographicSensitivity", "Exif:ISOSpeedRatings"});
  if (!time_s || !f_number || !iso) return std::nullopt;
  return colour::Exposure{*time_s, *f_number, *iso};
}

texture::Image read_photo(const std::string& photo, const std::string& coding) {
  const auto how = coding == "srgb"     ? texture::Coding::srgb
                   : coding == "linear" ? texture::Coding::linear
                                        : texture::Coding::as_file_says;
  const Silence silence;
  return texture::read_light(photo, how);
}

}  // namespace coppermoon::verbs
