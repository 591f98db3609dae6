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

/// What a texture contains, and the type of its numbers.
struct TextureContent {
  std::optional<colour::WorkingSpace> space{};  ///< if absent, linear Rec.709
  std::optional<texture::ExrType> type{};       ///< if absent, half; float for a spectrum
  std::optional<double> spectral_nm{};  ///< width of the spectral bands; if absent, no bands
  bool passes = false;                  ///< store the components of the light too
};

/// Throws  Error  when the width of the bands is outside 1 to 100 nm, or does not divide 400 nm evenly
void require_sound(const TextureContent& content);

colour::WorkingSpace space_of(const TextureContent& content);

texture::ExrType type_of(const TextureContent& content);

/// The Moon at one moment and the light on it, from which textures are baked.
struct LitMoon {
  MoonRequest request;
  almanac::SkyState sky;
  std::shared_ptr<const algebra::Grid<float>> albedo;
  std::shared_ptr<const surface::Ground> ground;  ///< nullptr: the mean Moon everywhere
  std::shared_ptr<const Moonlight> light;
  /// Range of the light that reaches the disc; if absent, all of it is direct sunlight.
  std::optional<shadow::LookupRange> within;
  /// Observer, and the path through the air that reddens the Moon; if absent, seen from the Earth's centre.
  std::optional<almanac::Observer> observer = {};
  std::optional<atmosphere::Sightline> sightline = {};
};

/// Reads the Moon's map, then plans and computes its light.
LitMoon lit_moon(const MoonRequest& request, const almanac::SkyState& sky,
                 const algebra::Progress& progress = {});

/// A texture whose rows are baked when they are asked for, and its header.
struct BakedMoon {
  std::vector<texture::Part> parts;
  texture::Attributes attributes;
};

/// Options for baking.
struct Baking {
  texture::Extent extent = texture::Extent::whole;
  algebra::Progress progress = {};  ///< of the rows being baked
  /// Makes the recipe for the header; if empty, texture_recipe does
  std::function<std::string(const LitMoon&, const TextureContent&)> recipe = {};
};

/// The texture in its colour space [cd/m²], with the parts asked for:
///
///     S0.…nm      spectral radiance [W m⁻² sr⁻¹ nm⁻¹], averaged over each band, after Fichet et
///                 al. (2021), stored beside the colours
///     direct, refracted        parts whose luminances add up to the whole
///     irradiance, reflectance  parts whose product is the whole: the luminance of white diffuse ground
///                              that faces the Sun, with the light weighted as the Moon's reddish ground
///                              does; and the radiance factor under sunlight, in the ground's own colour
///     albedo      part with the map's normal albedo
///
/// The ground's local colour shows in every part but irradiance, which is the luminance divided by the reflectance.
///
/// Colours outside the space are brought into it, in each part separately. The attribute `coppermoon:recipe` holds the
/// recipe that bakes the same texels again.
BakedMoon baked(const LitMoon& moon, const TextureContent& content, const Baking& baking = {});

/// Illuminance from the whole Moon on a surface that faces it, at the observer and through the air, in the channels of
/// a colour space [lux].
///
/// Accuracy  0.2 %, for a disc of 360 rows, or of as many rows as its texture has
std::array<double, 3> illuminance_seen(
    LitMoon moon, colour::WorkingSpace space = colour::WorkingSpace::linear_rec709);

}  // namespace coppermoon::uses
