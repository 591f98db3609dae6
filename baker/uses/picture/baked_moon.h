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
  std::optional<texture::ExrType> type{};       ///< if absent: half, or float with a spectrum
  std::optional<double> spectral_nm{};  ///< width of the spectral bands; if absent, no bands
  bool passes = false;                  ///< whether to store the light's components too
};

/// Throws  Error  when the width of the spectral bands is outside 1 to 100 nm, or does not divide 400 nm evenly
void require_sound(const TextureContent& content);

colour::WorkingSpace space_of(const TextureContent& content);

texture::ExrType type_of(const TextureContent& content);

/// The Moon at one moment and the light on it, from which textures are baked.
struct LitMoon {
  MoonRequest request;
  almanac::SkyState sky;
  std::shared_ptr<const algebra::Grid<float>> albedo;
  std::shared_ptr<const surface::Ground> ground;  ///< if nullptr, the mean Moon's ground everywhere
  std::shared_ptr<const Moonlight> light;
  /// Part of the shadow that the Moon's disc covers; if absent, the whole disc is in direct sunlight.
  std::optional<shadow::LookupRange> within;
  /// The observer, and the line of sight through the air that reddens the Moon. If absent: the Earth's centre, no air.
  std::optional<almanac::Observer> observer = {};
  std::optional<atmosphere::Sightline> sightline = {};
};

/// Reads the Moon's map, then plans and computes its light.
LitMoon lit_moon(const MoonRequest& request, const almanac::SkyState& sky,
                 const algebra::Progress& progress = {});

/// A texture and its header. The rows of the texture are baked only when they are requested.
struct BakedMoon {
  std::vector<texture::Part> parts;
  texture::Attributes attributes;
};

struct Baking {
  texture::Extent extent = texture::Extent::whole;
  algebra::Progress progress = {};  ///< called with the share of rows baked
  /// Function that makes the recipe for the texture's header; if empty, texture_recipe is used.
  std::function<std::string(const LitMoon&, const TextureContent&)> recipe = {};
};

/// Bakes a texture in its colour space [cd/m²], with the following channels and parts if the content requests them:
///
///     S0.…nm      channels of spectral radiance [W m⁻² sr⁻¹ nm⁻¹], averaged over each band, after Fichet et
///                 al. (2021), stored beside the colour channels
///     direct, refracted        luminance from direct and from refracted sunlight; their sum is the total luminance
///     irradiance, reflectance  two factors of the total luminance. Irradiance is the luminance of white diffuse
///                              ground that faces the Sun, with wavelengths weighted by the reddish colour of the
///                              Moon. Reflectance is the radiance factor of the ground in sunlight
///     albedo      normal albedo, from the map
///
/// Every part shows the local colour of the ground, except irradiance, which is the luminance divided by reflectance.
///
/// In each part, colours outside the colour space are moved into its gamut. The header attribute `coppermoon:recipe`
/// holds a recipe that bakes the same texels again.
BakedMoon baked(const LitMoon& moon, const TextureContent& content, const Baking& baking = {});

/// Illuminance [lux] from the whole Moon on a surface that faces it, in the channels of a colour space. The surface is
/// at the observer's place, below the air that dims the Moon there.
///
/// Accuracy  0.2 % with a texture of 360 rows; if the Moon's own texture has fewer rows, their number is used
std::array<double, 3> illuminance_seen(
    LitMoon moon, colour::WorkingSpace space = colour::WorkingSpace::linear_rec709);

}  // namespace coppermoon::uses
