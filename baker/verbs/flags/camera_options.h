// SPDX-License-Identifier: MIT
#pragma once

#include "uses/picture/picture_parameters.h"
#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// Adds --raw and --photograph, with which the user names a raw file and a photograph to write.
void add_camera_file_options(Verb& verb, uses::CameraRequest& request);

/// Adds --space, which sets the colour space of a scene-linear frame.
void add_frame_space_option(Verb& verb, colour::WorkingSpace& space);

}  // namespace coppermoon::verbs
