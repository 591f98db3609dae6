// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <span>

#include "verbs/fit_light.h"
#include "verbs/fit_posterior.h"

namespace coppermoon::verbs {

/// Numbers that speak of the air: a photograph's, or magnitudes.
struct Witness {
  const FittedLight* light;
  std::function<double(const algebra::Grid<double>& light)> chi_squared;
  std::size_t count;  ///< of those numbers
};

/// What some witnesses of one air say of it.
struct AirFit {
  Posterior posterior;  ///< of the logarithm of dust [1/m], cloud cover, ozone [DU]
  std::size_t numbers;  ///< that were compared
};

/// The air that explains all of them best. Where even that is further off than the errors say, all
/// errors are taken to be as much larger.
AirFit fitted_air(std::span<const Witness> witnesses);

}  // namespace coppermoon::verbs
