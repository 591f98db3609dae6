// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

#include "algebra/grid.h"
#include "atmosphere/atmosphere.h"

namespace coppermoon::shadow {

/// Rows of wavelengths are padded to a multiple of this.
inline constexpr std::size_t waves_together = 8;

/// Adds light that is scattered at one point, by wavelength, with what the machine has of SIMD:
/// filter Σ scattered[k] spectra(k) exp(−Σ passed[k] spectra(k)).
///
/// Given  spectra  (absorber, wavelength); all rows padded, with zeros
///        scattered, passed  amounts, 0 or more
void add_scattered(const atmosphere::Amounts& scattered, const atmosphere::Amounts& passed,
                   const algebra::Grid<double>& spectra, std::span<const double> filter,
                   std::span<double> ratio);

}  // namespace coppermoon::shadow
