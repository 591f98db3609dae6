// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "colour/exposure.h"
#include "colour/working_space.h"
#include "texture/image.h"
#include "uses/picture/camera.h"

namespace coppermoon::uses {

/// Rule for the exposure time of a frame.
struct ExposureTime {
  enum class Rule {
    automatic,  ///< 99th percentile of lit ground at 0.8 of saturation, in its brightest channel
    follow,  ///< cube of the mean cube root of brightest channels at 0.25: no step when totality begins
    composite,  ///< two exposures in one picture, for the bright part and for the shadow: films
    fixed
  };
  Rule rule = Rule::automatic;
  double seconds = 1;  ///< of a fixed exposure, 1e-6 to 1e6
};

/// Settings of camera and development.
struct Development {
  ExposureTime time{};
  std::optional<double> f_number{};  ///< without: 12.1, or the camera's
  double iso = 800;
  std::string
      view = "Hue-preserving",
      display = "sRGB",
      config;  ///< of OpenColorIO; config: a file, or ocio://…; empty: as colour::config_for
  std::string
      config_space{};      ///< colour space of the configuration that frames are in; empty: found
  int bits = 8;            ///< of a picture's number, 8 or 16
  bool caption = false;    ///< local time, place and contact are written into pictures
  CameraRequest camera{};  ///< of a frame that is seen; no texture has one
  std::optional<double> focal_length_mm{};  ///< given for the view; without: the camera's
};

/// Exposure of a picture; of a composite both exposures.
struct Exposures {
  colour::Exposure shorter;
  std::optional<double> longer_s = {};  ///< not less than the shorter one's
  bool a_cameras = true;                ///< else it only says which luminance is white
};

/// Exposure by the rule of a development, for Moon and sky: by the Moon's pixels, which hold the sky's light too, but no
/// longer than brings the sky to its own level, 0.1 of saturation at night to 0.4 of a day. Of a frame in which nothing
/// of the Moon is lit, that of the sky; 1 s where that is black.
///
/// Given  seen  outline of the Moon: stars beside it are not counted; without: all pixels are
/// Throws Error when a setting is outside its range, or the frame has fewer than three channels
Exposures exposures_for(const Development& development, const texture::Image& frame,
                        colour::WorkingSpace space, const SeenFrame& seen = {});

/// Scene-linear texture to be developed [cd/m²], whose rows may be asked for again.
struct LitTexture {
  texture::Layout layout;
  texture::Rows rows;
  colour::WorkingSpace space;
};

/// Exposure of a texture, as of a frame of its texels without a camera; some rows are in memory at a time.
Exposures exposures_for(const Development& development, const LitTexture& texture);

/// Luminance of the sky that a frame holds over the 99th percentile of the Moon's own; 0 without a sky or a lit Moon.
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

/// Exposure shared by a set of frames, by the rule for a single one applied to all their pixels. Only counts and
/// sums are kept.
///
/// Accuracy  automatic times to 1/2000: levels are counted in steps of 2^-11
class SharedExposure {
 public:
  explicit SharedExposure(const Development& development);
  void add(const texture::Image& frame, colour::WorkingSpace space, const SeenFrame& seen = {});
  Exposures exposures() const;

 private:
  Development development_;
  std::vector<std::size_t> counts_;  ///< of brightest channels above 0, by their leading bits
  LitSums sums_;
  double sky_cd_m2_ = 0;  ///< the brightest
};

/// Identifier of the colour transform of view and display, whatever their configuration is called.
std::string fingerprint(const Development& development, colour::WorkingSpace space);

/// Factor from luminance [cd/m²] to the scale on which white is 1.
double scale_of(const Development& development, const colour::Exposure& exposure);

/// Whether an exposure is a camera's: of a file of ours, which holds the Moon's light, or of one whose time, f-number or
/// model is given. Another program's scene may be of any light.
bool is_a_cameras(const Development& development, const SeenFrame& seen);

/// Adds an exposure that is a camera's under OpenEXR's standard names; of a composite also
/// `coppermoon:longer_exposure_s`.
void add_exposure(texture::Attributes& attributes, const Exposures& exposures);

/// Development for screens of high dynamic range: the display Rec.2100-PQ, in 16 bits.
Development of_high_range(Development development);

/// Throws Error when the development cannot be made whatever the frame holds: a setting outside its
/// range, a picture that ends in none of picture_files(), a view there is not
void require_sound(const Development& development, const std::filesystem::path& picture);

/// Frame transformed for its display, with luminance 1/scale as white: channels R, G, B, 0 to 1.
texture::Image shown(const Development& development, double scale, const texture::Image& frame,
                     colour::WorkingSpace space);

/// Developed picture of a frame [cd/m²]: channels R, G, B, 0 to 1. With a camera it is the camera's photograph, whose
/// own files are written where asked for.
///
/// A composite lays the longer exposure under the shorter one. Where x is a colour's brightest channel in units of
/// saturation, it becomes 0.7 x_shorter + 0.3 (1 - exp(-x_longer)), and a colour keeps its ratios: what
/// is brighter comes out brighter. A camera takes the longer one of ground that is dimmed so: its sensor does
/// not clip, and the glare of the sunlit part does not drown the shadow.
texture::Image developed(const Development& development, const Exposures& exposures,
                         const Frame& frame);

/// Rows of the developed picture of a texture, as of a frame of its texels without a camera.
texture::Rows developed_rows(const Development& development, const Exposures& exposures,
                             const LitTexture& texture);

/// Develops a texture and writes the picture, as below; some rows are in memory at a time.
void write_picture(const Development& development, const Exposures& exposures,
                   const LitTexture& texture, const texture::Attributes& attributes,
                   const std::filesystem::path& picture);

/// Develops a scene-linear frame and writes the picture. One that ends in .avif is of high dynamic range
/// (write_avif), for the display Rec.2100-PQ: saturation is 100 cd/m², and what is brighter stays so.
///
/// Given  attributes  for the picture's header; those of the frame are for the camera's files
void write_picture(const Development& development, const Exposures& exposures, const Frame& frame,
                   texture::Attributes attributes, const std::filesystem::path& picture);

}  // namespace coppermoon::uses
