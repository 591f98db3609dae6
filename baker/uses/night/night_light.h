// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "algebra/described.h"
#include "uses/night/eclipse_light.h"
#include "uses/picture/development.h"

namespace coppermoon::uses {

/// Brightness of the Moon and its sky at one moment of a night.
struct NightLight {
  std::string name;  ///< such as "U2" or "first seen"
  almanac::Instant when;
  double V_magnitude;                    ///< of the whole Moon, without the effect of air
  double mean_luminance_cd_m2;           ///< of the disc, without the effect of air
  std::optional<double> faintest_star;   ///< V magnitude, as seen by eye; absent if below 0
  std::optional<double> sky_cd_m2 = {};  ///< in the Moon's direction; absent if the Moon is down
};

/// Exposure time for a part of the Moon, and its range for one standard error of the light forecast in the umbra.
struct PartExposure {
  double time_s, least_s, most_s;
  double stops_under = 0;  ///< stops of underexposure that are needed to avoid trailing
};

/// Exposure times for a phase of the eclipse.
struct PhaseExposure {
  std::string phase;  ///< such as "full Moon, before P1" or "middle of totality, L = 2"
  almanac::Instant when;
  bool seen = true;  ///< whether the Moon stands out from the sky; if not, there are no times
  double sky_over_moon = 0;
  std::optional<PartExposure> lit{};  ///< for the part outside the umbra; in totality, for the disc
  std::optional<PartExposure> shadow{};  ///< for the part in the umbra, during the partial phase
  bool too_dark = false;  ///< whether a part would need a time longer than the whole eclipse
  bool by_sky = false;    ///< whether the sky's light shortens a time by 1/3 of a stop or more
};

/// Describes a part's exposure time, its range due to the forecast's error, and the underexposure that avoids trailing.
template <class Field>
void describe_part(Field&& is, const std::string& name, const std::optional<PartExposure>& part) {
  namespace unit = algebra::unit;
  using Range = std::array<double, 2>;
  is(name + "_s", part ? std::optional(part->time_s) : std::nullopt, unit::seconds,
     "its exposure time");
  is(name + "_range_s",
     algebra::if_any(part ? std::optional(Range{part->least_s, part->most_s}) : std::nullopt),
     unit::seconds, "times of a brighter and a darker Moon: the standard error in totality");
  is(name + "_stops_under",
     algebra::if_any(part && part->stops_under > 0 ? std::optional(part->stops_under)
                                                   : std::nullopt),
     unit::stops, "exposure below what the part asks for, where it would trail");
}

template <class Field>
void describe(Field&& is, const PhaseExposure& phase) {
  is.a("PhaseExposure", "Exposure times for a phase of the eclipse.");
  is("phase", phase.phase, "the phase");
  is("utc", phase.when, "its moment, UTC");
  is("seen", phase.seen, "whether the Moon stands out from its sky");
  is("sky_over_moon", phase.sky_over_moon, "luminance of the sky over the Moon's");
  is("by_sky", phase.by_sky, "whether the sky's light makes a time shorter");
  describe_part(is, "lit", phase.lit);
  describe_part(is, "umbra", phase.shadow);
  is("too_dark", algebra::if_any(phase.too_dark ? std::optional(true) : std::nullopt),
     "true where the exposure would be longer than the whole eclipse");
}

/// Brightness of the Moon and exposure times for an eclipse.
struct NightLights {
  Circumstances night;  ///< includes the times when the Moon is seen
  std::vector<NightLight> moments =
      {};  ///< at the contacts, at greatest eclipse, and when the Moon is first and last seen
  std::vector<PhaseExposure> exposures = {};
  double f_number = 0, iso = 0;           ///< for which the exposure times hold
  std::optional<double> V_error = {};     ///< standard error of V in totality (totality_error_mag)
  std::optional<double> trailing_s = {};  ///< time to trail two pixels, if there is a focal length
};

/// Brightness of the Moon at an eclipse's contacts, and exposure times for the phases while all of it is above the
/// horizon, from one simulation of the whole eclipse. `danjon` adds times for mid-totality at L = 0 to 4.
///
/// The Moon is seen through the place's air, with the sky's light added. It is exposed by the automatic rule of
/// exposures_for. During the partial phase, the part in the umbra gets an exposure time of its own, which brings its
/// median to 0.18 of saturation. No time lets the sky exceed half of saturation. If a focal length is given, no time
/// lets the Moon trail by more than two pixels. If the width of pixels is unknown, it is taken as 4 µm.
///
/// Given   moon  may have a tolerance of some percent for the light
///         view  gives the observer, the air above, and the focal length
///         development  gives the f-number, speed and camera
/// Throws  Error  if light_on_the_way, normal_albedo or exposures_for does
NightLights night_lights(const Circumstances& night, const MoonRequest& moon,
                         const ViewRequest& view, const Development& development, bool danjon,
                         const algebra::Progress& progress = {});

/// The nearest exposure time that cameras offer, in thirds of a stop from 1/8000 to 30 s. Above 34 s, the given time.
double camera_time_s(double seconds);

/// Time in which the Moon's image at greatest eclipse moves by a given length on the sensor of a fixed camera [s].
///
///     t = trail / (focal length · the Moon's angular speed in the place's sky)
///
/// Given   trail_um  length of the trail on the sensor
/// Throws  Error     if the focal length is outside 1 to 1e6 mm
double trailing_time_s(const Circumstances& night, double focal_length_mm, double trail_um);

/// V magnitude of the faintest star that the naked eye sees near the zenith.
///
///     7.93 − 5 lg(1 + 10^(4.316 − B/5))        B: the sky's magnitude per square arc second
///
/// Given     sky_cd_m2  luminance of the sky, above 0
/// Accuracy  0.5 mag, because observers differ
/// Source    Schaefer (1990), PASP 102, 212, after Knoll, Tousey & Hulburt (1946)
double faintest_star(double sky_cd_m2);

}  // namespace coppermoon::uses
