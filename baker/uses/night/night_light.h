// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "uses/night/eclipse_light.h"
#include "uses/picture/development.h"

namespace coppermoon::uses {

/// Brightness of the Moon at a moment of its night.
struct NightLight {
  std::string name;  ///< of the moment
  almanac::Instant when;
  double V_magnitude;                    ///< of the whole Moon, above the air
  double mean_luminance_cd_m2;           ///< of the disc, above the air
  std::optional<double> faintest_star;   ///< V magnitude, for the naked eye under the sky of the
                                         ///< place; none where a star of magnitude 0 is not seen
  std::optional<double> sky_cd_m2 = {};  ///< at the Moon; none of a Moon that is not up
};

/// Exposure time of a part of the Moon, and the times of a brighter and a darker Moon: the standard error in totality.
struct PartExposure {
  double time_s, least_s, most_s;
  double stops_under = 0;  ///< below what the part asks for, where it would trail
};

/// Exposure times for a phase of the eclipse.
struct PhaseExposure {
  std::string phase;  ///< "full Moon, before P1", "partial, half", "middle of totality, L = 2"
  almanac::Instant when;
  bool seen = true;  ///< the Moon stands out from its sky; no time without
  double sky_over_moon = 0;
  std::optional<PartExposure> lit{};     ///< the part outside the umbra; in totality the disc
  std::optional<PartExposure> shadow{};  ///< the part in the umbra, during the partial phase
  bool too_dark = false;  ///< a part has no time, as it would be longer than the whole eclipse
  bool by_sky = false;    ///< the sky's light makes a time shorter, by a third of a stop or more
};

/// Brightness and exposure times of an eclipse.
struct NightLights {
  Circumstances night;  ///< with the times in which the Moon is seen
  std::vector<NightLight> moments =
      {};  ///< of each contact, the greatest phase, first and last seen
  std::vector<PhaseExposure> exposures = {};
  double f_number = 0, iso = 0;           ///< of the exposures
  std::optional<double> V_error = {};     ///< standard error of V in totality (totality_error_mag)
  std::optional<double> trailing_s = {};  ///< none without a focal length
};

/// Brightness of an eclipse at its contacts, and exposure times for its phases while all of the Moon is above the horizon,
/// from one simulation of the whole eclipse; with `danjon`, times for the middle of totality at L = 0 to 4 too.
///
/// Exposes the Moon through the place's air, with the sky's light before it: by the automatic rule of exposures_for, and
/// the median of the part in the umbra, during the partial phase, to 0.18. No time lets the sky pass half of saturation, or
/// the Moon trail by two pixels, of the camera or of 4 µm, where a focal length is given.
///
/// Given   moon  a tolerance of some percent of light is enough for exposures
///         view  for its observer, the air above and the focal length
///         development  f-number, speed and camera
/// Throws  Error  as light_on_the_way, normal_albedo, exposures_for
NightLights night_lights(const Circumstances& night, const MoonRequest& moon,
                         const ViewRequest& view, const Development& development, bool danjon,
                         const algebra::Progress& progress = {});

/// Nearest time of those that cameras mark in thirds of a stop, 1/8000 to 30 s; a time above 34 s as it is.
double camera_time_s(double seconds);

/// Time in which the Moon at greatest eclipse trails across the sensor of a camera that does not follow it [s].
///
///     t = trail / (focal length · the Moon's angular speed in the place's sky)
///
/// Given   trail_um  length of the trail on the sensor
/// Throws  Error     when the focal length is outside 1 to 1e6 mm
double trailing_time_s(const Circumstances& night, double focal_length_mm, double trail_um);

/// V magnitude of the faintest star that the naked eye sees near the zenith.
///
///     7.93 − 5 lg(1 + 10^(4.316 − B/5))        B: the sky's magnitude for each square arc second
///
/// Given     sky_cd_m2  luminance of the sky, above 0
/// Accuracy  0.5 between observers
/// Source    Schaefer (1990), PASP 102, 212, after Knoll, Tousey & Hulburt (1946)
double faintest_star(double sky_cd_m2);

}  // namespace coppermoon::uses
