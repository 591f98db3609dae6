// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "algebra/described.h"
#include "algebra/grid.h"

namespace coppermoon::uses {

/// A band of astronomical photometry.
struct PhotometricBand {
  std::string name;
  double solar_magnitude;  ///< of the Sun at 1 au
};

/// Place of V among the bands.
inline constexpr std::size_t V_band = 1;

/// B, V (Johnson) and R (Cousins).
///
/// Source  V = −26.76, B − V = 0.653, V − R = 0.356: Ramírez et al. (2012), ApJ 752, 5; Willmer
///         (2018), ApJS 236, 47
std::vector<PhotometricBand> photometric_bands();

/// Numbers of the bands by their names.
///
/// Given  numbers  [band]; empty: of no band
algebra::ByName<double> by_band(const std::vector<double>& numbers);

/// Response of these bands to irradiance, [band][wavelength band], peak 1 times the width [nm].
///
/// Given  edges_nm  380 to 780
/// Omits  the part of R beyond 780 nm, 6 % of it
/// Source Bessell (1990), PASP 102, 1181
algebra::Grid<double> photometric_response(std::span<const double> edges_nm);

}  // namespace coppermoon::uses
