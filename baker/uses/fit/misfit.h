// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "uses/fit/fit.h"

namespace coppermoon::uses {

/// Likely reason for a misfit.
enum class Suspect {
  instant,     ///< wrong time of one photograph
  exposure,    ///< wrong exposure of one photograph
  colours,     ///< wrong camera response or white balance: most of the misfit is in one channel
  clock,       ///< wrong clock: misfits lie at the umbra's edge, or change between photographs
  tone_curve,  ///< wrong tone curve: much of the misfit lies outside the umbra
  air          ///< unsuitable air: misfits are alike in all photographs that show the umbra
};

/// Names of the suspects, in the order of the enumeration.
inline constexpr std::array<std::string_view, 6> suspect_names{"instant", "exposure",   "colours",
                                                               "clock",   "tone curve", "air"};

/// Likely reason for a misfit, and the photograph and channel with the largest misfit.
struct Suspicion {
  Suspect suspect;
  Misfit worst;                         ///< misfit whose χ² exceeds its expected value most
  std::vector<std::size_t> mirrored{};  ///< indices of mirrored pictures, unless all are mirrored
};

/// Name of the part of the shadow at a distance from its axis: "umbra", "edge of the umbra" or "penumbra".
const char* part_of_shadow(double axis_distance_km);

/// Likely reason why a fit's χ² is too large. It is judged by how misfits depend on the photograph, the channel and the
/// distance from the shadow's axis.
///
/// Returned  nothing if there are no photographs, or if χ² is no larger than expected
std::optional<Suspicion> suspicion_of(const FitReport& report);

}  // namespace coppermoon::uses
