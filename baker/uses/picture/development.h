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
    automatic,  ///< puts the 99th percentile of lit ground at 0.8 of saturation (brightest channel)
    follow,     ///< puts the cubed mean cube root of brightest channels at 0.25: smooth at totality
    composite,  ///< for films: two exposures in one picture, for the bright part and the shadow
    fixed
  };
  Rule rule = Rule::automatic;
  double seconds = 1;  ///< for a fixed exposure, 1e-6 to 1e6
};

/// Settings for the camera and the development.
struct Development {
  ExposureTime time{};
  std::optional<double> f_number{};  ///< if absent, the camera's, or 12.1 without a camera
  double iso = 800;
  std::string
      view = "Hue-preserving",
      display = "sRGB",
      config;  ///< for OpenColorIO; config: a file, or ocio://…; if empty, as colour::config_for
  std::string
      config_space{};      ///< the frames' colour space in the configuration; if empty, it is found
  int bits = 8;            ///< per number in a picture, 8 or 16
  bool caption = false;    ///< write local time, place and contact into pictures
  CameraRequest camera{};  ///< for frames; textures have no camera
  std::optional<double> focal_length_mm{};  ///< given for the view; if absent, the camera's
};

/// Exposure of a picture, or both exposures of a composite.
struct Exposures {
  colour::Exposure shorter;
  std::optional<double> longer_s = {};  ///< not less than the shorter one's
  bool a_cameras = true;                ///< otherwise it only says which luminance is white
};

/// Exposure by the rule of a development. It follows from the Moon's pixels, which hold the sky's light too, but is no
/// longer than brings the sky to its own level, from 0.1 of saturation at night to 0.4 by day. If nothing of the Moon
/// is lit, the sky alone decides; if the sky is black too, it is 1 s.
///
/// Given  seen  if it has the Moon's outline, stars beside the Moon are not counted; otherwise all pixels are
/// Throws Error when a setting is outside its range, or the frame has fewer than three channels
Exposures exposures_for(const Development& development, const texture::Image& frame,
                        colour::WorkingSpace space, const SeenFrame& seen = {});

/// Scene-linear texture to be developed [cd/m²], whose rows may be asked for more than once.
struct LitTexture {
  texture::Layout layout;
  texture::Rows rows;
  colour::WorkingSpace space;
};

/// Exposure for a texture, as if its texels were a frame without a camera. Only some rows are in memory at a time.
Exposures exposures_for(const Development& development, const LitTexture& texture);

/// Ratio of the sky's luminance in a frame to the 99th percentile of the Moon's own; 0 without a sky or a lit Moon.
///
/// Throws Error when the frame has fewer than three channels
double sky_over_moon(const texture::Image& frame, colour::WorkingSpace space,
                     const SeenFrame& seen);

/// Sums over the brightest channels of lit pixels [cd/m²], from which exposure times follow.
struct LitSums {
  std::size_t count = 0;
  double inverses = 0, cube_roots = 0, cubes = 0, fourth_powers = 0;

  void add(double brightest_cd_m2);
};

/// Exposure shared by a set of frames: the rule for a single frame, applied to the pixels of all of them. Only counts
/// and sums are kept.
///
/// Accuracy  automatic times to 1/2000, since levels are counted in steps of 2^-11
class SharedExposure {
 public:
  explicit SharedExposure(const Development& development);
  void add(const texture::Image& frame, colour::WorkingSpace space, const SeenFrame& seen = {});
  Exposures exposures() const;

 private:
  Development development_;
  std::vector<std::size_t> counts_;  ///< of brightest channels above 0, by their leading bits
  LitSums sums_;
  double sky_cd_m2_ = 0;  ///< the brightest sky so far
};

/// Identifies the colour transform of view and display, whatever their configuration is called.
std::string fingerprint(const Development& development, colour::WorkingSpace space);

/// Factor from luminance [cd/m²] to the scale on which white is 1.
double scale_of(const Development& development, const colour::Exposure& exposure);

/// Whether an exposure is a camera's: if the file is ours, and so holds the Moon's light, or if the time, f-number or
/// camera model is given. Another program's scene may be in any unit of light.
bool is_a_cameras(const Development& development, const SeenFrame& seen);

/// Adds a camera's exposure under OpenEXR's standard names, and for a composite also
/// `coppermoon:longer_exposure_s`.
void add_exposure(texture::Attributes& attributes, const Exposures& exposures);

/// The development changed for screens of high dynamic range: display Rec.2100-PQ, in 16 bits.
Development of_high_range(Development development);

/// Throws Error when the development would fail whatever the frame holds: for a setting outside its range, a
///        picture whose ending is in none of picture_files(), or a view that does not exist
void require_sound(const Development& development, const std::filesystem::path& picture);

/// The frame transformed for its display, with luminance 1/scale shown as white: channels R, G, B, 0 to 1.
texture::Image shown(const Development& development, double scale, const texture::Image& frame,
                     colour::WorkingSpace space);

/// Develops a frame [cd/m²] into a picture: channels R, G, B, 0 to 1. With a camera it is the camera's photograph, and
/// the camera's own files are written if asked for.
///
/// A composite lays the longer exposure under the shorter one. If x is a colour's brightest channel in units of
/// saturation, it becomes 0.7 x_shorter + 0.3 (1 - exp(-x_longer)), and the colour keeps its ratios: what
/// is brighter comes out brighter. A camera takes the longer exposure of ground dimmed in this way: its sensor does
/// not clip, and the glare of the sunlit part does not drown the shadow.
texture::Image developed(const Development& development, const Exposures& exposures,
                         const Frame& frame);

/// Rows of a texture's developed picture, as if its texels were a frame without a camera.
texture::Rows developed_rows(const Development& development, const Exposures& exposures,
                             const LitTexture& texture);

/// Develops a texture and writes the picture, as below. Only some rows are in memory at a time.
void write_picture(const Development& development, const Exposures& exposures,
                   const LitTexture& texture, const texture::Attributes& attributes,
                   const std::filesystem::path& picture);

/// Develops a scene-linear frame and writes the picture. A picture that ends in .avif has high dynamic range
/// (write_avif), for the display Rec.2100-PQ: saturation is 100 cd/m², and what is brighter stays brighter.
///
/// Given  attributes  for the picture's header; the frame's own are for the camera's files
void write_picture(const Development& development, const Exposures& exposures, const Frame& frame,
                   texture::Attributes attributes, const std::filesystem::path& picture);

}  // namespace coppermoon::uses
