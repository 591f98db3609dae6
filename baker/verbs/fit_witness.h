// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "verbs/fit_air.h"
#include "verbs/fit_photograph.h"

namespace coppermoon::verbs {

/// How far a photograph's exposure and colours may be believed.
struct Belief {
  std::optional<double> value_per_cd_m2;  ///< photograph's; without: any
  double exposure_error = 0.1;            ///< standard, of the logarithm
  double white_balance_error = 0.03;      ///< the same, of red and of blue over green
};

/// What a photograph says of the air.
///
/// Logarithms are compared, of what bins and channels hold; each knows its own scatter and 0.3 % (and
/// 0.1 % of the bin's brightest) of what a map of the Moon and the computation do not, and all
/// together share the exposure's and the colours' errors.
///
/// Given   scene  must outlive what is returned
/// Throws  Error  when fewer than six numbers are neither clipped nor lost in noise
Witness witness_of(const FitScene& scene, const BinnedPhotograph& photograph, const Belief& belief);

}  // namespace coppermoon::verbs
