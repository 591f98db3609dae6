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

/// The Moon, light and ground from which a texture is baked.
struct LitSurface {
  const algebra::Grid<float>& normal_albedo;  ///< A, plate carrée, 2:1
  const almanac::SkyState& sky;
  const shadow::Lookup& light;  ///< w, each channel's radiance at 1 au from white ground that faces
                                ///< the Sun
  /// Colour and surge by place; nullptr: those of the mean Moon. If given, the light has every channel twice: first all
  /// channels as reflected by the reddest ground, c = −strongest_colour, then all as reflected by the bluest.
  const surface::Ground* ground = nullptr;
};

/// Texture of the Moon at one moment: each texel has the light at its own place in the shadow, times the ground's
/// normal albedo and photometric function.
///
///     L = A f(mu0, mu, g) w (1 au / d)^2      mu0, mu: cosines of the angles between the ground's
///                                             normal and the Sun, the Earth's centre; g: phase;
///                                             d: texel to Sun
///
/// If the ground differs by place, w is interpolated between the reddest and the bluest ground, linearly in the
/// place's colour, and f includes the place's surge.
///
/// If the Earth is in front of the Sun, light comes from the Earth's limb: g is the larger of the
/// angle between Sun and Earth's centre and the Earth's angular radius, asin(6378.137 km/distance),
/// 0.90 to 1.03 degrees. mu0 remains the Sun's. Lit ground that the Earth does not see is baked as
/// if mu were 0, so that it joins the limb without a step.
///
/// Given     channels    their names, as many as the light has, or half as many with ground by place
///           rows        of the texture, 2 to 16384; twice as many columns. If smaller than the map,
///                       it has the mean over each texel's area; if larger, it is bilinear
///           photometry  f
/// Returned  plate carrée, row 0 north, longitude 0 in the middle, east to the right; 0 on the
///           night side
/// Throws    Error       when rows or the map's shape is outside what is allowed
Image bake(const LitSurface& moon, std::vector<std::string> channels, std::size_t rows,
           surface::Photometry photometry, const algebra::Progress& progress = {});

/// Which texels are lit.
enum class Extent {
  whole,            ///< all
  seen_from_earth,  ///< those visible from some place on Earth, and a few beyond; others stay 0
};

/// Which quantity in L = E ρ / π a texel holds.
enum class TexelQuantity {
  luminance,    ///< L
  irradiance,   ///< E / π, on white diffuse ground that faces the Sun; 0 on the night side
  reflectance,  ///< ρ, the radiance factor, times the light, which then is the ground's colour
};

/// Options of lighting.
struct Lighting {
  surface::Photometry photometry = surface::Photometry::lommel_seeliger_rolo;
  Extent extent = Extent::whole;
  TexelQuantity quantity = TexelQuantity::luminance;
  /// What to divide the light by for irradiance, per channel: the ratio of the ground's light under sunlight to that of
  /// white ground, mixed by place as the light is. If empty, 1.
  std::vector<double> sunlit = {};
};

/// Rows of the texture that `bake` makes, computed on demand on all threads, so memory does not grow with the texture.
///
/// Given     moon      its albedo and light must outlive the returned rows
///           progress  called with the fraction of rows lit
/// Returned  the same values however many rows are requested at once, and on any number of threads
/// Accuracy  1e-5 of the expression given for `bake`, from interpolating the phase curve in its table
Rows lit_rows(const LitSurface& moon, std::size_t rows, const Lighting& lighting = {},
              const algebra::Progress& progress = {});

/// Rows of normal albedo at the texture's size: one channel, including the night side.
Rows albedo_rows(const algebra::Grid<float>& normal_albedo, std::size_t rows);

}  // namespace coppermoon::texture
