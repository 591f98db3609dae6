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
#include "uses/picture/view.h"

namespace coppermoon::uses {

/// A camera between the scene and its picture. Without a model there is none: the picture is the
/// scene's, without noise.
struct CameraRequest {
  std::string model{};  ///< one of colour::camera_names(); empty: none
  std::optional<double> aperture_mm{}, obstruction{}, transmission{}, pixel_um{},
      quantum_efficiency{}, full_well_e{}, read_noise_e{}, converter_noise_dn{}, black_level_dn{},
      seeing_arcsec{}, glow{};
  std::optional<int> sensor_bits{};
  std::optional<std::string> response{};       ///< one of colour::response_names()
  std::optional<bool> diffraction{}, noise{};  ///< without: on
  /// luminance of the sky; 0: none; without: twilight and airglow where the frame was seen from
  std::optional<double> sky_cd_m2{};
  std::uint64_t noise_seed = 1;
  std::filesystem::path raw{}, photograph{};  ///< files; empty: not written
};

/// The camera, f-number and focal length its own unless they are given; nothing without a model.
///
/// Throws  Error  when anything of it is outside its range, or is given without a model
std::optional<colour::Camera> camera_of(const CameraRequest& request,
                                        const std::optional<double>& f_number = {},
                                        const std::optional<double>& focal_length_mm = {});

/// The view through a camera: focal length and sensor are its own unless they are given.
ViewRequest seen_through(const CameraRequest& request, ViewRequest view);

/// Angle that a pixel takes in, in the middle of a frame.
double pixel_rad_of(const povray_scenes::SceneCamera& camera);

/// What the development has to know of a frame beside its light.
struct SeenFrame {
  double pixel_rad = 0;                  ///< in the middle; 0: as the sensor's width says
  std::optional<double> sky_cd_m2 = {};  ///< nothing: not known
  std::optional<DiscOutline> disc = {};  ///< the Moon's edge; nothing: not known
};

/// The same for a frame of that view; an observer's sky is lit by the Sun below the horizon.
SeenFrame seen_by(const View& view, const almanac::SkyState& sky);

/// What a frame's header says.
SeenFrame seen_by(const std::filesystem::path& frame);

/// The same, for the header.
void add_seen(texture::Attributes& attributes, const SeenFrame& seen);

/// A scene-linear frame on its way to a picture.
struct Frame {
  const texture::Image& light;  ///< [cd/m²]
  colour::WorkingSpace space;
  SeenFrame seen = {};
  std::uint64_t number = 0;             ///< for noise of its own
  texture::Attributes attributes = {};  ///< for the headers of files made from it
};

/// Luminance that the sky adds before a camera [cd/m²]: what is asked for, or the frame's; 0 without a model.
double sky_before(const CameraRequest& request, const SeenFrame& seen);

/// What the camera makes of a scene-linear frame.
colour::Photograph photographed(const CameraRequest& request, const colour::Camera& camera,
                                const Frame& frame, const colour::Exposure& exposure);

}  // namespace coppermoon::uses
