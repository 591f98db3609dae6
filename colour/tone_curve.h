// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace coppermoon::colour {

/// Numbers that a camera's tone curve has: of three principal components, and of what those leave at even
/// levels.
inline constexpr std::size_t tone_components = 3, tone_levels = 16,
                             tone_numbers = tone_components + tone_levels;

/// How a camera's JPEG stands for light: each number in standard deviations over cameras, so before
/// anything is known each is 0 ± 1, and all 0 is the mean of cameras.
///
///     ln(scene / displayed) = m(v) + Σ a_k p_k(v) + Σ b_j r_j(v)
///
/// with v the coded level, displayed the light that sRGB says of it, m and p_k the mean and the principal
/// components over cameras, r_j a tent of 0.025 about one of sixteen levels. Scene light is in a unit
/// in which level 0.5 is what sRGB says: the curve says nothing of exposure.
///
/// Accuracy  of five cameras that are not in the table, levels 0.05 to 0.93: 0.025 RMS with the three
///           components alone
/// Omits     local contrast, saturation of colours, mixing of channels
/// Source    data/camera_tone_curves.csv, after the model of Grossberg & Nayar (2004), IEEE Trans. PAMI 26,
///           1272: mean and principal components of measured curves
struct ToneCurve {
  std::array<double, tone_numbers> numbers{};
};

/// Range of displayed light for which curves are known: levels 0.047 to 0.93. Below, they were measured of few
/// cameras; above, cameras let highlights run into white.
inline constexpr double least_displayed = 0.00364, most_displayed = 0.8481;

/// Logarithm of scene light over displayed light.
///
/// Given  displayed  0 to 1; below level 0.047 as there
double tone_logarithm(const ToneCurve& curve, double displayed);

/// Derivative of tone_logarithm by each number of the curve.
std::array<double, tone_numbers> tone_derivatives(double displayed);

/// Tone curve as a table, for pixels.
class ToneTable {
 public:
  explicit ToneTable(const ToneCurve& curve);
  /// Scene light of displayed light.
  ///
  /// Given     displayed  values below 0 stay, those above 1 count as 1
  /// Accuracy  1e-3
  float operator()(float displayed) const;

 private:
  std::vector<float> factors_;  // by the square root of displayed light
};

}  // namespace coppermoon::colour
