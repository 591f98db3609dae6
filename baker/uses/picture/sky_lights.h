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
#include "povray_scenes/moon_scene.h"
#include "texture/image.h"
#include "uses/picture/view.h"

namespace coppermoon::uses {

using povray_scenes::SkyLight;

/// Stars and planets in front of a view's camera, except those that the Moon or the ground hides.
///
/// A frame shows the Moon at its place without air, so each star or planet is moved by its own refraction minus the
/// Moon's. A planet is a disc of points, some of which the Moon may hide.
///
/// Returned  an empty list if the view is to be without stars
/// Accuracy  places 0.1″ for stars and planets; times of occultations some seconds, because the Moon has mountains
/// Omits     stars fainter than V = 9; the variability of stars; phases of planets and Saturn's rings
/// Throws    Error  when a catalogue is damaged
std::vector<SkyLight> sky_lights(const View& view, const almanac::SkyState& sky);

/// Stars and planets for a scene, in which each planet is a single disc. Objects behind the Moon are included, because
/// the Moon in the scene hides them.
std::vector<SkyLight> scene_lights(const View& view, const almanac::SkyState& sky);

/// Adds lights to a frame, each as a Gaussian with a standard deviation of 0.6 pixel.
///
/// Given     frame   scene-linear, linear Rec.709 [cd/m²], of the camera's size
/// Returned  numbers rounded to half floats, as in a frame's file, if they are below 65504
/// Accuracy  luminance summed over solid angle gives the illuminance to within 5e-4, except for light outside the frame
void add_lights(texture::Image& frame, const povray_scenes::SceneCamera& camera,
                std::span<const SkyLight> lights);

/// All stars and planets above a view's horizon, brightest first, including those that the Moon hides. The faintest
/// have V = 6.5, unless the view sets another limit.
///
/// Given  view  must have an observer
/// Throws Error when a catalogue is damaged
std::vector<povray_scenes::StarInSky> lights_over(const View& view, const almanac::SkyState& sky);

/// Temperature of a black body with a star's colour [K].
///
///     4600 (1 / (0.92 (B − V) + 1.7) + 1 / (0.92 (B − V) + 0.62))
///
/// Given   b_minus_v  clamped to −0.5 to 4
/// Source  Ballesteros (2012), EPL 97, 34008, equation 14
double star_temperature_k(double b_minus_v);

/// Computes the light of stars, above an observer's air or through it.
class StarLights {
 public:
  /// Given  air       air over the observer; if absent, the light is that above the air
  ///        response  as in colour::channel_weights
  explicit StarLights(const std::optional<atmosphere::ObserverAir>& air = {},
                      const std::string& response = {});

  /// Light of a star on a surface that faces it: linear Rec.709 [lux].
  ///
  /// The spectrum is a black body's, scaled to the V magnitude relative to the Sun's (see photometric_bands). A white
  /// star of V = 0 gives 2.6e-6 lux.
  ///
  /// Given     altitude  without refraction, as for transmittance_above
  /// Accuracy  0.02 magnitude in luminance; colours are only as good as the assumption of a black body
  std::array<double, 3> lux(double magnitude, double b_minus_v,
                            algebra::Angle altitude = algebra::degrees(90)) const;

 private:
  algebra::Grid<double> channels_;                  ///< weights, [channel][band]
  std::vector<atmosphere::VerticalDepths> depths_;  ///< [band]; empty if there is no air
};

}  // namespace coppermoon::uses
