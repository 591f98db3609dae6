// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "colour/tone_curve.h"
#include "uses/night/circumstances.h"
#include "uses/picture/development.h"

namespace coppermoon::verbs {

/// Relative error in words: "within 0.3 %"; above 1 "wrong by more than the light itself".
std::string within(double relative_error);

/// Share in percent, to two digits: "0.3 %".
std::string in_percent(double share);

/// Number to three digits, without an exponent: "5180", "0.0123".
std::string three_digits(double number);

/// Duration in the unit that people would use: "1.2 s", "14 min", "3 h", "1.3 years".
std::string duration(double seconds);

/// Exposure time as cameras show it: "1/3200 s", "0.5 s", "4 s".
std::string exposure_in_words(double seconds);

/// Exposure times of a picture; of a composite "1/500 s and 4 s".
std::string exposure_in_words(const uses::Exposures& exposures);

/// Warning of a sky that outshines the Moon, in one line.
///
/// Given  sky_over_moon  luminance of the sky over the Moon's
std::string bright_sky_in_words(double sky_over_moon);

/// Line on a Moon that cannot be seen in its sky, and from when it can, or until when it could; nothing where it is seen.
///
/// Given  night  with the times in which the Moon is seen (uses::as_seen)
std::optional<std::string> unseen_in_words(const uses::Circumstances& night,
                                           const almanac::Instant& when);

/// Difference of a camera's tone curve from the mean one: "+0.40, +0.13, +0.23 standard deviations of cameras".
std::string in_words(const colour::ToneCurve& curve);

/// Warning of a tone curve that no camera has; empty for others.
std::string doubt_of(const colour::ToneCurve& curve);

/// Differences of a tone curve from the mean one [standard deviations].
std::vector<double> components_of(const colour::ToneCurve& curve);

}  // namespace coppermoon::verbs
