// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "algebra/error.h"
#include "files/whole_file.h"
#include "texture/read_image.h"
#include "uses/picture/photo_file.h"
#include "verbs/command_line.h"
#include "verbs/flags/camera_options.h"
#include "verbs/flags/develop_options.h"
#include "verbs/recipes/recipe.h"
#include "verbs/reports/in_words.h"
#include "verbs/reports/one_line.h"

namespace coppermoon::verbs {
namespace {

struct Options {
  uses::Development develop;
  std::string frame, output, space;
  bool json = false;
};

/// The space the file's header or name says; else linear Rec.709.
colour::WorkingSpace space_of(const Options& options) {
  if (!options.space.empty()) return colour::working_space(options.space);
  if (const auto told = texture::read_attribute(options.frame, "coppermoon:colour_space"))
    return colour::working_space(*told);
  const auto stem = std::filesystem::path(options.frame).stem().string();
  return colour::space_in_name(stem).value_or(colour::WorkingSpace::linear_rec709);
}

texture::Image read_frame(const std::string& frame, colour::WorkingSpace space) {
  if (space == colour::WorkingSpace::ciexyz_d65)
    return texture::read_channels(frame, {"X", "Y", "Z"});
  return texture::read_channels(frame, {"R", "G", "B"});
}

void run(const Options& options) {
  require_sound(options.develop, options.output);
  const auto& camera = options.develop.camera;
  for (const auto& file : {std::filesystem::path(options.output), camera.raw, camera.photograph})
    if (!file.empty()) files::require_place_for(file);
  const auto space = space_of(options);
  const auto frame = read_frame(options.frame, space);
  const auto exposure = exposure_for(options.develop, frame, space);
  const auto seen = uses::seen_by(std::filesystem::path(options.frame));
  const auto picture = taken(options.develop, exposure,
                             {frame, space, seen, 0, uses::scene_attributes(options.frame)});
  write_developed(options.develop, exposure, {picture, space}, options.output);
  const nlohmann::ordered_json all{{"file", options.output},
                                   {"colour_space", colour::name(space)},
                                   {"time_s", exposure.time_s},
                                   {"f_number", exposure.f_number},
                                   {"iso", exposure.iso}};
  if (options.json)
    fmt::print("{}\n", all.dump(2));
  else
    fmt::print("{}: exposed for {}, f/{:g}, ISO {:g}\n", one_line(options.output),
               exposure_in_words(exposure.time_s), exposure.f_number, exposure.iso);
}

}  // namespace

void add_develop(CLI::App& program) {
  auto* verb =
      add_verb(program, "develop",
               "develops a scene-linear frame: exposure, camera and view make a picture of it");
  const auto options = std::make_shared<Options>();
  add_flag(*verb, "frame,--frame", options->frame, "frame, scene-linear, .exr [cd/m²]")
      .reads_file()
      .required();
  add_flag(*verb, "-o,--output", options->output, "picture, .png").writes_file().required();
  add_flag(*verb, "--space", options->space,
           "colour space of the frame: lin_rec709, acescg or lin_ciexyzd65_scene; what the header "
           "or the name says, unless given");
  add_develop_options(*verb, options->develop);
  add_camera_options(*verb, options->develop.camera);
  add_camera_file_options(*verb, options->develop.camera);
  add_switch(*verb, "--json", options->json, "prints one JSON document");
  add_recipe_option(*verb);
  on_run(*verb, [options] { run(*options); });
}

}  // namespace coppermoon::verbs
