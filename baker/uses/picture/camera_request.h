// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "almanac/sky.h"
#include "colour/photograph.h"
#include "texture/image.h"
#include "uses/picture/disc_outline.h"
#include "uses/picture/frame_sky.h"
#include "uses/picture/view.h"

namespace coppermoon::uses {

/// A requested camera. If no model is named, the picture shows the scene itself, without noise. If a spectral response
/// is given, the picture has the colours that a sensor with this response records.
struct CameraRequest {
  std::string model{};  ///< one of colour::camera_names(); if empty, no camera
  std::optional<double> aperture_mm{}, obstruction{}, transmission{}, pixel_um{},
      quantum_efficiency{}, full_well_e{}, read_noise_e{}, converter_noise_dn{}, black_level_dn{},
      seeing_arcsec{}, glow{};
  std::optional<int> sensor_bits{};
  std::optional<std::string> response{};       ///< one of colour::response_names(), or a .csv file
  std::optional<bool> diffraction{}, noise{};  ///< if absent, on
  std::size_t noise_seed = 1;
  std::filesystem::path raw{}, photograph{};  ///< files to write; if empty, none
};

/// The camera that a request describes, with the model's f-number and focal length unless others are given; nothing if
/// the request names no model.
///
/// Throws  Error  when a setting is outside its range, or is given without a model
std::optional<colour::Camera> camera_of(const CameraRequest& request,
                                        const std::optional<double>& f_number = {},
                                        const std::optional<double>& focal_length_mm = {});

/// The spectral response that a request names, if any. It must be known before the Moon's light is computed.
std::optional<std::string> spectral_response(const CameraRequest& request);

/// The view with the focal length and sensor width of the camera, unless it already has values for them.
ViewRequest seen_through(const CameraRequest& request, ViewRequest view);

/// Angle across a pixel in the middle of a frame [rad].
double pixel_rad_of(const povray_scenes::SceneCamera& camera);

/// Facts about a frame that are needed to develop it, in addition to its light.
struct SeenFrame {
  double pixel_rad = 0;  ///< angle across the middle pixel; if 0, computed from the sensor's width
  /// Luminance of the sky towards the Moon. The sky's light is included in every pixel, on the Moon and beside it.
  /// 0 if the frame holds no sky.
  double sky_cd_m2 = 0;
  std::optional<DiscOutline> disc = {};  ///< the Moon's edge, if known
  bool of_another_program = false;       ///< whether another program wrote the frame
  /// Luminance of a sky that the header states but the pixels lack, as in files from older versions; otherwise 0.
  double sky_left_out_cd_m2 = 0;
};

/// Facts for developing a frame, derived from its view and its sky.
SeenFrame seen_by(const View& view, const FrameSky& sky);

/// Facts for developing a frame, read from its header.
SeenFrame seen_by(const std::filesystem::path& frame);

/// Adds the facts for developing a frame to its header.
void add_seen(texture::Attributes& attributes, const SeenFrame& seen);

/// A scene-linear frame that is to be developed.
struct Frame {
  const texture::Image& light;  ///< [cd/m²]
  colour::WorkingSpace space;
  SeenFrame seen = {};
  std::uint64_t number = 0;             ///< frame number, so that noise differs between frames
  texture::Attributes attributes = {};  ///< for the headers of the camera's files
};

/// Photographs a scene-linear frame. Scattered light (glow) is computed as if the sky continued beyond the frame.
colour::Photograph photographed(const CameraRequest& request, const colour::Camera& camera,
                                const Frame& frame, const colour::Exposure& exposure);

/// Checks the name of a raw file before the photograph is taken.
///
/// Throws  Error  when it ends in neither .tif nor .dng, or is a .dng for a sensor without colours
void require_raw_file(const std::filesystem::path& file, const colour::Camera& camera);

/// Writes the sensor's raw numbers. A .tif file holds all three channels of every pixel. A .dng file is for raw
/// converters: it holds one channel of each pixel, as behind a mosaic of colour filters, and its as-shot white is D65.
///
/// Given   attributes  may include the moment and the exposure, which become EXIF data
/// Throws  Error       when require_raw_file or texture::write_dng does
void write_raw(const std::filesystem::path& file, const CameraRequest& request,
               const colour::Camera& camera, double iso, const colour::Photograph& photograph,
               const texture::Attributes& attributes);

}  // namespace coppermoon::uses
