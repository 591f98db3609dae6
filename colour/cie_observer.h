// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "algebra/grid.h"
#include "algebra/table.h"

namespace coppermoon::colour {

/// Luminous flux per watt of green light (555 nm) [lm/W].
///
/// Source  BIPM, The International System of Units (2019), K_cd
inline constexpr double luminous_efficacy_lm_per_W = 683;

/// Weights that turn band means of a spectral radiance into absolute CIE XYZ, for the 1931 2° observer.
///
///     X = 683 Σ_b L_b ∫_b x̄(λ) dλ        [cd/m²]; likewise Y (the luminance) and Z
///
/// Given     edges_nm  edges of the bands, increasing; one more than there are bands. Wavelengths outside 360 to 830 nm
///                     do not count
/// Returned  weights   [X Y Z][band], cd/m² per W m⁻² sr⁻¹ nm⁻¹
/// Throws    Error     when there is no band, or an edge is not above the one before it
/// Source    CIE 15: the colour-matching functions every 1 nm, interpolated linearly
algebra::Grid<double> xyz_weights(std::span<const double> edges_nm);

/// Integrals of a table's columns over wavelength bands. Values are linear between rows, and 0 outside the table.
///
/// Given     table     has a column wavelength_nm, in increasing order
///           edges_nm  as in xyz_weights
/// Returned  [column][band]
/// Throws    Error     as for xyz_weights; also when a column is missing
algebra::Grid<double> band_integrals(const algebra::Table& table,
                                     std::span<const std::string> columns,
                                     std::span<const double> edges_nm);

}  // namespace coppermoon::colour
