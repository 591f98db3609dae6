// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "algebra/grid.h"
#include "algebra/progress.h"
#include "almanac/sky.h"
#include "shadow/lookup.h"
#include "surface/ground.h"
#include "surface/photometry.h"
#include "texture/image.h"
#include "texture/resize.h"

namespace coppermoon::texture {

/// The Moon, the light and the ground from which a texture is baked.
struct LitSurface {
  const algebra::Grid<float>& normal_albedo;  ///< A, plate carrée, 2:1
  const almanac::SkyState& sky;
  const shadow::Lookup& light;  ///< w, by channel: radiance at 1 au of white ground facing the Sun
  /// Colour and surge by place; nullptr means those of the mean Moon. If given, the light has every channel twice:
  /// first all channels as reflected by the reddest ground, c = −strongest_colour, then all as reflected by the bluest.
  const surface::Ground* ground = nullptr;
};

/// Texture of the Moon at one moment. Each texel holds the light at its own place in the shadow, times the ground's
/// normal albedo and photometric function.
///
///     L = A f(mu0, mu, g) w (1 au / d)^2      mu0, mu: cosines of the angles between the ground's
///                                             normal and the Sun, the Earth's centre; g: phase;
///                                             d: distance from the texel to the Sun
///
/// If the ground differs from place to place, w is interpolated between the reddest and the bluest ground, linearly in
/// the place's colour, and f includes the place's surge.
///
/// If the Earth is in front of the Sun, light comes from the Earth's limb, so g is at least the Earth's angular radius,
/// asin(6378.137 km/distance), which is 0.90 to 1.03 degrees. mu0 is still that of the Sun. Lit ground that the Earth
/// does not see is baked as if mu were 0, so that it joins the limb without a step.
///
/// Given     channels    their names, as many as the light has, or half as many if `ground` is given
///           rows        of the texture, 2 to 16384; it has twice as many columns. A texture smaller than the map has
///                       the mean over each texel's area; a larger one is interpolated bilinearly
///           photometry  f
/// Returned  plate carrée, row 0 in the north, longitude 0 in the middle, east to the right; 0 on the night side
/// Throws    Error       when rows or the map's shape is outside its range
Image bake(const LitSurface& moon, std::vector<std::string> channels, std::size_t rows,
           surface::Photometry photometry, const algebra::Progress& progress = {});

/// Which texels are lit; the others stay 0.
enum class Extent {
  whole,            ///< all
  seen_from_earth,  ///< texels visible from some place on Earth, and a few beyond
};

/// Which quantity in L = E ρ / π a texel holds.
enum class TexelQuantity {
  luminance,    ///< L
  irradiance,   ///< E / π, on white diffuse ground that faces the Sun; 0 on the night side
  reflectance,  ///< ρ, the radiance factor, times the light, which is then the ground's colour
};

/// Options for lighting a texture.
struct Lighting {
  surface::Photometry photometry = surface::Photometry::lommel_seeliger_rolo;
  Extent extent = Extent::whole;
  TexelQuantity quantity = TexelQuantity::luminance;
  /// For irradiance, what each channel of the light is divided by: the ratio of the ground's light under sunlight to
  /// that of white ground. It varies with place as the light does. If empty, the light is not divided.
  std::vector<double> sunlit = {};
};

/// Rows of the texture that `bake` makes, computed on demand on all threads, so that little memory is needed.
///
/// Given     moon      its albedo and light must outlive the returned rows
///           progress  called with the fraction of rows that are lit
/// Returned  rows whose values do not depend on how many are requested at once, or on the number of threads
/// Accuracy  1e-5 relative to the formula for `bake`, because the phase curve is interpolated in a table
Rows lit_rows(const LitSurface& moon, std::size_t rows, const Lighting& lighting = {},
              const algebra::Progress& progress = {});

/// Rows of normal albedo at the size of the texture: one channel, which includes the night side.
Rows albedo_rows(const algebra::Grid<float>& normal_albedo, std::size_t rows);

}  // namespace coppermoon::texture
