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
  const algebra::Grid<float>& normal_albedo;  ///< map of albedo A (see `bake`): plate carrée, 2:1
  const almanac::SkyState& sky;
  const shadow::Lookup& light;  ///< w: radiance of white ground facing the Sun at 1 au, by channel
  /// Colour and opposition surge by place; nullptr means the mean Moon's. If it is given, `light` has every channel
  /// twice: first all channels for the reddest ground, c = −strongest_colour, then all for the bluest.
  const surface::Ground* ground = nullptr;
};

/// Bakes a texture of the Moon at one moment. Each texel holds the light at its position in the Earth's shadow, times
/// the ground's normal albedo and photometric function.
///
///     L = A f(mu0, mu, g) w (1 au / d)^2      mu0, mu: cosines of the angles from the ground's
///                                             normal to the Sun and to the Earth's centre; g: phase
///                                             angle; d: distance from the texel to the Sun
///
/// If the ground varies from place to place, w is interpolated between the reddest and the bluest ground, linearly in
/// the local colour, and f includes the local opposition surge.
///
/// If the Earth is in front of the Sun, light comes from the Earth's limb, so g is at least the Earth's angular radius,
/// asin(6378.137 km/distance), which is 0.90 to 1.03 degrees. mu0 is still that of the Sun. Lit ground that faces away
/// from the Earth is baked as if mu were 0, so that there is no step at the limb.
///
/// Given     channels    names of the channels: as many as the light has channels, or half as many if `ground` is given
///           rows        number of rows, 2 to 16384; there are twice as many columns. A map larger than the texture is
///                       averaged over each texel's area; a smaller one is interpolated bilinearly
///           photometry  photometric function f
/// Returned  plate carrée: row 0 in the north, longitude 0 in the middle, east to the right; 0 on the night side
/// Throws    Error       when `rows` is out of range or the albedo map is not 2:1
Image bake(const LitSurface& moon, std::vector<std::string> channels, std::size_t rows,
           surface::Photometry photometry, const algebra::Progress& progress = {});

/// Which texels are lit; the others stay 0.
enum class Extent {
  whole,            ///< all texels
  seen_from_earth,  ///< texels visible from some place on Earth, and a few beyond
};

/// Quantity that a texel holds: one of those in L = E ρ / π (luminance, irradiance and radiance factor).
enum class TexelQuantity {
  luminance,    ///< L, in the direction of the Earth
  irradiance,   ///< E / π: luminance of white diffuse ground facing the Sun; 0 on the night side
  reflectance,  ///< ρ, the radiance factor, if `light` is sunlit ground relative to white ground
};

/// Options for lighting a texture.
struct Lighting {
  surface::Photometry photometry = surface::Photometry::lommel_seeliger_rolo;
  Extent extent = Extent::whole;
  TexelQuantity quantity = TexelQuantity::luminance;
  /// For irradiance, divisors for the light's channels: the light of sunlit ground relative to white ground. If the
  /// ground's colour varies, all divisors for the reddest ground come first, then all for the bluest. Empty means 1.
  std::vector<double> sunlit = {};
};

/// Rows of the texture that `bake` makes, computed on demand on all threads, so that little memory is needed.
///
/// Given     moon      has albedo and light that must outlive the returned function
///           progress  called with the fraction of all rows that are finished
/// Returned  rows whose values do not depend on how many are requested at once, or on the number of threads
/// Accuracy  1e-5 relative to the formula for `bake`, because the phase curve is interpolated in a table
Rows lit_rows(const LitSurface& moon, std::size_t rows, const Lighting& lighting = {},
              const algebra::Progress& progress = {});

/// Rows of the normal albedo in one channel, resized to the given number of rows. The Moon's night side is included.
Rows albedo_rows(const algebra::Grid<float>& normal_albedo, std::size_t rows);

}  // namespace coppermoon::texture
