// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "uses/study/fit_air.h"
#include "uses/study/fit_photograph.h"

namespace coppermoon::uses {

/// A photograph's scale, and the errors of its exposure and colours.
struct PhotometricErrors {
  std::optional<double> value_per_cd_m2;  ///< photograph's value of 1 cd/m²; without: any
  double exposure_error = 0.1;            ///< standard error of the exposure's logarithm
  double white_balance_error = 0.03;      ///< the same of red and of blue over green
};

/// A photograph as a witness of the air.
///
/// The logarithms of what bins and channels hold are compared. Each has the error of its own scatter,
/// and 0.3 % of its value and 0.1 % of the bin's brightest, which the map of the Moon and the
/// computation leave open; all together share the errors of exposure and colours.
///
/// Given   scene  must outlive what is returned
/// Throws  Error  when fewer than six numbers are neither clipped nor lost in noise
Witness witness_of(const FitScene& scene, const BinnedPhotograph& photograph,
                   const PhotometricErrors& errors);

}  // namespace coppermoon::uses
