// SPDX-License-Identifier: MIT
#include "uses/picture/camera_colours.h"

#include <algorithm>
#include <glm/gtc/matrix_access.hpp>
#include <glm/matrix.hpp>

#include "colour/camera_spectra.h"
#include "colour/working_space.h"

namespace coppermoon::uses {
namespace {

glm::dvec3 vector_of(std::span<const double> xyz) { return {xyz[0], xyz[1], xyz[2]}; }

}  // namespace

CameraColours camera_colours(const std::optional<std::string>& response,
                             const std::optional<std::array<double, 3>>& as_shot) {
  CameraColours colours;
  colours.channels_from_xyz = colour::channels_from_xyz(colour::WorkingSpace::linear_rec709);
  if (!response || !colour::is_spectral(*response)) return colours;
  const auto spectra = colour::camera_spectra(*response);
  colours.rec709_from_channels = colours.channels_from_xyz * spectra.xyz_from_balanced;
  colours.channels_from_xyz = glm::inverse(spectra.xyz_from_balanced);
  if (as_shot)
    colours.gains =
        vector_of(*as_shot) * spectra.daylight / spectra.daylight.g;  // divides by daylight's gains
  return colours;
}

std::array<double, 3> rec709_of(std::span<const double> xyz) {
  constexpr double dark = 1e-12;  // in darker colours, rounding can make channels negative
  if (xyz[1] < dark) return {dark, dark, dark};
  static const auto from_xyz = colour::channels_from_xyz(colour::WorkingSpace::linear_rec709);
  const auto rgb = from_xyz * glm::dvec3(xyz[0], xyz[1], xyz[2]);
  std::array<double, 3> channels{rgb.r, rgb.g, rgb.b};
  colour::into_gamut(colour::WorkingSpace::linear_rec709, channels);
  for (double& channel : channels) channel = std::max(channel, dark);
  return channels;
}

std::array<double, 3> xyz_of_rec709(std::span<const double> rgb) {
  static const auto to_xyz =
      glm::inverse(colour::channels_from_xyz(colour::WorkingSpace::linear_rec709));
  const auto xyz = to_xyz * glm::dvec3(rgb[0], rgb[1], rgb[2]);
  return {xyz.x, xyz.y, xyz.z};
}

std::array<double, 3> rec709_by(const std::optional<CameraColours>& colours,
                                std::span<const double> xyz, double least) {
  constexpr double dark = 1e-12;
  if (!colours) return rec709_of(xyz);
  const auto rgb = colours->rec709_from_channels *
                   (colours->gains * (colours->channels_from_xyz * vector_of(xyz)));
  const double brightest = std::max({rgb.r, rgb.g, rgb.b}),
               floor = std::max(dark, least * brightest), added = colours->lift * brightest;
  return {std::max(rgb.r, floor) + added, std::max(rgb.g, floor) + added,
          std::max(rgb.b, floor) + added};
}

glm::dvec3 parts_of(std::size_t channel, const CameraColours& colours,
                    std::span<const double> xyz) {
  const auto channels = colours.gains * (colours.channels_from_xyz * vector_of(xyz));
  const auto row = [&](int k) { return glm::row(colours.rec709_from_channels, k); };
  const auto rgb = colours.rec709_from_channels * channels;
  const int brightest = rgb.r >= rgb.g && rgb.r >= rgb.b ? 0 : rgb.g >= rgb.b ? 1 : 2;
  return (row(static_cast<int>(channel)) + colours.lift * row(brightest)) * channels;
}

}  // namespace coppermoon::uses
