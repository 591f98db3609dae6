// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

#include "algebra/grid.h"
#include "atmosphere/atmosphere.h"

namespace coppermoon::shadow {

/// Wavelengths come in groups of this many: what is left over is dark.
inline constexpr std::size_t waves_together = 8;

/// So many wavelengths and those left over.
constexpr std::size_t whole_groups(std::size_t waves) {
  return (waves + waves_together - 1) / waves_together * waves_together;
}

/// Adds light that is scattered at one point, by wavelength, with what the machine has of SIMD:
/// filter Σ scattered[k] spectra(k) exp(−Σ passed[k] spectra(k)).
///
/// Given  spectra  (absorber, wavelength); all rows of whole groups
///        scattered, passed  amounts, 0 or more
void add_scattered(const atmosphere::Amounts& scattered, const atmosphere::Amounts& passed,
                   const algebra::Grid<double>& spectra, std::span<const double> filter,
                   std::span<double> ratio);

}  // namespace coppermoon::shadow
