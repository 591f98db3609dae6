// SPDX-License-Identifier: MIT
#include "verbs/flags/camera_options.h"

namespace coppermoon::verbs {

void add_camera_file_options(Verb& verb, uses::CameraRequest& request) {
  add_flag(
      verb, "--raw", request.raw,
      "writes the sensor's raw numbers too: .tif, three channels of 16 bits, or .dng, its mosaic "
      "of colour filters for raw converters")
      .in(uses::camera_heading)
      .writes_file();
  add_flag(verb, "--photograph", request.photograph,
           "writes what the camera saw too: .exr, scene-linear [cd/m2]")
      .in(uses::camera_heading)
      .writes_file();
}

void add_frame_space_option(Verb& verb, colour::WorkingSpace& space) {
  add_parsed(
      verb, "--space", [&space](const std::string& name) { space = colour::working_space(name); },
      "colour space of the scene-linear frame: lin_rec709, acescg or lin_ciexyzd65_scene",
      std::string(colour::name(space)));
}

}  // namespace coppermoon::verbs
