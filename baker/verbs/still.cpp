// SPDX-License-Identifier: MIT
#include <memory>

#include "povray_scenes/render.h"
#include "texture/read_image.h"
#include "texture/write_image.h"
#include "verbs/develop_options.h"
#include "verbs/lit_scene.h"
#include "verbs/pixels.h"
#include "verbs/progress_bar.h"
#include "verbs/recipe.h"
#include "verbs/report.h"
#include "verbs/temporary_folder.h"
#include "verbs/verbs.h"

namespace coppermoon::verbs {
namespace {

struct Options {
  MoonOptions moon;
  ViewOptions view;
  DevelopOptions develop;
  std::string output, frame;
  bool json = false;
};

/// Returned  the frame, and the seconds until it was begun
std::pair<texture::Image, double> rendered(const LitScene& scene) {
  const TemporaryFolder folder;
  write_lit_scene(folder.path(), scene, {.packed = false});
  const double seconds = scene.moon.seconds();
  ProgressBar bar("render");
  return {texture::read_image(povray_scenes::render(folder.path(), {}, bar.progress())), seconds};
}

void run(const CLI::App& verb, Options options) {
  options.view = seen_through(options.develop.camera, options.view);
  options.develop.focal_length_mm = options.view.focal_length_mm;
  require_sound(options.develop, options.output);
  require_place_for(options.output);
  require_temporary_folder();
  for (const auto& file :
       {options.frame, options.develop.camera.raw, options.develop.camera.photograph})
    if (!file.empty()) require_place_for(file);
  const auto recipe = recipe_of(verb);
  const auto scene =
      lit_scene(options.moon, options.view, recipe, texture::Extent::seen_from_earth);
  const auto [frame, seconds] = rendered(scene);
  const auto exposure = exposure_for(options.develop, frame, picture_space);
  const auto seen = seen_by(scene.view, scene.moon.sky);
  auto attributes = scene.texture.attributes;
  if (!options.frame.empty()) {
    add_exposure(attributes, exposure);
    add_seen(attributes, seen);
    texture::write_exr(options.frame, frame, attributes);
  }
  const auto picture = taken(options.develop, exposure, frame, picture_space, seen, 0, attributes);
  write_developed(options.develop, exposure, picture, picture_space, options.output,
                  {{"coppermoon:recipe", scene.moon.recipe},
                   {"coppermoon:version", std::string(COPPERMOON_VERSION)}});
  report({{options.output},
          scene.moon.recipe,
          seconds,
          scene.moon.light->error_found,
          scene.moon.light->plan},
         options.json);
}

}  // namespace

void add_still(CLI::App& program) {
  auto* verb = add_verb(program, "still", "Bake, scene, POV-Ray and develop: a picture");
  const auto options = std::make_shared<Options>();
  add_moon_options(*verb, options->moon);
  add_view_options(*verb, options->view);
  add_develop_options(*verb, options->develop);
  add_camera_options(*verb, options->develop.camera);
  add_flag(*verb, "-o,--output", options->output, "the picture, .png").writes_file().required();
  add_flag(*verb, "--frame", options->frame, "also the scene-linear frame [cd/m²], .exr")
      .writes_file();
  add_switch(*verb, "--json", options->json, "one JSON document on stdout");
  add_recipe_option(*verb);
  on_run(*verb, [verb, options] { run(*verb, *options); });
}

}  // namespace coppermoon::verbs
