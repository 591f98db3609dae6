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

/// Camera as asked for. Without a model the picture is the scene itself, without noise, in colours of a spectral
/// response where one is given.
struct CameraRequest {
  std::string model{};  ///< one of colour::camera_names(); empty: none
  std::optional<double> aperture_mm{}, obstruction{}, transmission{}, pixel_um{},
      quantum_efficiency{}, full_well_e{}, read_noise_e{}, converter_noise_dn{}, black_level_dn{},
      seeing_arcsec{}, glow{};
  std::optional<int> sensor_bits{};
  std::optional<std::string> response{};       ///< one of colour::response_names(), or a .csv file
  std::optional<bool> diffraction{}, noise{};  ///< without: on
  std::uint64_t noise_seed = 1;
  std::filesystem::path raw{}, photograph{};  ///< files; empty: not written
};

/// Camera of a request; its own f-number and focal length hold unless others are given; nothing without a model.
///
/// Throws  Error  when anything of it is outside its range, or is given without a model
std::optional<colour::Camera> camera_of(const CameraRequest& request,
                                        const std::optional<double>& f_number = {},
                                        const std::optional<double>& focal_length_mm = {});

/// Response of a request where it is spectral: the Moon is then seen through it from the start.
std::optional<std::string> spectral_response(const CameraRequest& request);

/// View with the focal length and sensor of a camera, unless others are given.
ViewRequest seen_through(const CameraRequest& request, ViewRequest view);

/// Angle across a pixel in the middle of a frame.
double pixel_rad_of(const povray_scenes::SceneCamera& camera);

/// Facts of a frame that its development needs beside its light.
struct SeenFrame {
  double pixel_rad = 0;  ///< angle across the middle pixel; 0: from the sensor's width
  /// Luminance of the sky towards the Moon that the frame holds: the light of each pixel has it, on the Moon as beside
  /// it; 0: none
  double sky_cd_m2 = 0;
  std::optional<DiscOutline> disc = {};  ///< the Moon's edge; nothing: not known
  bool of_another_program = false;       ///< by its header
  /// Luminance of a sky that the header of an older version's frame names, but the frame holds not; 0: none
  double sky_left_out_cd_m2 = 0;
};

/// Facts of a frame of a view, and of the sky in it.
SeenFrame seen_by(const View& view, const FrameSky& sky);

/// Facts of a frame by its header.
SeenFrame seen_by(const std::filesystem::path& frame);

/// Header attributes of such facts.
void add_seen(texture::Attributes& attributes, const SeenFrame& seen);

/// Scene-linear frame to be developed.
struct Frame {
  const texture::Image& light;  ///< [cd/m²]
  colour::WorkingSpace space;
  SeenFrame seen = {};
  std::uint64_t number = 0;             ///< for noise of its own
  texture::Attributes attributes = {};  ///< for the headers of files made from it
};

/// Photograph of a scene-linear frame. Its sky goes on beyond the frame, for the glow.
colour::Photograph photographed(const CameraRequest& request, const colour::Camera& camera,
                                const Frame& frame, const colour::Exposure& exposure);

/// Refuses a raw file before its photograph is taken.
///
/// Throws  Error  when it ends neither in .tif nor in .dng, or is a .dng of a sensor without colours
void require_raw_file(const std::filesystem::path& file, const colour::Camera& camera);

/// Writes what the sensor counted: all three channels of every pixel into a .tif; into a .dng one channel of each, as
/// the sensor's mosaic of colour filters has it, for raw converters. White under D65 is its as-shot white balance.
///
/// Given   attributes  moment and exposure become EXIF's
/// Throws  Error       as require_raw_file and texture::write_dng
void write_raw(const std::filesystem::path& file, const CameraRequest& request,
               const colour::Camera& camera, double iso, const colour::Photograph& photograph,
               const texture::Attributes& attributes);

}  // namespace coppermoon::uses
