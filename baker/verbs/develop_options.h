// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "colour/exposure.h"
#include "colour/working_space.h"
#include "texture/image.h"
#include "verbs/camera_options.h"
#include "verbs/flags.h"

namespace coppermoon::verbs {

/// How the camera is set and its frame developed.
struct DevelopOptions {
  std::string time = "auto";
  std::optional<double> f_number;  ///< without: 12.1, or the camera's
  double iso = 800;
  std::string view = "Un-tone-mapped", display = "sRGB", config;
  int bits = 8;
  CameraOptions camera;                   ///< of a frame that is seen; no texture has one
  std::optional<double> focal_length_mm;  ///< given for the view; without: the camera's
};

void add_develop_options(CLI::App& verb, DevelopOptions& options);

/// The camera's settings; "auto" becomes the time at which the brightest hundredth of what is lit
/// in the frame comes to 0.8 of saturation, "follow" the one at which the cube of the mean cube
/// root of luminance comes to 0.25; or 1 s when nothing is lit.
///
/// Throws Error when a setting is outside its range, or the frame has fewer than three channels
colour::Exposure exposure_for(const DevelopOptions& options, const texture::Image& frame,
                              colour::WorkingSpace space);

/// Of what the view and its display make of colours, whatever their configuration is called.
std::string fingerprint(const DevelopOptions& options, colour::WorkingSpace space);

/// What a luminance of 1 cd/m² becomes where white is 1, at those settings.
double scale_of(const DevelopOptions& options, const colour::Exposure& exposure);

/// What the camera sees of a scene-linear frame, by the same unit; the frame itself without one. The
/// camera's own files are written, where any are asked for.
///
/// Given  number      of the frame, for noise of its own
///        attributes  for those files' headers
texture::Image taken(const DevelopOptions& options, const colour::Exposure& exposure,
                     const texture::Image& frame, colour::WorkingSpace space, const Seen& seen,
                     std::uint64_t number = 0, const texture::Attributes& attributes = {});

/// The camera's settings under OpenEXR's standard names.
void add_exposure(texture::Attributes& attributes, const colour::Exposure& exposure);

/// Throws Error when the options cannot be met whatever the frame holds: a setting outside its
/// range, a picture that does not end in .png, a view there is not
void require_sound(const DevelopOptions& options, const std::filesystem::path& picture);

/// A scene-linear frame as the display shows it, 1/scale of it as white: channels R, G, B, 0 to 1.
texture::Image shown(const DevelopOptions& options, double scale, const texture::Image& frame,
                     colour::WorkingSpace space);

/// A scene-linear frame [cd/m²] as the display shows it: channels R, G, B, 0 to 1.
texture::Image developed(const DevelopOptions& options, const colour::Exposure& exposure,
                         const texture::Image& frame, colour::WorkingSpace space);

/// Develops a scene-linear frame [cd/m²] and writes the picture.
void write_developed(const DevelopOptions& options, const colour::Exposure& exposure,
                     const texture::Image& frame, colour::WorkingSpace space,
                     const std::filesystem::path& picture, texture::Attributes attributes);

}  // namespace coppermoon::verbs
