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
constexpr std::array<std::string_view, 10> real_numbers{
    "expTime",   "aperture", "isoSpeed", "whiteLuminance", "utcOffset",
    "longitude", "latitude", "altitude", "focus",          "framesPerSecond"};
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

void require_standard_type(const std::string& name, const Attribute& value) {
  require(!name.empty() && name.find('\0') == std::string::npos, "without a name", "any text");
  require(!contains(own_layout, name), name, "names the file does not keep for its own layout");
  if (contains(real_numbers, name))
    require(std::holds_alternative<float>(value) || std::holds_alternative<int>(value), name,
            "one number");
  if (contains(texts, name)) require(std::holds_alternative<std::string>(value), name, "text");
  if (name == "chromaticities") require(length(value) == 8, name, "8 numbers");
  if (name == "adoptedNeutral") require(length(value) == 2, name, "2 numbers");
  if (const auto* numbers = std::get_if<std::vector<float>>(&value))
    require(!numbers->empty(), name, "at least one number");
}

float as_float(const Attribute& value) {
  const auto* whole = std::get_if<int>(&value);
  return whole ? static_cast<float>(*whole) : std::get<float>(value);
}

/// The fraction with the smallest denominator that is the number to float's precision; 1001 belongs
/// to the television rates, which a float only approximates.
std::array<int, 2> as_fraction(float value) {
  require(value > 0 && value < 1e6F, "framesPerSecond", "more than 0 and less than 1e6");
  const auto near = [&](int n, double within) {
    return std::abs(std::round(double{value} * n) / n - double{value}) <= within * double{value};
  };
  int n = 1;
  if (near(1, 1e-7)) return {static_cast<int>(std::round(value)), 1};
  if (near(1001, 1e-5) && std::lround(double{value} * 1001) % 1000 == 0) n = 1001;
  while (n < 1000 && !near(n, 1e-7)) ++n;
  return {static_cast<int>(std::lround(double{value} * n)), n};
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
    const auto fraction = as_fraction(as_float(value));
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
