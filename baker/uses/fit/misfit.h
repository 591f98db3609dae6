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
  instant,     ///< one photograph's instant
  exposure,    ///< one photograph's exposure
  colours,     ///< one channel in most photographs: the camera's response or white balance
  clock,       ///< differences lie at the umbra's edge or change from photograph to photograph
  tone_curve,  ///< differences extend beyond the umbra
  air          ///< differences are alike in all photographs that show the umbra
};

/// Names of the suspects, in the order of the enumeration.
inline constexpr std::array<std::string_view, 6> suspect_names{"instant", "exposure",   "colours",
                                                               "clock",   "tone curve", "air"};

/// Likely reason for a misfit, and the photograph and channel with the largest misfit.
struct Suspicion {
  Suspect suspect;
  Misfit worst;                         ///< photograph and channel with the largest part of χ²
  std::vector<std::size_t> mirrored{};  ///< mirrored photographs, if not all are
};

/// Name of the part of the shadow at a distance from its axis: "umbra", "edge of the umbra" or "penumbra".
const char* part_of_shadow(double axis_distance_km);

/// Likely reason why a fit's χ² is too large, judged by how misfits depend on photograph, channel and distance from the
/// shadow's axis.
///
/// Returned  nothing if there are no photographs, or if χ² is no larger than expected
std::optional<Suspicion> suspicion_of(const FitReport& report);

}  // namespace coppermoon::uses
