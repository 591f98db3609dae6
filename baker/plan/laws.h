// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace coppermoon::plan {

/// Value of a setting, and the relative error of luminance that it causes.
struct LawPoint {
  double setting, error;
};

/// Relative error of luminance due to each setting alone: the 95th percentile over scenes in which the Moon's disc
/// reaches into the umbra. It was measured for sixty random eclipses in random air, relative to the finest settings. A
/// hundred planned runs check all settings together (tests/end_to_end/planned_runs). With few bands, the errors of Rec.
/// 709 red and green are about twice as large.
inline constexpr std::array<LawPoint, 7> law_of_bands{
    {{10, 0.035}, {24, 9.5e-3}, {32, 3e-3}, {48, 1e-3}, {80, 1.3e-4}, {200, 6e-5}, {400, 1e-6}}};
inline constexpr std::array<LawPoint, 7> law_of_rays{{{60, 0.03},
                                                      {100, 0.012},
                                                      {200, 4e-3},
                                                      {300, 1.6e-3},
                                                      {600, 3e-4},
                                                      {1000, 1e-4},
                                                      {2000, 3e-5}}};
inline constexpr std::array<LawPoint, 5> law_of_sun_terms{
    {{1, 0.03}, {2, 3e-3}, {3, 3e-4}, {4, 1.2e-4}, {6, 1e-7}}};
inline constexpr std::array<LawPoint, 5> law_of_planes{
    {{1, 0.03}, {2, 7e-4}, {3, 2.5e-4}, {5, 8e-5}, {9, 2e-5}}};
inline constexpr std::array<LawPoint, 8> law_of_place_error{{{3e-5, 2e-5},
                                                             {1e-4, 9e-5},
                                                             {3e-4, 6e-4},
                                                             {1e-3, 1.5e-3},
                                                             {3e-3, 5e-3},
                                                             {0.01, 0.012},
                                                             {0.03, 0.02},
                                                             {0.1, 0.11}}};

/// Error at a given value of a setting. Between and beyond the points of a law, it is interpolated and extrapolated
/// linearly in the logarithms of value and error.
double law(std::span<const LawPoint> points, double setting);

}  // namespace coppermoon::plan
