// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "algebra/grid.h"
#include "algebra/quantity.h"
#include "almanac/sky.h"
#include "atmosphere/observer_air.h"
#include "povray_scenes/moon_include.h"
#include "povray_scenes/scene.h"
#include "texture/image.h"
#include "uses/picture/view.h"

namespace coppermoon::uses {

using povray_scenes::SkyLight;

/// Stars and planets before a view's camera, but for those that the Moon or the ground hides.
///
/// Each is refracted by its own altitude, relative to the Moon. A planet is a disc of points, of which the Moon may
/// hide some.
///
/// Returned  none where the view wants none
/// Accuracy  places 0.1″ of stars, 0.1″ of planets; times of occultations some seconds, by the Moon's mountains
/// Omits     stars fainter than V = 9; how stars vary; the shape of a planet's light and Saturn's rings
/// Throws    Error  when a catalogue is damaged
std::vector<SkyLight> sky_lights(const View& view, const almanac::SkyState& sky);

/// Lights for a scene: each planet as one disc, also those behind the Moon, since the scene hides them.
std::vector<SkyLight> scene_lights(const View& view, const almanac::SkyState& sky);

/// Adds lights to a frame, each as a Gaussian with a standard deviation of 0.6 pixel.
///
/// Given     frame   scene-linear, linear Rec.709 [cd/m²], of the camera's size
/// Returned  numbers that half floats hold, as those of a frame are, where they are below 65504
/// Accuracy  the sum of luminance times solid angle is the illuminance to 5e-4, but for what falls beside the frame
void add_lights(texture::Image& frame, const povray_scenes::SceneCamera& camera,
                std::span<const SkyLight> lights);

/// All stars and planets above a view's horizon, the brightest first, the Moon or no Moon before them: to
/// V = 6.5 unless the view says how faint.
///
/// Given  view  with an observer
/// Throws Error when a catalogue is damaged
std::vector<povray_scenes::StarInSky> lights_over(const View& view, const almanac::SkyState& sky);

/// Temperature of a black body of a star's colour [K].
///
///     4600 (1 / (0.92 (B − V) + 1.7) + 1 / (0.92 (B − V) + 0.62))
///
/// Given   b_minus_v  −0.5 to 4, held at either end
/// Source  Ballesteros (2012), EPL 97, 34008, equation 14
double star_temperature_k(double b_minus_v);

/// Light of stars above an observer's air, or through it.
class StarLights {
 public:
  /// Given  air       none: above the air
  ///        response  as in colour::channel_weights
  explicit StarLights(const std::optional<atmosphere::ObserverAir>& air = {},
                      const std::string& response = {});

  /// Light of a star on a surface that faces it: linear Rec.709 [lux].
  ///
  /// It has the spectrum of a black body, and as much of it as the V magnitude says, by the Sun's (see
  /// photometric_bands): a white star of V = 0 gives 2.6e-6 lux.
  ///
  /// Given     altitude  without refraction; as transmittance_above has it
  /// Accuracy  0.02 magnitude of luminance; colours as far as stars are black bodies
  std::array<double, 3> lux(double magnitude, double b_minus_v,
                            algebra::Angle altitude = algebra::degrees(90)) const;

 private:
  algebra::Grid<double> channels_;                  ///< weights, [channel][band]
  std::vector<atmosphere::VerticalDepths> depths_;  ///< [band]; empty: above the air
};

}  // namespace coppermoon::uses
