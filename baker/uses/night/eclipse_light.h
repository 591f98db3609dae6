// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>

#include "uses/night/circumstances.h"
#include "uses/picture/brightness.h"
#include "uses/picture/clear_sky.h"
#include "uses/picture/view.h"

namespace coppermoon::uses {

/// Moon throughout an eclipse, from one simulation.
class EclipseLight {
 public:
  /// Throws  Error  as light_on_the_way, normal_albedo
  EclipseLight(const eclipse::Eclipse& eclipse, const MoonRequest& moon,
               const algebra::Progress& progress = {});
  /// Given  albedo  of the whole Moon, normal_albedo in few rows
  ///        light   on the Moon's way, or at the moment that is asked for
  EclipseLight(const MoonRequest& moon, algebra::Grid<float> albedo, Moonlight light);

  const algebra::Grid<float>& albedo() const { return albedo_; }
  DiscBrightness brightness(const almanac::SkyState& sky) const { return survey_.brightness(sky); }

  /// Texture in linear Rec.709 [cd/m²], through an observer's air where it is given.
  texture::Image colours(const almanac::SkyState& sky,
                         const std::optional<atmosphere::Sightline>& through) const;

 private:
  MoonRequest moon_;
  algebra::Grid<float> albedo_;
  Moonlight light_;
  MoonSurvey survey_;
};

/// Moon before its sky, as a place sees both.
struct MoonAndSky {
  double V_magnitude, mean_luminance_cd_m2;  ///< of the disc, above the air
  double seen_cd_m2;                         ///< of the disc, through the air, without the sky's
  double sky_cd_m2;                          ///< before and behind it
  Rgb sky_light;                             ///< the same in linear Rec.709
  double zenith_cd_m2;                       ///< of the sky
  double contrast_threshold;                 ///< of the eye

  bool stands_out() const { return seen_cd_m2 > contrast_threshold * sky_cd_m2; }
};

/// Given  view  for its observer, who is needed, and the air
MoonAndSky moon_and_sky(const DiscBrightness& above, const almanac::SkyState& sky,
                        const ViewRequest& view);

/// Brightness of the whole Moon at a moment, above the air.
using BrightnessAt = std::function<DiscBrightness(const almanac::SkyState&)>;

/// Night with the times in which the Moon is seen: up, and brighter than its sky by more than the eye's threshold of
/// contrast (atmosphere/eye_contrast.h) for a uniform disc of its mean luminance. Moments "first seen" and "last seen" are
/// added where they are neither moonrise, moonset, P1 nor P4.
///
/// Accuracy  10 s of the rule. The threshold and the sky's light are each known to some tenths, which is 2 to 5 min of
///           twilight
Circumstances as_seen(Circumstances night, const BrightnessAt& brightness, const ViewRequest& view);

/// The same in usual air, with light that is computed where it may matter: in a dark sky, well above the horizon, an
/// eclipsed Moon stands out.
Circumstances seen_circumstances(const eclipse::Eclipse& eclipse, const almanac::Observer& place);

}  // namespace coppermoon::uses
