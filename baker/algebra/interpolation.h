// SPDX-License-Identifier: MIT
#pragma once

#include <span>

namespace coppermoon::algebra {

/// Straight lines between the points (x, y), the end values held outside.
///
/// Given  x  increasing; y: as many; at: where
double interpolated(std::span<const double> x, std::span<const double> y, double at);

/// The mean of the piecewise linear function through (x, y) over [from, to], the end values held
/// outside.
double mean_between(std::span<const double> x, std::span<const double> y, double from, double to);

}  // namespace coppermoon::algebra
