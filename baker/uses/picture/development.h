// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "colour/exposure.h"
#include "colour/working_space.h"
#include "texture/image.h"
#include "uses/picture/camera_request.h"

namespace coppermoon::uses {

/// Rule for the exposure time of a frame.
struct ExposureTime {
  enum class Rule {
    automatic,  ///< brings the 99th percentile of lit pixels to 0.8 of saturation
    follow,     ///< exposes for a mean over the disc that changes smoothly at totality
    composite,  ///< for films: combines an exposure for the bright part and one for the shadow
    fixed
  };
  Rule rule = Rule::automatic;
  double seconds = 1;  ///< exposure time for the rule `fixed`, 1e-6 to 1e6
};

/// Settings for the camera and the development.
struct Development {
  ExposureTime time{};
  std::optional<double> f_number{};  ///< if absent, the camera's, or 12.1 without a camera
  double iso = 800;
  std::string
      view = "Hue-preserving",
      display = "sRGB",
      config;  ///< for OpenColorIO; config is a file or ocio://…, or found by colour::config_for
  std::string
      config_space{};      ///< the frames' colour space, as named in `config`; if empty, detected
  int bits = 8;            ///< bits per number in a picture, 8 or 16
  bool caption = false;    ///< whether to write local time, place and contact into pictures
  CameraRequest camera{};  ///< camera for frames; textures are developed without one
  std::optional<double> focal_length_mm{};  ///< focal length of the view; if absent, the camera's
};

/// Exposure of a picture, or both exposures of a composite.
struct Exposures {
  colour::Exposure shorter;
  std::optional<double> longer_s = {};  ///< longer exposure time, in a composite only
  bool a_cameras = true;                ///< if false, exposures only set the luminance of white
};

/// Exposure for a frame by the development's rule. It is computed from the Moon's pixels, which include light from the
/// sky. It is short enough to keep the sky at or below 0.1 of saturation at night, and up to 0.4 by day. If nothing of
/// the Moon is lit, only the sky counts. If the sky is black as well, the time is 1 s.
///
/// Given  seen  if it has the Moon's outline, only pixels of the Moon count; otherwise all pixels do
/// Throws Error when a setting is outside its range, or the frame has fewer than three channels
Exposures exposures_for(const Development& development, const texture::Image& frame,
                        colour::WorkingSpace space, const SeenFrame& seen = {});

/// A scene-linear texture that is to be developed [cd/m²]. Its rows may be requested more than once.
struct LitTexture {
  texture::Layout layout;
  texture::Rows rows;
  colour::WorkingSpace space;
};

/// Exposure for a texture, which is treated like a frame without a camera. Only some rows are in memory at a time.
Exposures exposures_for(const Development& development, const LitTexture& texture);

/// Ratio of the sky's luminance in a frame to the 99th percentile of the Moon's; 0 if the sky or the Moon is dark.
///
/// Throws Error when the frame has fewer than three channels
double sky_over_moon(const texture::Image& frame, colour::WorkingSpace space,
                     const SeenFrame& seen);

/// Sums of powers of the brightest channel [cd/m²] over all lit pixels. Exposure times are computed from them.
struct LitSums {
  std::size_t count = 0;
  double inverses = 0, cube_roots = 0, cubes = 0, fourth_powers = 0;

  void add(double brightest_cd_m2);
};

/// One exposure for a set of frames: the rule for a single frame is applied to the pixels of all frames together. Only
/// counts and sums are kept in memory.
///
/// Accuracy  automatic exposure times to 1/2000, because levels of pixels are counted in relative steps of 2^-11
class SharedExposure {
 public:
  explicit SharedExposure(const Development& development);
  void add(const texture::Image& frame, colour::WorkingSpace space, const SeenFrame& seen = {});
  Exposures exposures() const;

 private:
  Development development_;
  std::vector<std::size_t> counts_;  ///< number of pixels at each level of the brightest channel
  LitSums sums_;
  double sky_cd_m2_ = 0;  ///< luminance of the brightest sky so far
};

/// Text that identifies the colour transform of a view and display, regardless of their configuration's name.
std::string fingerprint(const Development& development, colour::WorkingSpace space);

/// Factor that converts luminance [cd/m²] to a scale on which white is 1.
double scale_of(const Development& development, const colour::Exposure& exposure);

/// Whether an exposure is that of a camera. This is the case if coppermoon made the frame, or if an exposure time,
/// f-number or camera model is set. Otherwise the frame may be in any unit of light.
bool is_a_cameras(const Development& development, const SeenFrame& seen);

/// Adds a camera's exposure to a header under OpenEXR's standard names. For a composite, it also adds
/// `coppermoon:longer_exposure_s`.
void add_exposure(texture::Attributes& attributes, const Exposures& exposures);

/// Adapts a development to screens of high dynamic range: the display becomes Rec.2100-PQ, with 16 bits.
Development of_high_range(Development development);

/// Throws Error when the development would fail for any frame: for a setting outside its range, a picture whose
///        ending is not in picture_files(), or a view that does not exist
void require_sound(const Development& development, const std::filesystem::path& picture);

/// The frame transformed for the display, which shows a luminance of 1/scale as white: channels R, G, B, 0 to 1.
texture::Image shown(const Development& development, double scale, const texture::Image& frame,
                     colour::WorkingSpace space);

/// Develops a frame [cd/m²] into a picture with channels R, G, B, 0 to 1. With a camera, the picture is the camera's
/// photograph, and the camera's files are written if they are requested.
///
/// A composite adds two exposures. A colour's brightest channel x, in units of saturation, becomes
/// 0.7 x_shorter + 0.3 (1 - exp(-x_longer)), and the other channels keep their ratios to it. Brighter ground thus stays
/// brighter. A camera takes the longer exposure of a scene that has already been dimmed to 1 - exp(-x), so that the
/// sensor does not clip and glare from the sunlit part does not drown the shadow.
texture::Image developed(const Development& development, const Exposures& exposures,
                         const Frame& frame);

/// Rows of the picture that a texture is developed into. The texture is treated like a frame without a camera.
texture::Rows developed_rows(const Development& development, const Exposures& exposures,
                             const LitTexture& texture);

/// Develops a texture and writes the picture. Only some rows are in memory at a time.
void write_picture(const Development& development, const Exposures& exposures,
                   const LitTexture& texture, const texture::Attributes& attributes,
                   const std::filesystem::path& picture);

/// Develops a scene-linear frame and writes the picture. An .avif file has high dynamic range (write_avif), for the
/// display Rec.2100-PQ. It shows saturation at 100 cd/m², and light above saturation at higher luminances.
///
/// Given  attributes  for the picture's header; those of the frame go into the camera's files
void write_picture(const Development& development, const Exposures& exposures, const Frame& frame,
                   texture::Attributes attributes, const std::filesystem::path& picture);

}  // namespace coppermoon::uses
