// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "almanac/sky.h"
#include "texture/image.h"
#include "uses/picture/view.h"

namespace coppermoon::uses {

/// A star, or a point of a planet's disc, as a camera sees it.
struct SkyLight {
  glm::dvec3 direction;                   ///< unit, Moon-fixed axes
  std::array<double, 3> illuminance_lux;  ///< linear Rec.709, through the observer's air
};

/// Stars and planets before a view's camera, but for those that the Moon or the ground hides.
///
/// Refraction raises each as much more or less than the Moon as its altitude says. A planet is a disc of
/// points, of which the Moon may hide some.
///
/// Returned  none where the view wants none; planets alone where stellarium-data is not installed
/// Accuracy  places 0.1″ of stars, 0.1″ of planets; times of occultations some seconds, by the Moon's
///           mountains
/// Omits     stars fainter than V = 9; how stars vary; the shape of a planet's light and Saturn's rings
/// Throws    Error  when a catalogue is damaged
std::vector<SkyLight> sky_lights(const View& view, const almanac::SkyState& sky);

/// Adds lights to a frame: each is spread by a Gaussian with a standard deviation of 0.6 pixel.
///
/// Given     frame   scene-linear, linear Rec.709 [cd/m²], of the camera's size
/// Accuracy  light over a pixel's own solid angle sums up to the illuminance to 1e-6, but for what
///           falls beside the frame
void add_lights(texture::Image& frame, const povray_scenes::Camera& camera,
                std::span<const SkyLight> lights);

/// A star or planet over a landscape.
struct LandscapeLight {
  povray_scenes::HorizonPlace place;      ///< as it is seen, refraction counted
  std::array<double, 3> illuminance_lux;  ///< linear Rec.709, through the observer's air
};

/// All stars and planets above a view's horizon, the brightest first, the Moon or no Moon before them: to
/// V = 6.5 unless the view says how faint.
///
/// Given  view  with an observer
/// Throws Error when a catalogue is damaged
std::vector<LandscapeLight> lights_over(const View& view, const almanac::SkyState& sky);

}  // namespace coppermoon::uses
