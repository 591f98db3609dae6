// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

#include "algebra/grid.h"
#include "atmosphere/atmosphere.h"

namespace coppermoon::shadow {

/// Rows are padded to a multiple of this number of wavelengths.
inline constexpr std::size_t waves_together = 8;

/// Adds the light that is scattered at one point, by wavelength, with the machine's widest vectors:
/// filter Σ scattered[k] spectra(k) exp(−Σ passed[k] spectra(k)).
///
/// Given  scattered  amounts of absorbers at the point, 0 or more
///        passed     amounts of absorbers along the path, 0 or more
///        spectra    (absorber, wavelength), padded with 0
void add_scattered(const atmosphere::Amounts& scattered, const atmosphere::Amounts& passed,
                   const algebra::Grid<double>& spectra, std::span<const double> filter,
                   std::span<double> ratio);

}  // namespace coppermoon::shadow
