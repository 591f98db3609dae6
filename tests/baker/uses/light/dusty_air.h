// SPDX-License-Identifier: MIT
#pragma once

#include "uses/light/moonlight.h"

namespace coppermoon::uses {

/// The paper's air with dust in it: the sharpest edges that light has.
inline LightRequest dusty_air_of_the_paper(double tolerance) {
  LightRequest request;
  request.air.atmosphere = "paper";
  request.air.column.dust_extinction_per_m = 4.7e-6;
  request.wish.tolerance = tolerance;
  return request;
}

}  // namespace coppermoon::uses
