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
  std::shared_ptr<const surface::Ground> ground;  ///< nullptr means the mean Moon everywhere
  std::shared_ptr<const Moonlight> light;
  /// The part of the shadow in which the disc lies; if absent, the whole disc is in direct sunlight.
  std::optional<shadow::LookupRange> within;
  /// The observer (if absent, at the Earth's centre), and the line of sight through the air that reddens the Moon.
  std::optional<almanac::Observer> observer = {};
  std::optional<atmosphere::Sightline> sightline = {};
};

/// Reads the Moon's map, then plans and computes its light.
LitMoon lit_moon(const MoonRequest& request, const almanac::SkyState& sky,
                 const algebra::Progress& progress = {});

/// A texture, whose rows are baked only when they are requested, and its header.
struct BakedMoon {
  std::vector<texture::Part> parts;
  texture::Attributes attributes;
};

/// Options for baking.
struct Baking {
  texture::Extent extent = texture::Extent::whole;
  algebra::Progress progress = {};  ///< reports the share of rows baked
  /// Makes the recipe for the header; if empty, texture_recipe makes it
  std::function<std::string(const LitMoon&, const TextureContent&)> recipe = {};
};

/// The texture in its colour space [cd/m²], with the parts that the content requests:
///
///     S0.…nm      spectral radiance [W m⁻² sr⁻¹ nm⁻¹], averaged over each band, after Fichet et
///                 al. (2021), stored beside the colours
///     direct, refracted        luminance from direct and from refracted sunlight, which add up to the whole
///     irradiance, reflectance  two factors of the whole. The first is the luminance of white diffuse ground that
///                              faces the Sun, with wavelengths weighted by the reddish colour of the Moon. The
///                              second is the radiance factor of the ground in sunlight, with its local colour
///     albedo      the map's normal albedo
///
/// The ground's local colour shows in every part but irradiance, which is the luminance divided by the reflectance.
///
/// In each part, colours outside the colour space are moved into its gamut. The attribute `coppermoon:recipe` holds the
/// recipe that bakes the same texels again.
BakedMoon baked(const LitMoon& moon, const TextureContent& content, const Baking& baking = {});

/// Illuminance from the whole Moon on a surface that faces it, at the observer's place and through the air there, in
/// the channels of a colour space [lux].
///
/// Accuracy  0.2 % with a texture of 360 rows, which is used unless the Moon's own texture has fewer
std::array<double, 3> illuminance_seen(
    LitMoon moon, colour::WorkingSpace space = colour::WorkingSpace::linear_rec709);

}  // namespace coppermoon::uses
