// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "uses/fit/fit.h"

namespace coppermoon::uses {

/// Likely reason of a misfit.
enum class Suspect {
  instant,     ///< of one photograph
  exposure,    ///< of one photograph
  colours,     ///< one channel of most photographs: the camera's response, or its white balance
  clock,       ///< differences are at the umbra's edge, or change from photograph to photograph
  tone_curve,  ///< differences are beyond the umbra too
  air          ///< differences are alike in all photographs of the umbra
};

/// Names of suspects, in their order.
inline constexpr std::array<std::string_view, 6> suspect_names{"instant", "exposure",   "colours",
                                                               "clock",   "tone curve", "air"};

/// Likely reason of a misfit, and the photograph and channel that misfit most.
struct Suspicion {
  Suspect suspect;
  Misfit worst;                         ///< photograph and channel with the largest part of χ²
  std::vector<std::size_t> mirrored{};  ///< photographs, where not all are
};

/// Part of the shadow at a distance from its axis: "umbra", "edge of the umbra", "penumbra".
const char* part_of_shadow(double axis_distance_km);

/// Likely reason of a misfit, by its pattern over photographs, channels and distances from the shadow's axis.
///
/// Returned  nothing without photographs, or where χ² is what errors make it
std::optional<Suspicion> suspicion_of(const FitReport& report);

}  // namespace coppermoon::uses
