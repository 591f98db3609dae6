// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>

#include "uses/night/circumstances.h"
#include "uses/picture/brightness.h"
#include "uses/picture/clear_sky.h"
#include "uses/picture/view.h"

namespace coppermoon::uses {

/// The Moon's light throughout an eclipse, from a single simulation.
class EclipseLight {
 public:
  /// Throws  Error  if light_on_the_way or normal_albedo does
  EclipseLight(const eclipse::Eclipse& eclipse, const MoonRequest& moon,
               const algebra::Progress& progress = {});
  /// Given  albedo  albedo map of the whole Moon: the result of normal_albedo, resized to a small number of rows
  ///        light   light in the shadow along the Moon's path, or at a single moment
  EclipseLight(const MoonRequest& moon, algebra::Grid<float> albedo, Moonlight light);

  const algebra::Grid<float>& albedo() const { return albedo_; }
  DiscBrightness brightness(const almanac::SkyState& sky) const { return survey_.brightness(sky); }

  /// Texture of the Moon in linear Rec.709 [cd/m²], as seen through an observer's air if a sightline is given.
  texture::Image colours(const almanac::SkyState& sky,
                         const std::optional<atmosphere::Sightline>& through) const;

 private:
  MoonRequest moon_;
  algebra::Grid<float> albedo_;
  Moonlight light_;
  MoonSurvey survey_;
};

/// The Moon and the sky around it, as seen from a place.
struct MoonAndSky {
  double V_magnitude, mean_luminance_cd_m2;  ///< of the whole disc, without the effect of air
  double seen_cd_m2;          ///< luminance of the disc through the air, without the sky's light
  double sky_cd_m2;           ///< luminance of the sky in the Moon's direction
  Rgb sky_light;              ///< colour of the sky in the Moon's direction, in linear Rec.709
  double zenith_cd_m2;        ///< luminance of the sky at the zenith
  double contrast_threshold;  ///< smallest contrast with the sky that the eye sees

  bool stands_out() const { return seen_cd_m2 > contrast_threshold * sky_cd_m2; }
};

/// Given  view  must have an observer; the observer's air is also taken from it
MoonAndSky moon_and_sky(const DiscBrightness& above, const almanac::SkyState& sky,
                        const ViewRequest& view);

/// Function that gives the brightness of the whole Moon at a moment, without the effect of air.
using BrightnessAt = std::function<DiscBrightness(const almanac::SkyState&)>;

/// Adds to a night the times when the Moon is seen. The Moon is seen if it is up, and if a uniform disc of its mean
/// luminance is brighter than the sky by more than the eye's contrast threshold (atmosphere/eye_contrast.h). The
/// moments "first seen" and "last seen" are added unless they coincide with moonrise, moonset, P1 or P4.
///
/// Accuracy  10 s if the threshold and the sky's luminance are exact. Their uncertainty of some tens of percent shifts
///           the times by 2 to 5 min in twilight
Circumstances as_seen(Circumstances night, const BrightnessAt& brightness, const ViewRequest& view);

/// Circumstances of an eclipse at a place with ordinary air, with the times when the Moon is seen (as_seen). The Moon's
/// light is not computed for a Moon well above the horizon in a dark sky, because such a Moon is always seen.
Circumstances seen_circumstances(const eclipse::Eclipse& eclipse, const almanac::Observer& place);

}  // namespace coppermoon::uses
