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

/// Brightness of the whole Moon at a place on the Earth, through its air.
struct BrightnessSeen {
  almanac::Observer place;
  povray_scenes::HorizonPlace moon;    ///< refraction included
  DiscBrightness disc;                 ///< through the air
  std::vector<double> extinction_mag;  ///< [band]; 0 without reddening
  double sky_cd_m2 = 0;                ///< of the clear sky around the Moon
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
  DiscBrightness disc;           ///< above the air, from the Earth's centre
  std::optional<double> danjon;  ///< of Danjon's scale, in totality alone
  /// standard error of the V magnitude, in totality and the air of a month alone (totality_error_mag)
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

/// Illuminance by the Moon on level ground at the place [lx].
double level_illuminance_lx(const BrightnessSeen& seen);

/// Brightness of one moment of a light curve.
struct CurveMoment {
  MoonBrightness brightness;
  bool of_place = true;              ///< the curve has an observer
  std::optional<std::string> local;  ///< date and time on clocks that are asked for
};

/// A number that is not known is NaN; a magnitude may be infinite.
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

/// Brightness of the whole Moon over time.
struct LightCurve {
  std::vector<CurveMoment> moments;
  std::vector<result::Column> columns;  ///< its numbers, as they are described
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
