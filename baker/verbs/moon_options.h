// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "algebra/grid.h"
#include "surface/photometry.h"
#include "verbs/flags.h"
#include "verbs/light_options.h"

namespace coppermoon::verbs {

/// Which Moon is baked.
struct MoonOptions {
  std::string instant;
  LightOptions light;
  std::string albedo_map = "auto", photometry = "lommel-seeliger-rolo";
  std::optional<double> albedo_exponent;     ///< without: as the map needs
  std::optional<std::size_t> texture_width;  ///< without: 4096, or what the frame can show
  bool unshadowed = false;
};

void add_moon_options(CLI::App& verb, MoonOptions& options);

/// The same but for the instant.
void add_film_moon_options(CLI::App& verb, MoonOptions& options);

surface::Photometry photometry_of(const MoonOptions& options);

/// Throws Error when it is odd, or outside 4 to 32768
std::size_t texture_width_of(const MoonOptions& options);

/// Whether the albedo comes from a file.
bool reads_map(const MoonOptions& options);

/// The normal albedo of the ground, so that the full Moon has the geometric albedo 0.12: the map
/// named, or with "auto" Stellarium's where it is installed, else the built-in one. A power of the
/// map's values undoes a tone curve: Stellarium's map is stretched, its highlands are 3.8 times as
/// bright as its maria, and its square root has both where Pohn & Wildey (1970) found them: 0.06 to
/// 0.10 and 0.12 to 0.18.
///
/// Throws Error as texture::read_albedo_map; when the exponent is outside 0.1 to 10
algebra::Grid<float> normal_albedo(const MoonOptions& options);

/// Where the map of a Moon comes from: what "auto" stands for here.
std::string map_chosen(const MoonOptions& options);

/// Throws Error as normal_albedo, as far as that map's header tells
void require_map(const MoonOptions& options);

/// A fingerprint of that map's file; "built-in" without one.
///
/// Throws Error when it cannot be read
std::string map_contents(const MoonOptions& options);

/// Throws Error when a file could not be put there: its folder is missing, or it is a folder
/// itself. Said before the work is done.
void require_place_for(const std::filesystem::path& file);

}  // namespace coppermoon::verbs
