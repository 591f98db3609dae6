// SPDX-License-Identifier: MIT
#pragma once

#include "uses/fit/fit_scene.h"
#include "uses/fit/light_in_bins.h"

namespace coppermoon::uses {

/// Bins of a scene's ground at another moment, when the same ground lies elsewhere in the shadow. A few places
/// represent all the ground in each bin.
LitBins lit_bins(const FitScene& scene, const almanac::SkyState& sky);

}  // namespace coppermoon::uses
