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

/// The Moon of one moment.
struct NightLight {
  std::string name;  ///< of the contact
  almanac::Instant when;
  double V_magnitude;           ///< of the whole Moon, above the air
  double mean_luminance_cd_m2;  ///< of the disc, above the air
  double faintest_star;         ///< V, by the naked eye, under the sky of the place
};

/// How a phase of the eclipse is exposed.
struct PhaseExposure {
  std::string phase;  ///< "full Moon", "partial, half", "middle of totality, L = 2"
  almanac::Instant when;
  std::optional<double> lit_s;  ///< for what the Sun still lights; in totality for the whole disc
  std::optional<double> shadow_s;  ///< for what is in the umbra, while some is not
};

/// What light there is in a night.
struct NightLights {
  std::vector<NightLight> moments = {};  ///< of each contact, and the greatest phase
  std::vector<PhaseExposure> exposures = {};
  double f_number = 0, iso = 0;  ///< of the exposures
};

/// The brightness of an eclipse at its contacts, and exposure times for its phases, from one simulation of
/// the whole of it; with `danjon`, the middle of totality for L = 0 to 4 too.
///
/// Exposes the brightest hundredth of what is lit to 0.8 of saturation; the middle of the umbra's part, while the
/// Sun lights the other, to 0.18. Below the horizon exposures are those of a Moon in the
/// zenith.
///
/// Given   moon  its light as exact as exposures need: some percent will do
///         view  of which the observer and the air above are asked for
///         development  f-number, speed and camera
/// Throws  Error  as light_on_the_way, normal_albedo, exposures_for
NightLights night_lights(const Circumstances& night, const MoonRequest& moon,
                         const ViewRequest& view, const Development& development, bool danjon,
                         const algebra::Progress& progress = {});

/// The time nearest to one that a camera can be set to, by thirds of a stop as they are marked, 1/8000 to
/// 30 s; a longer one as it is.
double camera_time_s(double seconds);

}  // namespace coppermoon::uses
