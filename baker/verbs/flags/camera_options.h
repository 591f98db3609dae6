// SPDX-License-Identifier: MIT
#pragma once

#include "uses/picture/picture_parameters.h"
#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// Files of one photograph: --raw, --photograph.
void add_camera_file_options(Verb& verb, uses::CameraRequest& request);

/// --space of a scene-linear frame.
void add_frame_space_option(Verb& verb, colour::WorkingSpace& space);

}  // namespace coppermoon::verbs
