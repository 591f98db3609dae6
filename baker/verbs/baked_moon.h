// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
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
#include "verbs/flags.h"
#include "verbs/moon_options.h"

namespace coppermoon::verbs {

/// "2008-02-21T03:08:26Z" as OpenEXR writes it: "2008:02:21 03:08:26".
std::string capture_date(const almanac::Instant& instant);

/// What a texture holds, and how it is stored.
struct TextureOptions {
  std::optional<std::string> space;   ///< without: lin_rec709
  std::optional<std::string> type;    ///< half or float; without: half, float for a spectrum
  std::optional<double> spectral_nm;  ///< also the spectral radiance, in bands so wide
  bool passes = false;                ///< also what the light is made of
};

void add_texture_options(CLI::App& verb, TextureOptions& options);

/// Throws  Error  when there is no such space; when a band is outside 1 to 100 nm, or does not go
///                into 400 nm evenly
void require_sound(const TextureOptions& options);

colour::WorkingSpace space_of(const TextureOptions& options);

texture::ExrType type_of(const TextureOptions& options);

/// What the textures of one moment are made from.
struct LitMoon {
  MoonOptions options;
  almanac::SkyState sky;
  std::shared_ptr<const algebra::Grid<float>> albedo;
  std::shared_ptr<const Moonlight> light;
  /// what of the light the disc takes in; nothing: all is sunlight
  std::optional<shadow::LookupRange> within;
  std::string recipe;  ///< that makes it again, with the work that was planned
  /// who sees it, and through what air, which reddens it; without: from the Earth's centre
  std::optional<almanac::Observer> observer = {};
  std::optional<atmosphere::Sightline> sightline = {};
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();

  double seconds() const;  ///< since it was begun
};

/// Given  recipe  of what was asked for
LitMoon lit_moon(const MoonOptions& options, const almanac::SkyState& sky,
                 const std::string& recipe);

/// A texture that is baked as its rows are asked for, and what its file's header says.
struct BakedMoon {
  std::vector<texture::Part> parts;
  texture::Attributes attributes;
};

/// How a Moon is baked.
struct Baking {
  texture::Extent extent = texture::Extent::whole;
  bool bar = true;  ///< whether a progress bar shows rows being baked
};

/// The texture in its space [cd/m²], and what else was asked for:
///
///     S0.…nm      spectral radiance [W m⁻² sr⁻¹ nm⁻¹], the mean over each band, after Fichet et
///                 al. (2021), beside the colours
///     direct, refracted        parts whose luminances add up to the whole
///     irradiance, reflectance  parts whose product it is: the luminance of a white diffuse ground
///                              that faces the Sun, under light as the Moon's reddish ground weighs
///                              it; the radiance factor under sunlight, of the ground's own colour
///     albedo      a part: the map's normal albedo
///
/// Colours outside the space are brought into it in each part by itself.
BakedMoon baked(const LitMoon& moon, const TextureOptions& content, const Baking& baking = {});

}  // namespace coppermoon::verbs
