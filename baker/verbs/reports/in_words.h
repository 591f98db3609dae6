// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "colour/tone_curve.h"
#include "uses/picture/development.h"

namespace coppermoon::verbs {

/// An error over the value: "within 0.3 %". Above 1 it is "wrong by more than the light itself".
std::string within(double relative_error);

/// A share in percent, to two digits: "0.3 %".
std::string in_percent(double share);

/// A number to three digits, without an exponent: "5180", "0.0123".
std::string three_digits(double number);

/// How long something takes, in the unit that people would use: "1.2 s", "14 min", "3 h", "1.3 years".
std::string duration(double seconds);

/// An exposure time as cameras show it: "1/3200 s", "0.5 s", "4 s".
std::string exposure_in_words(double seconds);

/// The same for a picture; of a composite "1/500 s and 4 s".
std::string exposure_in_words(const uses::Exposures& exposures);

/// Warning of a sky that outshines the Moon, in one line.
///
/// Given  sky_over_moon  how many times as bright it is
std::string bright_sky_in_words(double sky_over_moon);

/// How a camera's tone curve differs from the mean one: "+0.40, +0.13, +0.23 standard deviations of
/// cameras".
std::string in_words(const colour::ToneCurve& curve);

/// A line of warning about a tone curve that no camera has; empty for others.
std::string doubt_of(const colour::ToneCurve& curve);

/// The same numbers.
std::vector<double> components_of(const colour::ToneCurve& curve);

}  // namespace coppermoon::verbs
