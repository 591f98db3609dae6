// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "almanac/instant.h"
#include "almanac/observer.h"
#include "almanac/sky.h"
#include "atmosphere/observer_air.h"
#include "colour/working_space.h"
#include "texture/bake.h"
#include "texture/write_image.h"
#include "uses/picture/moon.h"

namespace coppermoon::uses {

/// Contents of a texture and the type of its numbers.
struct TextureContent {
  std::optional<colour::WorkingSpace> space{};  ///< without: linear Rec.709
  std::optional<texture::ExrType> type{};       ///< without: half, float for a spectrum
  std::optional<double> spectral_nm{};  ///< width of bands of spectral radiance; without: none
  bool passes = false;                  ///< also the components of the light
};

/// Throws  Error  when a band is outside 1 to 100 nm, or does not go into 400 nm evenly
void require_sound(const TextureContent& content);

colour::WorkingSpace space_of(const TextureContent& content);

texture::ExrType type_of(const TextureContent& content);

/// Moon of one moment and its light, from which textures are baked.
struct LitMoon {
  MoonRequest request;
  almanac::SkyState sky;
  std::shared_ptr<const algebra::Grid<float>> albedo;
  std::shared_ptr<const surface::Ground> ground;  ///< none: the mean Moon everywhere
  std::shared_ptr<const Moonlight> light;
  /// Range of the light that reaches the disc; nothing: all is direct sunlight.
  std::optional<shadow::LookupRange> within;
  /// Observer, and the path through the air that reddens the Moon; without: from the Earth's centre.
  std::optional<almanac::Observer> observer = {};
  std::optional<atmosphere::Sightline> sightline = {};
};

/// Moon with its map read and its light planned and computed.
LitMoon lit_moon(const MoonRequest& request, const almanac::SkyState& sky,
                 const algebra::Progress& progress = {});

/// Texture that is baked as its rows are asked for, and its header.
struct BakedMoon {
  std::vector<texture::Part> parts;
  texture::Attributes attributes;
};

/// Options of baking.
struct Baking {
  texture::Extent extent = texture::Extent::whole;
  algebra::Progress progress = {};  ///< of rows being baked
  /// Recipe for the header; without: texture_recipe
  std::function<std::string(const LitMoon&, const TextureContent&)> recipe = {};
};

/// Texture in its space [cd/m²], with the parts asked for:
///
///     S0.…nm      spectral radiance [W m⁻² sr⁻¹ nm⁻¹], the mean over each band, after Fichet et
///                 al. (2021), beside the colours
///     direct, refracted        parts whose luminances add up to the whole
///     irradiance, reflectance  parts whose product it is: the luminance of a white diffuse ground
///                              that faces the Sun, under light as the Moon's reddish ground weighs
///                              it; the radiance factor under sunlight, of the ground's own colour
///     albedo      a part: the map's normal albedo
///
/// Ground by place colours all but irradiance, which is the luminance over the reflectance.
///
/// Colours outside the space are brought into it, in each part separately. The attribute `coppermoon:recipe` has the
/// recipe that bakes the same texels again.
BakedMoon baked(const LitMoon& moon, const TextureContent& content, const Baking& baking = {});

/// Illuminance by the whole Moon on a surface that faces it, at its observer, through the sightline, in the channels of
/// a space [lux].
///
/// Accuracy  0.2 %, of a disc of 360 rows, or of as many as its texture has
std::array<double, 3> illuminance_seen(
    LitMoon moon, colour::WorkingSpace space = colour::WorkingSpace::linear_rec709);

}  // namespace coppermoon::uses
