// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <numbers>

#include "texture/usd_text.h"

namespace coppermoon::texture {
namespace {

/// Converts a Moon-fixed vector to the axes that the Moon has in USD, where north is +Y.
glm::dvec3 y_up(const glm::dvec3& v) { return {v.y, v.z, v.x}; }

std::string tuple(const glm::dvec3& v) {
  return fmt::format("({:.9g}, {:.9g}, {:.9g})", v.x + 0., v.y + 0., v.z + 0.);
}

/// A USD attribute, as text, with its value at the first moment and, if the value changes, with time samples. The first
/// value is for importers that ignore time samples, as Blender does for a texture's image file.
template <class Moment, class Value>
std::string attribute(const std::string& declared, std::span<const Moment> moments,
                      const Value& value) {
  const std::string first = value(moments.front());
  auto text = fmt::format("        {} = {}\n", declared, first);
  if (std::ranges::all_of(moments, [&](const Moment& m) { return value(m) == first; })) return text;
  text += fmt::format("        {}.timeSamples = {{\n", declared);
  for (const auto& moment : moments)
    text += fmt::format("            {:g}: {},\n", moment.time_code, value(moment));
  return text + "        }\n";
}

/// A transform, as USD text, with the given axes and origin in the Moon-fixed frame.
std::string transform(const glm::dvec3& x, const glm::dvec3& y, const glm::dvec3& z,
                      const glm::dvec3& origin) {
  const auto row = [](const glm::dvec3& v, int last) {
    return fmt::format("({:.9g}, {:.9g}, {:.9g}, {})", v.x + 0., v.y + 0., v.z + 0., last);
  };
  return fmt::format("( {}, {}, {}, {} )", row(y_up(x), 0), row(y_up(y), 0), row(y_up(z), 0),
                     row(y_up(origin), 1));
}

/// A transform, as USD text, for a camera or a light. In USD, both point along their −Z axis.
std::string looking(const glm::dvec3& along, const glm::dvec3& up, const glm::dvec3& position) {
  return transform(glm::cross(along, up), up, -along, position);
}

constexpr double aperture = 36;  ///< width of the camera's picture, in tenths of a scene unit (USD)

}  // namespace

std::string usd_observer(std::span<const UsdMoment> moments, double height_over_width,
                         const std::array<double, 3>& luminance) {
  const auto bright = [&](const UsdMoment& m) {
    return luminance[0] * m.lux[0] + luminance[1] * m.lux[1] + luminance[2] * m.lux[2];
  };
  std::string text =
      "    def Camera \"Observer\"\n    {\n        float2 clippingRange = (1, 1e6)\n";
  text += attribute("float focalLength", moments, [](const UsdMoment& m) {
    return fmt::format("{:.7g}", aperture / 2 / std::tan(m.field_rad / 2));
  });
  text += fmt::format(
      "        float horizontalAperture = {:g}\n        float verticalAperture = {:.7g}\n",
      aperture, aperture * height_over_width);
  text += attribute("matrix4d xformOp:transform", moments,
                    [](const UsdMoment& m) { return looking(m.direction, m.up, m.position); });
  text += "        uniform token[] xformOpOrder = [\"xformOp:transform\"]\n    }\n\n";

  text += "    def DistantLight \"Moonlight\"\n    {\n";
  text += attribute("float inputs:angle", moments, [](const UsdMoment& m) {
    return fmt::format("{:.7g}",
                       2 * std::asin(1 / glm::length(m.position)) * 180 / std::numbers::pi);
  });
  text += attribute("color3f inputs:color", moments, [&](const UsdMoment& m) {
    const double all = bright(m);
    return all > 0 ? tuple({m.lux[0] / all, m.lux[1] / all, m.lux[2] / all}) : "(1, 1, 1)";
  });
  text += attribute("float inputs:intensity", moments,
                    [&](const UsdMoment& m) { return fmt::format("{:.7g}", bright(m)); });
  text += "        bool inputs:normalize = 1\n";
  text += attribute("matrix4d xformOp:transform", moments, [](const UsdMoment& m) {
    const auto to_observer = glm::normalize(m.position);
    const auto aside = m.up - glm::dot(m.up, to_observer) * to_observer;
    return looking(to_observer, glm::normalize(aside), {0, 0, 0});
  });
  return text + "        uniform token[] xformOpOrder = [\"xformOp:transform\"]\n    }\n";
}

std::string usd_sky(std::span<const UsdSky> skies) {
  std::string text =
      "    def DomeLight \"Sky\"\n    {\n        float inputs:intensity = 1\n"
      "        token inputs:texture:format = \"latlong\"\n";
  text += attribute("asset inputs:texture:file", skies,
                    [](const UsdSky& sky) { return usd_asset(sky.file); });
  // In USD, +Z is in the middle of a dome light's picture, and -X at three quarters of the picture's width.
  text += attribute("matrix4d xformOp:transform", skies, [](const UsdSky& sky) {
    return transform(-glm::cross(sky.north, sky.zenith), sky.zenith, sky.north, {0, 0, 0});
  });
  return text + "        uniform token[] xformOpOrder = [\"xformOp:transform\"]\n    }\n";
}

}  // namespace coppermoon::texture
