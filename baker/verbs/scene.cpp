// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <memory>

#include "algebra/error.h"
#include "files/whole_file.h"
#include "uses/dome/dome.h"
#include "uses/picture/picture_parameters.h"
#include "uses/picture/sky_lights.h"
#include "verbs/command_line.h"
#include "verbs/recipes/recorded_scene.h"
#include "verbs/reports/progress_bar.h"

namespace coppermoon::verbs {
namespace of_scene {
namespace {

const request::Words<uses::Renderer> renderers{{"povray", uses::Renderer::povray},
                                               {"mitsuba", uses::Renderer::mitsuba}};

struct Options {
  MoonOptions moon;
  uses::ViewRequest view;
  std::string output;
  uses::Renderer renderer = uses::Renderer::povray;
  bool json = false;
};

void run(const Verb& verb, const Options& options) {
  const std::filesystem::path folder = options.output;
  if (std::filesystem::exists(folder) && !std::filesystem::is_directory(folder))
    throw algebra::Error(fmt::format("{}: is no directory", folder.string()));
  if (!std::filesystem::is_directory(folder)) files::require_place_for(folder);
  uses::require_scene_folder(folder, options.view, options.renderer);
  const auto start = std::chrono::steady_clock::now();
  ProgressBar bar("bake");
  const auto scene = lit_scene(verb, options.moon, options.view, {.progress = bar.progress()});
  write_lit_scene(folder, scene, uses::scene_lights(scene.view, scene.moon.sky), options.renderer);
  if (options.renderer == uses::Renderer::povray && scene.view.observer) {
    write_moon_include(folder, scene, options.view);
    uses::write_sky(folder / povray_scenes::sky_file, scene.moon, options.view);
  }
  report(report_of(options.output, scene, seconds_since(start)), options.json);
}

}  // namespace
}  // namespace of_scene

void add_scene(Program& program) {
  using namespace of_scene;
  auto& verb =
      add_verb(program, "scene", "writes a scene with its texture into a folder, ready to render");
  const auto options = std::make_shared<Options>();
  add_moon_options(verb, options->moon);
  add_described(verb, options->view);
  add_described(verb, options->moon.request.response, uses::describe_response);
  add_flag(verb, "-o,--output", options->output,
           "folder for texture and scene, which `povray eclipse.ini` in it renders, and for "
           "moon.inc and eclipse_stars.inc, Moon, sky and stars for scenes of your own")
      .writes_folder()
      .required();
  add_choice(verb, "--for", options->renderer, renderers,
             "renderer of the scene: povray, or mitsuba (Mitsuba 3: eclipse.xml, which "
             "`mitsuba -m scalar_rgb -o frame.exr eclipse.xml` renders)");
  verb.parameters.find("sky")->not_beside({{"for", {"mitsuba"}}});
  add_run_switch(verb, "--json", options->json, "prints one JSON document");
  on_run(verb, [&verb, options] { run(verb, *options); });
}

}  // namespace coppermoon::verbs
