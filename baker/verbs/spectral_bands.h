// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "algebra/grid.h"
#include "atmosphere/observer_air.h"

namespace coppermoon::verbs {

/// The bands light is computed in: 200 of 2 nm, from 380 to 780 nm.
///
/// Source  Yapo & Cutler (2009) §2.2
std::vector<double> band_edges_nm();
std::vector<double> band_centres_nm();

/// What a white ground that faces the Sun at 1 au makes of sunlight in some channels, band by band,
/// were it as reddish as the Moon and as bright as its normal albedo in V says:
///
///     w = C E k_r / (π k_V)        k_V: k_r averaged over the Sun's light as the eye sees it
///
/// Given     response   C, [channel][band]: of radiance, in the channel's unit per W m⁻² sr⁻¹ nm⁻¹
///           sightline  through an observer's air, which reddens the Moon (see
///                      atmosphere::transmittance_above); none: seen from space
/// Returned  w          [channel][band]
algebra::Grid<double> moonlight_weights(const algebra::Grid<double>& response,
                                        const std::optional<atmosphere::Sightline>& sightline = {});

}  // namespace coppermoon::verbs
