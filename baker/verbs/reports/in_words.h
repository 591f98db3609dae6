// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "colour/tone_curve.h"
#include "uses/night/circumstances.h"
#include "uses/picture/development.h"

namespace coppermoon::verbs {

/// A relative error in words, such as "within 0.3 %" or, if it exceeds 1, "wrong by more than the light itself".
std::string within(double relative_error);

/// A fraction in per cent, rounded to two significant digits, such as "0.3 %".
std::string in_percent(double share);

/// A number rounded to three significant digits, without an exponent, such as "5180" or "0.0123".
std::string three_digits(double number);

/// A duration in the unit that people would use, such as "1.2 s", "14 min", "3 h" or "1.3 years".
std::string duration(double seconds);

/// An exposure time as cameras show it, such as "1/3200 s", "0.5 s" or "4 s".
std::string exposure_in_words(double seconds);

/// Exposure time of a picture, or both exposure times of a composite, such as "1/500 s and 4 s".
std::string exposure_in_words(const uses::Exposures& exposures);

/// One-line warning that the sky is brighter than the Moon.
///
/// Given  sky_over_moon  ratio of the sky's luminance to the Moon's
std::string bright_sky_in_words(double sky_over_moon);

/// One-line message that the sky hides the Moon, and when the Moon can be seen; absent if it can be seen at `when`.
///
/// Given  night  must include the times at which the Moon is seen (uses::as_seen)
std::optional<std::string> unseen_in_words(const uses::Circumstances& night,
                                           const almanac::Instant& when);

/// Principal components of a tone curve (components_of), "+0.40, +0.13, +0.23 standard deviations of cameras".
std::string in_words(const colour::ToneCurve& curve);

/// Warning that a fitted tone curve is unlike that of any camera; empty if the curve is plausible.
std::string doubt_of(const colour::ToneCurve& curve);

/// A tone curve's difference from the mean curve of cameras, as principal components [standard deviations].
std::vector<double> components_of(const colour::ToneCurve& curve);

}  // namespace coppermoon::verbs
