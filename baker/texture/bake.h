// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "algebra/grid.h"
#include "algebra/progress.h"
#include "almanac/sky.h"
#include "shadow/lookup.h"
#include "texture/image.h"

namespace coppermoon::texture {

/// The Moon of one moment, every texel lit: what comes through the shadow at the texel's own place
/// on the sphere, times the ground's normal albedo and photometric function.
///
///     L = A f(mu) w (1 au / d)^2        mu: cosine of the angle between ground and Sun, d: texel
///                                       to Sun
///
/// Given     normal_albedo  A, plate carrée, 2:1
///           light          w, each channel's radiance at 1 au of a white ground that faces the Sun
///           channels       their names, as many as `light` has
///           rows           of the texture, 2 to 16384; twice as many columns. Smaller than the
///                          map: the mean over each texel's area; larger: bilinear
/// Returned  plate carrée, row 0 north, longitude 0 in the middle, east to the right; 0 on the
///           night side
/// Throws    Error          when rows or the map's shape is outside what is allowed
Image bake(const algebra::Grid<float>& normal_albedo, const almanac::SkyState& sky,
           const shadow::Lookup& light, std::vector<std::string> channels, std::size_t rows,
           const algebra::Progress& progress = {});

/// A map at another size: see `bake`.
algebra::Grid<float> resized(const algebra::Grid<float>& map, std::size_t rows);

}  // namespace coppermoon::texture
