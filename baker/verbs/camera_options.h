// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "almanac/sky.h"
#include "colour/photograph.h"
#include "texture/image.h"
#include "verbs/flags.h"
#include "verbs/observer_options.h"

namespace coppermoon::verbs {

/// The help's title of all that a camera is, and of how it is set and its frame developed: the keys of
/// a recipe's [camera].
inline constexpr const char* camera_group = "The camera and the picture";

/// A camera between the scene and its picture. Without a model there is none: the picture is the
/// scene's, without noise.
struct CameraOptions {
  std::string model;
  std::optional<double> aperture_mm, obstruction, transmission, pixel_um, quantum_efficiency,
      full_well_e, read_noise_e, converter_noise_dn, black_level_dn, seeing_arcsec;
  std::optional<int> sensor_bits;
  std::optional<std::string> response, diffraction, noise, sky;
  std::uint64_t noise_seed = 1;
  std::string raw, photograph;  ///< files; empty: not written
};

void add_camera_options(CLI::App& verb, CameraOptions& options);

/// The camera, f-number and focal length its own unless they are given; nothing without a model.
///
/// Throws  Error  when anything of it is outside its range, or is given without a model
std::optional<colour::Camera> camera_of(const CameraOptions& options,
                                        const std::optional<double>& f_number = {},
                                        const std::optional<double>& focal_length_mm = {});

/// The view through a camera: focal length and sensor are its own unless they are given.
ViewOptions seen_through(const CameraOptions& options, ViewOptions view);

/// What a camera has to know of a frame beside its light.
struct Seen {
  double pixel_rad = 0;             ///< in the middle; 0: as the sensor's width says
  std::optional<double> sky_cd_m2;  ///< nothing: not known
};

/// Of a frame of that view; an observer's sky is lit by the Sun below the horizon.
Seen seen_by(const View& view, const almanac::SkyState& sky);

/// What a frame's header says.
Seen seen_by(const std::filesystem::path& frame);

/// The same, for the header.
void add_seen(texture::Attributes& attributes, const Seen& seen);

/// What the camera makes of a scene-linear frame; the sky's light as --sky says.
colour::Photograph photographed(const CameraOptions& options, const colour::Camera& camera,
                                const colour::Image& frame, colour::WorkingSpace space,
                                const Seen& seen, const colour::Exposure& exposure,
                                std::uint64_t number = 0);

}  // namespace coppermoon::verbs
