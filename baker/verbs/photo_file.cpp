// SPDX-License-Identifier: MIT
#include "verbs/photo_file.h"

#include "algebra/error.h"
#include "algebra/number.h"
#include "almanac/instant.h"
#include "texture/read_image.h"

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
  return texture::read_light(photo, how);
}

texture::Attributes scene_attributes(const std::string& file) {
  texture::Attributes attributes;
  for (const char* name : {"coppermoon:recipe", "coppermoon:version", "coppermoon:colour_space",
                           "coppermoon:unit", "capDate"})
    if (const auto text = texture::read_attribute(file, name)) attributes[name] = *text;
  return attributes;
}

std::optional<double> seconds_of_date(const std::string& date) {
  if (date.find_first_not_of(" :0") == date.npos) return std::nullopt;
  auto text = date;
  try {
    if (text.size() != 19 || text[4] != ':' || text[7] != ':' || text[10] != ' ')
      throw algebra::Error("another form");
    text[4] = text[7] = '-', text[10] = 'T';
    const auto when = almanac::instant_from_utc(text);
    return (when.tt_day + when.tt_fraction) * 86400;
  } catch (const algebra::Error&) {
    throw algebra::Error(fmt::format("its header's date = {}, allowed YYYY:MM:DD HH:MM:SS", date));
  }
}

std::optional<double> taken_at_s(const std::string& photo) {
  const auto date = texture::read_attribute(photo, "capDate");
  if (!date) return std::nullopt;
  try {
    return seconds_of_date(*date);
  } catch (const algebra::Error& error) {
    throw algebra::Error(fmt::format("{}: {}", photo, error.what()));
  }
}

}  // namespace coppermoon::verbs
