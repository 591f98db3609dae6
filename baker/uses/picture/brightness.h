// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "result/columns.h"
#include "uses/light/photometer.h"
#include "uses/picture/baked_moon.h"
#include "uses/picture/moon.h"
#include "uses/picture/view.h"

namespace coppermoon::uses {

/// Brightness of the whole Moon as seen from a place on the Earth, through the air there.
struct BrightnessSeen {
  almanac::Observer place;
  povray_scenes::HorizonPlace moon;    ///< the Moon's place in the sky, with refraction
  DiscBrightness disc;                 ///< brightness through the air
  std::vector<double> extinction_mag;  ///< extinction in each band; 0 if reddening is off
  double sky_cd_m2 = 0;                ///< luminance of the clear sky around the Moon
};

template <class Field>
void describe(Field&& is, const BrightnessSeen& seen) {
  namespace unit = algebra::unit;
  is.a("BrightnessSeen", "The whole Moon as a place on the Earth sees it, through its air.");
  is(
      "at", [&] { return place_text(seen.place); }, "the place: latitude, longitude, elevation");
  is("altitude_deg", seen.moon.altitude, unit::degrees, "altitude of the Moon, refraction counted");
  is("azimuth_deg", seen.moon.azimuth, unit::degrees,
     "azimuth of the Moon, from north through east");
  describe_magnitudes(is, seen.disc);
  is("extinction_mag", by_band(seen.extinction_mag), unit::mag,
     "magnitudes by which the air dims the Moon, by band");
  is(
      "reddening_b_v", [&] { return seen.extinction_mag[0] - seen.extinction_mag[1]; }, unit::mag,
      "reddening by the air: extinction in B less that in V");
  describe_light(is, seen.disc);
}

/// Brightness of the whole Moon at one moment.
struct MoonBrightness {
  almanac::Instant instant;
  DiscBrightness disc;           ///< brightness from the Earth's centre, without air
  std::optional<double> danjon;  ///< step on Danjon's scale, in totality only
  /// Standard error of the V magnitude, only in totality and with the aerosol recorded for the month.
  std::optional<double> V_error = {};
  std::optional<BrightnessSeen> seen = {};
};

template <class Field>
void describe(Field&& is, const MoonBrightness& brightness) {
  namespace unit = algebra::unit;
  is.a("Brightness", "The whole Moon, above the air and from the Earth's centre.");
  is("instant", brightness.instant, "the moment, UTC");
  describe_magnitudes(is, brightness.disc);
  is("V_error", brightness.V_error, unit::mag,
     "standard error of the V magnitude, in totality and the air of a month; else none");
  describe_light(is, brightness.disc);
  is("danjon", brightness.danjon, "step of Danjon's scale, 0 to 4, in totality; else none");
  is("seen", brightness.seen, "what a place sees; none without a place");
}

/// Standard error [mag] of the V magnitude computed for a totally eclipsed Moon and the aerosol recorded for the month.
///
///     σ² = (0.23 mag)² + (50 mag δτ)²       δτ: error in the stratosphere's optical depth
///
/// 0.23 mag is the residual for five eclipses measured with instruments, and includes the effect of weather. The Moon
/// darkens by 50 mag per unit of optical depth (40 to 58 mag in eclipses of umbral magnitudes 1.01 to 1.61).
///
/// Given     year  with a fractional part
/// Returned  nothing unless the air is the atmosphere "standard" or "calibrated", without changes
/// Accuracy  6 of 9 observed eclipses agree within this error and the observers' 0.3 mag combined; 68 % is expected
std::optional<double> totality_error_mag(const Air& air, double year);

/// Magnitude of the whole Moon in each photometric band, as seen from the Earth's centre, without air.
///
/// Accuracy  0.003 mag, with a texture of 180 rows
std::vector<double> magnitudes_above(const LitMoon& moon);

/// Simulates the Moon and sums its brightness over a texture of 360 rows.
///
/// Given   view   only its observer and air are used
/// Omits   the horizon, and the flattening of the disc
/// Throws  Error  when light_on_the_moon, normal_albedo or view_of does
MoonBrightness brightness_of(const MoonRequest& moon, const almanac::SkyState& sky,
                             const ViewRequest& view = {}, const algebra::Progress& progress = {});

/// Evenly spaced moments that start at `from` and end at or before `to`.
///
/// Given   step_min  0.01 to 1440 minutes
/// Throws  Error     when the step is outside this range, or `to` is before `from` or more than a day after it
std::vector<almanac::Instant> moments_between(const almanac::Instant& from,
                                              const almanac::Instant& to, double step_min);

/// Illuminance from the Moon on level ground at the observer's place [lx].
double level_illuminance_lx(const BrightnessSeen& seen);

/// The Moon's brightness at one moment of a light curve.
struct CurveMoment {
  MoonBrightness brightness;
  bool of_place = true;              ///< whether the curve has an observer
  std::optional<std::string> local;  ///< date and time in the requested time zone
};

/// Describes the columns of a light curve at one moment. Unknown numbers are NaN. A black disc has infinite magnitudes.
template <class Field>
void describe(Field&& is, const CurveMoment& moment) {
  namespace unit = algebra::unit;
  const auto& [brightness, of_place, local] = moment;
  const auto& seen = brightness.seen;
  using Number = std::optional<double>;
  is.a("CurveMoment", "A moment of a light curve.");
  is("instant", brightness.instant, "the moment, UTC");
  is("local", algebra::if_any(local), "the same on the clocks that are asked for");
  describe_columns(is, &brightness.disc, "", ", above the air");
  is("V_error", brightness.V_error, unit::mag,
     "standard error of the V magnitude, in totality and the air of a month; else none");
  if (!of_place) return;
  is("altitude_deg", seen ? Number(in_degrees(seen->moon.altitude)) : Number(), unit::degrees,
     "altitude of the Moon while it is up, refraction counted");
  is("azimuth_deg", seen ? Number(in_degrees(seen->moon.azimuth)) : Number(), unit::degrees,
     "azimuth of the Moon while it is up, from north through east");
  describe_columns(is, seen ? &seen->disc : nullptr, "seen_", ", through the air of the place");
  is("seen_level_illuminance_lx", seen ? Number(level_illuminance_lx(*seen)) : Number(),
     unit::illuminance, "illuminance on level ground at the place");
  is("sky_cd_m2", seen ? Number(seen->sky_cd_m2) : Number(), unit::luminance,
     "luminance of the clear sky around the Moon");
}

struct LightCurve {
  std::vector<CurveMoment> moments;
  std::vector<result::Column> columns;  ///< the curve's numbers and their descriptions
};

/// Light curve of an eclipse, computed from one simulation and measured on textures of 180 rows.
///
/// Given     moments  one or more within a day, in order of time; they may be before P1 or after P4
///           view     only its observer and air are used; without an observer, columns for a place are left out
/// Accuracy  agrees with brightness_of to 0.003 mag in magnitudes, and to 0.3 % in illuminances
/// Throws    Error    when no eclipse falls within these moments, or when normal_albedo or air_over does
LightCurve light_curve(const MoonRequest& moon, const std::vector<almanac::Instant>& moments,
                       const ViewRequest& view = {}, const algebra::Progress& progress = {});

/// Measures the whole Moon at any moment of one eclipse, as seen from the Earth's centre.
class MoonSurvey {
 public:
  /// Given  albedo  normal albedo, with as many rows as the textures will have
  ///        light   the light along the Moon's path; must outlive the survey
  ///        meter   the photometer, which sets the channels of the textures
  MoonSurvey(const MoonRequest& moon, const algebra::Grid<float>& albedo, const Moonlight& light,
             Photometer meter = photometer());

  /// The Moon's texture at one moment, in the photometer's channels.
  texture::Image texture(const almanac::SkyState& sky) const;

  /// The Moon's brightness at one moment; only for a survey that was made with the default photometer.
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
