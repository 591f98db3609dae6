// SPDX-License-Identifier: MIT
#pragma once

#include "uses/picture/picture_parameters.h"
#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// Adds --raw and --photograph, which name the files to write for one photograph.
void add_camera_file_options(Verb& verb, uses::CameraRequest& request);

/// Adds --space, the colour space of a scene-linear frame.
void add_frame_space_option(Verb& verb, colour::WorkingSpace& space);

}  // namespace coppermoon::verbs
