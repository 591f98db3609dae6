// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "algebra/grid.h"
#include "surface/ground.h"
#include "surface/photometry.h"
#include "uses/light/moonlight.h"

namespace coppermoon::uses {

/// How a map's numbers encode normal albedo, up to a constant factor.
enum class AlbedoEncoding {
  image,              ///< brightness of an image, coded as its file states
  normal_albedo,      ///< values are used as they are, whatever coding the file states
  cgi_moon_kit_2019,  ///< NASA's CGI Moon Kit of 2019: see surface::kit_2019_albedo
  cgi_moon_kit_2025,  ///< sRGB's curve applied to I/F at 60 degrees of phase
};

/// The word for an encoding in flags and recipes, and an explanation of the numbers in such a map.
struct AlbedoEncodingWord {
  const char* word;
  AlbedoEncoding encoding;
  const char* meaning;
};

/// All encodings, the default first.
std::vector<AlbedoEncodingWord> albedo_encoding_words();

/// Called with the ratio of brightness if a map's near side, which has more maria, is brighter than its far side.
using WhenNearSideIsBrighter = std::function<void(double near_over_far)>;

/// The Moon to bake: its map, photometry, light and texture size.
struct MoonRequest {
  LightRequest light{};
  std::string albedo_map = "built-in";  ///< "built-in", or an image file (width:height = 2:1)
  surface::Photometry photometry = surface::Photometry::lommel_seeliger_rolo;
  AlbedoEncoding albedo_encoding = AlbedoEncoding::image;  ///< used only for a map from a file
  double albedo_exponent = 1;  ///< power applied to a file's decoded albedo, 0.1 to 10
  int albedo_map_centre_deg =
      0;  ///< longitude at the map's centre: 0, or 180 for maps from 0 to 360
  WhenNearSideIsBrighter when_near_side_brighter{};  ///< called if brighter by over 3 %
  bool ground_by_place = true;  ///< whether each place has its own colour and opposition surge
  std::optional<std::size_t> texture_width{};  ///< if absent, 4096, or fitted to the frame
  double texels_per_pixel = 1;  ///< at the disc's centre, if the texture is fitted to the frame
  bool unshadowed = false;      ///< whether to light the Moon as if the Earth were not there
  /// Camera that sees the Moon, named as in colour::camera_spectra. If absent or "colorimetric", the CIE 1931 observer.
  std::optional<std::string> response{};
};

/// Width of the texture.
///
/// Throws Error when it is odd, or outside 4 to 32768
std::size_t texture_width_of(const MoonRequest& moon);

/// Whether the albedo is read from a file.
bool reads_map(const MoonRequest& moon);

/// Normal albedo of the ground, scaled to give the full Moon a geometric albedo of 0.12. It is decoded from the named
/// map, or taken from the built-in map, no finer than the texture (surface::built_in_map). The maps of NASA's CGI Moon
/// Kit show the Moon at a phase of 60 degrees, where maria are darker relative to highlands than at full Moon. Raised
/// to the power 1/1.56, they have the contrast of the normal albedo in Sato et al. (2014), within 5 % rms for cells of
/// one degree on the near side. The poles of the 2019 map are corrected (surface::with_polar_contrast).
///
/// Throws Error when texture::read_albedo_map does, the exponent is outside 0.1 to 10, or the centre is
///        neither 0 nor 180
algebra::Grid<float> normal_albedo(const MoonRequest& moon);

/// Colour and opposition surge of the ground at each place of an albedo map; nullptr if the mean Moon is requested.
///
/// Throws Error when surface::ground_under does
std::shared_ptr<const surface::Ground> ground_of(const MoonRequest& moon,
                                                 const algebra::Grid<float>& normal_albedo);

/// Weights for baking moonlight. If the ground varies in colour, returns weights for the reddest and the bluest ground.
///
/// Given  at_nm  wavelengths, or middles of bands, one for each column of the weights
algebra::Grid<double> of_ground(const surface::Ground* ground, const algebra::Grid<double>& weights,
                                std::span<const double> at_nm);

/// Throws Error when the map's header shows that normal_albedo would fail, or when the response is unknown
void require_map(const MoonRequest& moon);

/// A fingerprint of the map's file, or "built-in". If the file is a recipe (.eclipse), which may name another map, the
/// fingerprint of the recipe's texture is added. If the response is read from a file, its fingerprint is added too.
///
/// Throws Error when a file cannot be read
std::string map_contents(const MoonRequest& moon);

}  // namespace coppermoon::uses
