// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "verbs/fit_photograph.h"
#include "verbs/fit_posterior.h"

namespace coppermoon::verbs {

/// A photograph that speaks of the air, and the scene it is of.
struct Witness {
  const FitScene* scene;
  PhotographFit fit;
};

/// What some photographs of one air say of it.
struct AirFit {
  Posterior posterior;  ///< of the logarithm of dust [1/m], cloud cover, ozone [DU]
  std::size_t numbers;  ///< that were compared
};

/// The air that explains all of them best. Where even that is further off than the errors say, all
/// errors are taken to be as much larger.
AirFit fitted_air(std::span<const Witness> witnesses);

}  // namespace coppermoon::verbs
