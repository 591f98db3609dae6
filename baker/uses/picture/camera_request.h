// SPDX-License-Identifier: MIT
#pragma once

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

/// The camera asked for. Without a model, the picture shows the scene itself, without noise, in the colours of the
/// spectral response if one is given.
struct CameraRequest {
  std::string model{};  ///< one of colour::camera_names(); if empty, no camera
  std::optional<double> aperture_mm{}, obstruction{}, transmission{}, pixel_um{},
      quantum_efficiency{}, full_well_e{}, read_noise_e{}, converter_noise_dn{}, black_level_dn{},
      seeing_arcsec{}, glow{};
  std::optional<int> sensor_bits{};
  std::optional<std::string> response{};       ///< one of colour::response_names(), or a .csv file
  std::optional<bool> diffraction{}, noise{};  ///< if absent, on
  std::uint64_t noise_seed = 1;
  std::filesystem::path raw{}, photograph{};  ///< files; if empty, not written
};

/// The camera that a request describes, with its own f-number and focal length unless others are given; nothing if no
/// model is named.
///
/// Throws  Error  when a setting is outside its range, or is given without a model
std::optional<colour::Camera> camera_of(const CameraRequest& request,
                                        const std::optional<double>& f_number = {},
                                        const std::optional<double>& focal_length_mm = {});

/// The response that a request names, if it is spectral: the Moon's light is then computed through it from the start.
std::optional<std::string> spectral_response(const CameraRequest& request);

/// The view with the camera's focal length and sensor, unless the view gives its own.
ViewRequest seen_through(const CameraRequest& request, ViewRequest view);

/// Angle across a pixel in the middle of a frame [rad].
double pixel_rad_of(const povray_scenes::SceneCamera& camera);

/// What the development of a frame needs to know besides its light.
struct SeenFrame {
  double pixel_rad = 0;  ///< angle across the middle pixel; if 0, computed from the sensor's width
  /// Luminance of the sky towards the Moon, which the light of each pixel includes, on the Moon and beside it;
  /// 0 if the frame holds no sky
  double sky_cd_m2 = 0;
  std::optional<DiscOutline> disc = {};  ///< the Moon's edge, if known
  bool of_another_program = false;       ///< according to its header
  /// Luminance of a sky that the header of a frame from an older version names but the frame does not hold; else 0
  double sky_left_out_cd_m2 = 0;
};

/// What is known about a frame from its view and the sky in it.
SeenFrame seen_by(const View& view, const FrameSky& sky);

/// What a frame's header tells about it.
SeenFrame seen_by(const std::filesystem::path& frame);

/// Adds these facts to a header.
void add_seen(texture::Attributes& attributes, const SeenFrame& seen);

/// Scene-linear frame to be developed.
struct Frame {
  const texture::Image& light;  ///< [cd/m²]
  colour::WorkingSpace space;
  SeenFrame seen = {};
  std::uint64_t number = 0;             ///< for noise of its own
  texture::Attributes attributes = {};  ///< for the headers of files made from it
};

/// Takes a photograph of a scene-linear frame. For the glow, the sky is taken to continue beyond the frame.
colour::Photograph photographed(const CameraRequest& request, const colour::Camera& camera,
                                const Frame& frame, const colour::Exposure& exposure);

/// Refuses a raw file before its photograph is taken.
///
/// Throws  Error  when it ends in neither .tif nor .dng, or is a .dng for a sensor without colours
void require_raw_file(const std::filesystem::path& file, const colour::Camera& camera);

/// Writes what the sensor counted. A .tif gets all three channels of every pixel; a .dng, for raw converters, gets
/// one channel of each pixel, as the sensor's mosaic of colour filters dictates. Its as-shot white is D65.
///
/// Given   attributes  the moment and exposure among them become EXIF data
/// Throws  Error       as require_raw_file and texture::write_dng
void write_raw(const std::filesystem::path& file, const CameraRequest& request,
               const colour::Camera& camera, double iso, const colour::Photograph& photograph,
               const texture::Attributes& attributes);

}  // namespace coppermoon::uses
