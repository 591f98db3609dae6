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

/// Coding of a map's numbers as normal albedo, up to a factor.
enum class AlbedoEncoding {
  image,              ///< light, as the image file says
  normal_albedo,      ///< themselves, whatever the file says
  cgi_moon_kit_2019,  ///< NASA's CGI Moon Kit of 2019: see surface::kit_2019_albedo
  cgi_moon_kit_2025,  ///< sRGB's curve over I/F at 60 degrees of phase
};

/// Word of an encoding in flags and recipes, and what the numbers of its maps are.
struct AlbedoEncodingWord {
  const char* word;
  AlbedoEncoding encoding;
  const char* meaning;
};

/// All encodings, the default first.
std::vector<AlbedoEncodingWord> albedo_encoding_words();

/// Callback with the ratio by which a map's near side is brighter than its far side, which has fewer maria.
using WhenNearSideIsBrighter = std::function<void(double near_over_far)>;

/// Moon that is baked: map, photometry, light, size of the texture.
struct MoonRequest {
  LightRequest light{};
  std::string albedo_map = "built-in";  ///< an image file 2:1; or the library's own map
  surface::Photometry photometry = surface::Photometry::lommel_seeliger_rolo;
  AlbedoEncoding albedo_encoding = AlbedoEncoding::image;  ///< of a file, as the next two
  double albedo_exponent = 1;  ///< power applied to decoded albedo, 0.1 to 10
  int albedo_map_centre_deg =
      0;  ///< longitude in the map's middle: 0, or 180 of maps from 0 to 360
  WhenNearSideIsBrighter when_near_side_brighter{};  ///< called above 3 %
  bool ground_by_place = true;  ///< colour and surge of each place; or those of the mean Moon
  std::optional<std::size_t> texture_width{};  ///< without: 4096, or as the frame resolves
  double texels_per_pixel = 1;  ///< of a texture whose width the frame says, in the disc's middle
  bool unshadowed = false;      ///< lit as if the Earth were away
  /// Camera that sees the Moon, as in colour::camera_spectra; without, and as "colorimetric": the CIE 1931 observer.
  std::optional<std::string> response{};
};

/// Refuses a texture's width that is odd, or outside 4 to 32768.
///
/// Throws Error
std::size_t texture_width_of(const MoonRequest& moon);

/// Whether the albedo comes from a file.
bool reads_map(const MoonRequest& moon);

/// The normal albedo of the ground, so that the full Moon has the geometric albedo 0.12: the map named, decoded, or the
/// built-in one, no finer than the texture (surface::built_in_map). The kits' maps are of 60 degrees of phase, where
/// maria are darker against highlands than at full Moon: to the power 1/1.56 they have the contrast of the normal
/// albedo that Sato et al. (2014) give, within 5 % rms of cells of one degree over the near side. The poles of that of
/// 2019 are mended: see surface::with_polar_contrast.
///
/// Throws Error as texture::read_albedo_map; when the exponent is outside 0.1 to 10, or the centre is
///        neither 0 nor 180
algebra::Grid<float> normal_albedo(const MoonRequest& moon);

/// Colour and surge of the ground by place under that albedo; nothing where the mean Moon is asked for.
///
/// Throws Error as surface::ground_under
std::shared_ptr<const surface::Ground> ground_of(const MoonRequest& moon,
                                                 const algebra::Grid<float>& normal_albedo);

/// Weights of moonlight for a bake: of the reddest and the bluest ground where it differs by place (reddest_and_bluest).
///
/// Given  at_nm  wavelengths or middles of bands of the weights' columns
algebra::Grid<double> of_ground(const surface::Ground* ground, const algebra::Grid<double>& weights,
                                std::span<const double> at_nm);

/// Throws Error as normal_albedo, as far as that map's header tells; for a response that is none
void require_map(const MoonRequest& moon);

/// A fingerprint of that map's file; "built-in" without one. Of a recipe that OpenImageIO reads as an
/// image (.eclipse) also that of the texture, which depends on a map of its own; of a response's file too.
///
/// Throws Error when it cannot be read
std::string map_contents(const MoonRequest& moon);

}  // namespace coppermoon::uses
