// SPDX-License-Identifier: MIT
#include "texture/openimageio/oiio_attributes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "algebra/error.h"

namespace coppermoon::texture {
namespace {

using algebra::Error;
using Pair = std::pair<std::string_view, std::string_view>;

constexpr std::array<Pair, 5> translated{{{"capDate", "DateTime"},
                                          {"comments", "ImageDescription"},
                                          {"owner", "Copyright"},
                                          {"expTime", "ExposureTime"},
                                          {"aperture", "FNumber"}}};
constexpr std::array<std::string_view, 9> real_numbers{"expTime",        "aperture",  "isoSpeed",
                                                       "whiteLuminance", "utcOffset", "longitude",
                                                       "latitude",       "altitude",  "focus"};
constexpr std::array<std::string_view, 3> texts{"capDate", "owner", "comments"};
constexpr std::array<std::string_view, 14> own_layout{
    "channels",           "chunkCount",    "compression",
    "dataWindow",         "displayWindow", "envmap",
    "lineOrder",          "name",          "pixelAspectRatio",
    "screenWindowCenter", "tiles",         "type",
    "screenWindowWidth",  "version"};

bool contains(const auto& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

void require(bool right, std::string_view name, std::string_view allowed) {
  if (!right) throw Error(fmt::format("image attribute {}, allowed {}", name, allowed));
}

std::size_t length(const Attribute& value) {
  const auto* numbers = std::get_if<std::vector<float>>(&value);
  return numbers ? numbers->size() : 0;
}

/// Whether a value is a ratio: two whole numbers of 1 or more that a float can represent exactly.
bool is_ratio(const Attribute& value) {
  constexpr float most = 1 << 24;
  const auto* numbers = std::get_if<std::vector<float>>(&value);
  return numbers && numbers->size() == 2 && std::ranges::all_of(*numbers, [](float number) {
           return number >= 1 && number <= most && number == std::floor(number);
         });
}

void require_standard_type(const std::string& name, const Attribute& value) {
  require(!name.empty() && name.find('\0') == std::string::npos, "without a name", "any text");
  require(!contains(own_layout, name), name, "names the file does not keep for its own layout");
  if (contains(real_numbers, name))
    require(std::holds_alternative<float>(value) || std::holds_alternative<int>(value), name,
            "one number");
  if (contains(texts, name)) require(std::holds_alternative<std::string>(value), name, "text");
  if (name == "chromaticities") require(length(value) == 8, name, "8 numbers");
  if (name == "adoptedNeutral") require(length(value) == 2, name, "2 numbers");
  if (name == "framesPerSecond") require(is_ratio(value), name, "2 whole numbers of 1 or more");
  if (const auto* numbers = std::get_if<std::vector<float>>(&value))
    require(!numbers->empty(), name, "at least one number");
}

float as_float(const Attribute& value) {
  const auto* whole = std::get_if<int>(&value);
  return whole ? static_cast<float>(*whole) : std::get<float>(value);
}

}  // namespace

std::string oiio_name(std::string_view name) {
  for (const auto& [standard, theirs] : translated)
    if (standard == name) return std::string(theirs);
  return std::string(name);
}

void set_attribute(OIIO::ImageSpec& spec, const std::string& name, const Attribute& value) {
  require_standard_type(name, value);
  const auto key = oiio_name(name);
  if (name == "framesPerSecond") {
    const auto& ratio = std::get<std::vector<float>>(value);
    const std::array fraction{static_cast<int>(ratio[0]), static_cast<int>(ratio[1])};
    spec.attribute(key, OIIO::TypeRational, fraction.data());
  } else if (contains(real_numbers, name)) {
    spec.attribute(key, as_float(value));
  } else if (const auto* text = std::get_if<std::string>(&value)) {
    spec.attribute(key, *text);
  } else if (const auto* numbers = std::get_if<std::vector<float>>(&value)) {
    const bool pair = name == "adoptedNeutral";
    const auto type =
        pair ? OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, OIIO::TypeDesc::VEC2)
             : OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, static_cast<int>(numbers->size()));
    spec.attribute(key, type, numbers->data());
  } else if (const auto* whole = std::get_if<int>(&value)) {
    spec.attribute(key, *whole);
  } else {
    spec.attribute(key, std::get<float>(value));
  }
}

}  // namespace coppermoon::texture
