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

/// How long a frame is exposed.
struct ExposureTime {
  enum class Rule {
    automatic,  ///< exposes the brightest hundredth of what is lit to 0.8 of saturation
    follow,     ///< exposes the cube of the mean cube root of luminance to 0.25: without a step
    composite,  ///< two exposures in one picture: one of what is bright, one of the shadow
    fixed
  };
  Rule rule = Rule::automatic;
  double seconds = 1;  ///< where it is fixed, 1e-6 to 1e6
};

/// How the camera is set and its frame developed.
struct Development {
  ExposureTime time{};
  std::optional<double> f_number{};  ///< without: 12.1, or the camera's
  double iso = 800;
  std::string view = "Un-tone-mapped", display = "sRGB",
              config;                       ///< of OpenColorIO; config: a file
  int bits = 8;                             ///< of a picture's number, 8 or 16
  CameraRequest camera{};                   ///< of a frame that is seen; no texture has one
  std::optional<double> focal_length_mm{};  ///< given for the view; without: the camera's
};

/// How the camera was set for a picture; for a composite the longer exposure's time too.
struct Exposures {
  colour::Exposure shorter;
  std::optional<double> longer_s = {};  ///< not less than the shorter one's
};

/// The camera's settings, the time by its rule; 1 s when nothing is lit.
///
/// Given  seen  the Moon's edge: what stands beside it, as stars, sets no exposure; without: all is counted.
///              The sky's light, which a camera adds to the Moon's
/// Throws Error when a setting is outside its range, or the frame has fewer than three channels
Exposures exposures_for(const Development& development, const texture::Image& frame,
                        colour::WorkingSpace space, const SeenFrame& seen = {});

/// How many times as bright the sky is as the Moon's brightest hundredth; 0 without a camera or a lit Moon.
///
/// Throws Error when the frame has fewer than three channels
double sky_over_moon(const Development& development, const texture::Image& frame,
                     colour::WorkingSpace space, const SeenFrame& seen);

/// Sums over luminances Y of what is lit [cd/m²], that exposure times follow from.
struct LitSums {
  std::size_t count = 0;
  double inverses = 0, cube_roots = 0, cubes = 0, fourth_powers = 0;

  void add(double luminance_cd_m2);
  void add(const LitSums& more);
};

/// Exposures that a set of frames shares, by the same rule as if they were one: told of each, it keeps
/// counts and sums alone.
///
/// Accuracy  automatic times to 1/2000: luminances are counted in steps of 2^-11
class SharedExposure {
 public:
  explicit SharedExposure(const Development& development);
  void add(const texture::Image& frame, colour::WorkingSpace space, const SeenFrame& seen = {});
  Exposures exposures() const;

 private:
  Development development_;
  std::vector<std::size_t> counts_;  ///< of luminances above 0, by their leading bits
  LitSums sums_;
};

/// Fingerprint of what the view and its display make of colours, whatever their configuration is called.
std::string fingerprint(const Development& development, colour::WorkingSpace space);

/// What a luminance of 1 cd/m² becomes where white is 1, at those settings.
double scale_of(const Development& development, const colour::Exposure& exposure);

/// The camera's settings under OpenEXR's standard names; `coppermoon:longer_exposure_s` of a composite.
void add_exposure(texture::Attributes& attributes, const Exposures& exposures);

/// The same for screens of high dynamic range: the display Rec.2100-PQ, in 16 bits.
Development of_high_range(Development development);

/// Throws Error when the development cannot be made whatever the frame holds: a setting outside its
/// range, a picture that ends neither in .png nor in .avif, a view there is not
void require_sound(const Development& development, const std::filesystem::path& picture);

/// A scene-linear frame as the display shows it, 1/scale of it as white: channels R, G, B, 0 to 1.
texture::Image shown(const Development& development, double scale, const texture::Image& frame,
                     colour::WorkingSpace space);

/// A scene-linear frame [cd/m²] as the display shows it: channels R, G, B, 0 to 1. With a camera, what
/// the camera sees of it; its own files are written, where any are asked for.
///
/// A composite lays the longer exposure under the shorter one. Where x is a luminance in units of
/// saturation, it becomes 0.7 x_shorter + 0.3 (1 - exp(-x_longer)), and a colour keeps its ratios: what
/// is brighter comes out brighter. A camera takes the longer one of ground that is dimmed so: its sensor does
/// not clip, at a quarter of the speed not even in red, and the glare of the sunlit part does not drown the
/// shadow.
texture::Image developed(const Development& development, const Exposures& exposures,
                         const Frame& frame);

/// Develops a scene-linear frame and writes the picture. One that ends in .avif is of high dynamic range
/// (write_avif), for the display Rec.2100-PQ: saturation is 100 cd/m², and what is brighter stays so.
///
/// Given  attributes  for the picture's header; those of the frame are for the camera's files
void write_picture(const Development& development, const Exposures& exposures, const Frame& frame,
                   texture::Attributes attributes, const std::filesystem::path& picture);

}  // namespace coppermoon::uses
