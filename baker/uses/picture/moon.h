// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "algebra/grid.h"
#include "surface/photometry.h"
#include "uses/light/moonlight.h"

namespace coppermoon::uses {

/// Which Moon is baked, and under what light.
struct MoonRequest {
  LightRequest light{};
  std::string albedo_map = "auto";  ///< an image file 2:1; "built-in"; "auto": what is installed
  surface::Photometry photometry = surface::Photometry::lommel_seeliger_rolo;
  std::optional<double> albedo_exponent{};     ///< 0.1 to 10; without: as the map needs
  std::optional<std::size_t> texture_width{};  ///< without: 4096, or what the frame can show
  double texels_per_pixel = 1;  ///< of a texture whose width the frame says, in the disc's middle
  bool unshadowed = false;      ///< lit as if the Earth were away
};

/// Throws Error when it is odd, or outside 4 to 32768
std::size_t texture_width_of(const MoonRequest& moon);

/// Whether the albedo comes from a file.
bool reads_map(const MoonRequest& moon);

/// The normal albedo of the ground, so that the full Moon has the geometric albedo 0.12: the map
/// named, or with "auto" Stellarium's where it is installed, else the built-in one. A power of the
/// map's values undoes a tone curve: Stellarium's map is stretched, its highlands are 3.8 times as
/// bright as its maria, and its square root has both where Pohn & Wildey (1970) found them: 0.06 to
/// 0.10 and 0.12 to 0.18.
///
/// Throws Error as texture::read_albedo_map; when the exponent is outside 0.1 to 10
algebra::Grid<float> normal_albedo(const MoonRequest& moon);

/// Where the map of a Moon comes from: what "auto" stands for here.
std::string map_chosen(const MoonRequest& moon);

/// Throws Error as normal_albedo, as far as that map's header tells
void require_map(const MoonRequest& moon);

/// A fingerprint of that map's file; "built-in" without one.
///
/// Throws Error when it cannot be read
std::string map_contents(const MoonRequest& moon);

}  // namespace coppermoon::uses
