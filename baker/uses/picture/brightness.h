// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "uses/light/photometer.h"
#include "uses/picture/baked_moon.h"
#include "uses/picture/moon.h"
#include "uses/picture/view.h"

namespace coppermoon::uses {

/// Brightness of the whole Moon at a place on the Earth, through its air.
struct BrightnessSeen {
  povray_scenes::HorizonPlace moon;    ///< refraction included
  DiscBrightness disc;                 ///< through the air
  std::vector<double> extinction_mag;  ///< [band]; 0 without reddening
  double sky_cd_m2 = 0;                ///< of the clear sky around the Moon
};

/// Brightness of the whole Moon at one moment.
struct MoonBrightness {
  DiscBrightness disc;           ///< above the air, from the Earth's centre
  std::optional<double> danjon;  ///< of Danjon's scale, in totality alone
  /// standard error of the V magnitude, in totality and the air of a month alone (totality_error_mag)
  std::optional<double> V_error = {};
  std::optional<BrightnessSeen> seen = {};
};

/// Standard error of the V magnitude of a totally eclipsed Moon in the air of its month [mag].
///
///     σ² = (0.23 mag)² + (50 mag δτ)²       δτ: error of the stratosphere's optical depth
///
/// 0.23 is what is left of five eclipses that instruments measured, weather included; 50 is how a total eclipse darkens
/// with that optical depth: 40 to 58 in eclipses of umbral magnitudes 1.01 to 1.61.
///
/// Given     year  with its fraction
/// Returned  nothing where the air is not that of its month, as it is known ("standard" or "calibrated" as they stand)
/// Accuracy  6 of 9 measured and observed eclipses lie within it and the observers' own 0.3 mag; 68 of 100 would
std::optional<double> totality_error_mag(const Air& air, double year);

/// Magnitudes of the whole Moon above the air, from the Earth's centre, [band].
///
/// Accuracy  0.003 mag, of a disc of 180 rows
std::vector<double> magnitudes_above(const LitMoon& moon);

/// Brightness by a simulation, summed over a texture of 360 rows.
///
/// Given   view   for its observer and air
/// Omits   the horizon, and flattening of the disc
/// Throws  Error  as light_on_the_moon, normal_albedo, view_of
MoonBrightness brightness_of(const MoonRequest& moon, const almanac::SkyState& sky,
                             const ViewRequest& view = {}, const algebra::Progress& progress = {});

/// Moments at even steps, the last of them not after `to`.
///
/// Given   step_min  0.01 to 1440 minutes
/// Throws  Error     for another step; when `to` is before `from` or more than a day after it
std::vector<almanac::Instant> moments_between(const almanac::Instant& from,
                                              const almanac::Instant& to, double step_min);

/// Brightness of the whole Moon over time: numbers by the names of their columns, one for each moment. One that is not
/// known then is NaN.
///
///     B_magnitude … R_magnitude, mean_luminance_cd_m2, illuminance_lx     above the air; a magnitude may be infinite
///     V_error                                                             as MoonBrightness has it
///     altitude_deg, azimuth_deg                                           as a place sees it, while it is up
///     seen_B_magnitude … seen_illuminance_lx                              the same through the air of the place
///     seen_level_illuminance_lx                                           on level ground
///     sky_cd_m2                                                           of the clear sky around the Moon
struct LightCurve {
  using Column = std::pair<std::string, std::vector<double>>;

  std::vector<almanac::Instant> moments;
  std::vector<Column> columns;
};

/// Light curve of an eclipse, from one simulation, over textures of 180 rows.
///
/// Given     moments  in order of time, one or more, within a day; also before P1 and after P4
///           view     for its observer and air; without an observer there are no columns of a place
/// Accuracy  0.003 mag, and as much of the light, from brightness_of
/// Throws    Error    when no eclipse is under way between them; as normal_albedo, air_over
LightCurve light_curve(const MoonRequest& moon, const std::vector<almanac::Instant>& moments,
                       const ViewRequest& view = {}, const algebra::Progress& progress = {});

/// Whole Moon of one eclipse, measured at any of its moments: from the Earth's centre.
class MoonSurvey {
 public:
  /// Given  albedo  normal, of as many rows as its textures get
  ///        light   on the Moon's way, for as long as the survey
  ///        meter   its channels
  MoonSurvey(const MoonRequest& moon, const algebra::Grid<float>& albedo, const Moonlight& light,
             Photometer meter = photometer());

  /// Texture in the meter's channels.
  texture::Image texture(const almanac::SkyState& sky) const;

  /// Of a survey in the photometer's channels.
  DiscBrightness brightness(const almanac::SkyState& sky) const;

 private:
  surface::Photometry photometry_;
  Photometer meter_;
  algebra::Grid<float> albedo_;
  std::shared_ptr<const surface::Ground> ground_;
  const Moonlight& light_;
  shadow::ChannelWeights weights_;
  shadow::Lookup shadowed_, sunlit_;
};

}  // namespace coppermoon::uses
