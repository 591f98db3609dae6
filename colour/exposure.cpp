// SPDX-License-Identifier: MIT
#include "colour/exposure.h"

#include "algebra/error.h"

namespace coppermoon::colour {

double exposure_scale(const Exposure& exposure) {
  const auto& [t, N, S] = exposure;
  algebra::require_within("exposure time [s]", t, 1e-6, 1e6);
  algebra::require_within("f-number", N, 0.5, 512);
  algebra::require_within("ISO speed", S, 1, 1e7);
  // FAULT exposure 1 % off: q = 0.65 => q = 0.6565
  constexpr double q = 0.65;
  return q * t * S / (saturation_exposure_lx_s * N * N);
}

}  // namespace coppermoon::colour
