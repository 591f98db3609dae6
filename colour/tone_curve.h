// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace coppermoon::colour {

/// Number of parameters of a camera's tone curve: three for principal components, and sixteen for the residuals at
/// evenly spaced levels.
inline constexpr std::size_t tone_components = 3, tone_levels = 16,
                             tone_numbers = tone_components + tone_levels;

/// Tone curve of a camera: how the levels in its JPEGs relate to light. Its numbers are in units of their standard
/// deviations among cameras, so they are 0 ± 1 for an unknown camera. If all are 0, it is the average camera's curve.
///
///     ln(scene / displayed) = m(v) + Σ a_k p_k(v) + Σ b_j r_j(v)
///
/// Here v is the coded level, and `displayed` is the light that sRGB gives it. a_k and b_j are the numbers. m and p_k
/// are the mean and the principal components of many cameras' curves. r_j is a triangle around one of sixteen levels;
/// its height is 0.4 at 0.04, 0.1 at 0.10, 0.04 at 0.16 and 0.025 above. Scene light is in a unit such that it equals
/// displayed light at level 0.5, so the curve does not depend on exposure.
///
/// Accuracy  0.025 RMS in the logarithm with the three components alone, for levels 0.05 to 0.93 of five cameras that
///           are not in the table
/// Omits     local contrast, colour saturation, mixing of channels
/// Source    data/camera_tone_curves.csv, after the model of Grossberg & Nayar (2004), IEEE Trans. PAMI 26, 1272: mean
///           and principal components of measured curves
struct ToneCurve {
  std::array<double, tone_numbers> numbers{};
};

/// Range of displayed light for which curves are known: levels 0.047 to 0.93. Below it, few cameras were measured;
/// above it, cameras let highlights fade to white.
inline constexpr double least_displayed = 0.00364, most_displayed = 0.8481;

/// Logarithm of the ratio of scene light to displayed light.
///
/// Given  displayed  0 to 1; levels below 0.047 count as 0.047
double tone_logarithm(const ToneCurve& curve, double displayed);

/// Derivatives of tone_logarithm with respect to each of the numbers in ToneCurve.
std::array<double, tone_numbers> tone_derivatives(double displayed);

/// A tone curve as a table, for fast conversion of pixels.
class ToneTable {
 public:
  explicit ToneTable(const ToneCurve& curve);
  /// Converts displayed light to scene light.
  ///
  /// Given     displayed  values below 0 stay as they are; values above 1 count as 1
  /// Accuracy  1e-3, relative
  float operator()(float displayed) const;

 private:
  std::vector<float> factors_;  // indexed by the square root of displayed light
};

}  // namespace coppermoon::colour
