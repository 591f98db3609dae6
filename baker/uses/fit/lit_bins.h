// SPDX-License-Identifier: MIT
#pragma once

#include "uses/fit/fit_scene.h"
#include "uses/fit/light_in_bins.h"

namespace coppermoon::uses {

/// The bins of a scene at another moment: the same ground, elsewhere in the shadow. A few places represent all the
/// ground in a bin.
LitBins lit_bins(const FitScene& scene, const almanac::SkyState& sky);

}  // namespace coppermoon::uses
