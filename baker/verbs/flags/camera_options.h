// SPDX-License-Identifier: MIT
#pragma once

#include "uses/picture/camera.h"
#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// The help's title of all that a camera is, and of how it is set and its frame developed: the keys of
/// a recipe's [camera].
inline constexpr const char* camera_group = "The camera and the picture";

/// The camera, its optics, sensor and sky.
void add_camera_options(CLI::App& verb, uses::CameraRequest& request);

/// Files of one photograph: --raw, --photograph.
void add_camera_file_options(CLI::App& verb, uses::CameraRequest& request);

}  // namespace coppermoon::verbs
