// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "uses/night/circumstances.h"
#include "uses/picture/development.h"
#include "uses/picture/moon.h"
#include "uses/picture/view.h"

namespace coppermoon::uses {

/// Brightness of the Moon at a contact, or at the greatest phase.
struct NightLight {
  std::string name;  ///< of the contact
  almanac::Instant when;
  double V_magnitude;                   ///< of the whole Moon, above the air
  double mean_luminance_cd_m2;          ///< of the disc, above the air
  std::optional<double> faintest_star;  ///< V magnitude, for the naked eye under the sky of the
                                        ///< place; none where a star of magnitude 0 is not seen
};

/// Exposure times for a phase of the eclipse.
struct PhaseExposure {
  std::string phase;  ///< "full Moon", "partial, half", "middle of totality, L = 2"
  almanac::Instant when;
  std::optional<double> lit_s{};     ///< for the part outside the umbra; in totality for the disc
  std::optional<double> shadow_s{};  ///< for the part in the umbra, during the partial phase
  bool too_dark = false;  ///< a part has no time, as it would be longer than the whole eclipse
};

/// Brightness and exposure times of an eclipse.
struct NightLights {
  std::vector<NightLight> moments = {};  ///< of each contact, and the greatest phase
  std::vector<PhaseExposure> exposures = {};
  double f_number = 0, iso = 0;        ///< of the exposures
  std::optional<double> V_error = {};  ///< standard error of V in totality (totality_error_mag)
};

/// Brightness of an eclipse at its contacts, and exposure times for its phases, from one simulation of the whole
/// eclipse; with `danjon`, times for the middle of totality at L = 0 to 4 too.
///
/// Exposes the 99th percentile of the luminance to 0.8 of saturation, and the median of the part in the umbra, during
/// the partial phase, to 0.18. A Moon below the horizon is exposed as from above the air.
///
/// Given   moon  a tolerance of some percent of light is enough for exposures
///         view  for its observer and the air above
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

}  // namespace coppermoon::uses
