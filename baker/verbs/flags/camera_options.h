// SPDX-License-Identifier: MIT
#pragma once

#include "uses/picture/picture_parameters.h"
#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// Files of one photograph: --raw, --photograph.
void add_camera_file_options(CLI::App& verb, uses::CameraRequest& request);

/// --space of a scene-linear frame.
void add_frame_space_option(CLI::App& verb, colour::WorkingSpace& space);

}  // namespace coppermoon::verbs
