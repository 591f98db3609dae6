// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>

#include "uses/night/circumstances.h"
#include "uses/picture/brightness.h"
#include "uses/picture/clear_sky.h"
#include "uses/picture/view.h"

namespace coppermoon::uses {

/// The Moon throughout an eclipse, from one simulation.
class EclipseLight {
 public:
  /// Throws  Error  as light_on_the_way, normal_albedo
  EclipseLight(const eclipse::Eclipse& eclipse, const MoonRequest& moon,
               const algebra::Progress& progress = {});
  /// Given  albedo  of the whole Moon: normal_albedo in a few rows
  ///        light   along the Moon's way, or at the only moment asked for
  EclipseLight(const MoonRequest& moon, algebra::Grid<float> albedo, Moonlight light);

  const algebra::Grid<float>& albedo() const { return albedo_; }
  DiscBrightness brightness(const almanac::SkyState& sky) const { return survey_.brightness(sky); }

  /// Texture in linear Rec.709 [cd/m²], seen through an observer's air if a sightline is given.
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
  double V_magnitude, mean_luminance_cd_m2;  ///< of the disc, above the air
  double seen_cd_m2;          ///< of the disc, through the air, without the sky's light
  double sky_cd_m2;           ///< of the sky at the Moon
  Rgb sky_light;              ///< sky_cd_m2 in linear Rec.709
  double zenith_cd_m2;        ///< of the sky
  double contrast_threshold;  ///< of the eye

  bool stands_out() const { return seen_cd_m2 > contrast_threshold * sky_cd_m2; }
};

/// Given  view  for its observer, which is required, and the air
MoonAndSky moon_and_sky(const DiscBrightness& above, const almanac::SkyState& sky,
                        const ViewRequest& view);

/// Brightness of the whole Moon at a moment, above the air.
using BrightnessAt = std::function<DiscBrightness(const almanac::SkyState&)>;

/// The night with the times when the Moon is seen: it is up, and brighter than its sky by more than the eye's contrast
/// threshold (atmosphere/eye_contrast.h) for a uniform disc of its mean luminance. Moments "first seen" and "last seen"
/// are added unless they coincide with moonrise, moonset, P1 or P4.
///
/// Accuracy  10 s in applying the rule. The threshold and the sky's light are each uncertain by some tenths, which
///           amounts to 2 to 5 min of twilight
Circumstances as_seen(Circumstances night, const BrightnessAt& brightness, const ViewRequest& view);

/// Circumstances with as_seen applied in usual air. Light is computed only when it may matter, because an eclipsed Moon
/// well above the horizon in a dark sky always stands out.
Circumstances seen_circumstances(const eclipse::Eclipse& eclipse, const almanac::Observer& place);

}  // namespace coppermoon::uses
