// SPDX-License-Identifier: MIT
#pragma once

#include "verbs/light_options.h"

namespace coppermoon::verbs {

/// The paper's air with dust in it: the sharpest edges that light has.
inline LightOptions dusty_air_of_the_paper(const char* tolerance) {
  LightOptions options;
  options.air.atmosphere = "paper";
  options.air.column.dust_extinction_per_m = 4.7e-6;
  options.plan.tolerance = tolerance;
  return options;
}

}  // namespace coppermoon::verbs
