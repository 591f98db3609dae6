// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "colour/tone_curve.h"
#include "uses/night/circumstances.h"
#include "uses/picture/development.h"

namespace coppermoon::verbs {

/// Relative error in words: "within 0.3 %", or "wrong by more than the light itself" above 1.
std::string within(double relative_error);

/// Fraction in percent, to two digits: "0.3 %".
std::string in_percent(double share);

/// Number to three digits, without an exponent: "5180", "0.0123".
std::string three_digits(double number);

/// Duration in the unit that people would use: "1.2 s", "14 min", "3 h", "1.3 years".
std::string duration(double seconds);

/// Exposure time as cameras show it: "1/3200 s", "0.5 s", "4 s".
std::string exposure_in_words(double seconds);

/// Exposure times of a picture; for a composite "1/500 s and 4 s".
std::string exposure_in_words(const uses::Exposures& exposures);

/// One-line warning that the sky outshines the Moon.
///
/// Given  sky_over_moon  ratio of the sky's luminance to the Moon's
std::string bright_sky_in_words(double sky_over_moon);

/// One line saying that the Moon cannot be seen against its sky, and from or until when it can; nothing if it can be
/// seen.
///
/// Given  night  must include the times at which the Moon is seen (uses::as_seen)
std::optional<std::string> unseen_in_words(const uses::Circumstances& night,
                                           const almanac::Instant& when);

/// How a camera's tone curve differs from the mean one: "+0.40, +0.13, +0.23 standard deviations of cameras".
std::string in_words(const colour::ToneCurve& curve);

/// Warning about a tone curve unlike that of any camera; empty for a plausible one.
std::string doubt_of(const colour::ToneCurve& curve);

/// How a tone curve differs from the mean one, per component [standard deviations].
std::vector<double> components_of(const colour::ToneCurve& curve);

}  // namespace coppermoon::verbs
