// SPDX-License-Identifier: MIT
#include <memory>

#include "algebra/error.h"
#include "verbs/lit_scene.h"
#include "verbs/recipe.h"
#include "verbs/report.h"
#include "verbs/verbs.h"

namespace coppermoon::verbs {
namespace {

struct Options {
  MoonOptions moon;
  ViewOptions view;
  std::string output;
  bool json = false;
};

void run(const CLI::App& verb, const Options& options) {
  const std::filesystem::path folder = options.output;
  if (std::filesystem::exists(folder) && !std::filesystem::is_directory(folder))
    throw algebra::Error(fmt::format("{}: is no directory", folder.string()));
  if (!std::filesystem::is_directory(folder)) require_place_for(folder);
  const auto recipe = recipe_of(verb);
  const auto scene = lit_scene(options.moon, options.view, recipe);
  write_lit_scene(folder, scene);
  report({{options.output},
          scene.moon.recipe,
          scene.moon.seconds(),
          scene.moon.light->error_found,
          scene.moon.light->plan},
         options.json);
}

}  // namespace

void add_scene(CLI::App& program) {
  auto* verb =
      add_verb(program, "scene", "A POV-Ray scene in a folder of its own, ready to render");
  const auto options = std::make_shared<Options>();
  add_moon_options(*verb, options->moon);
  add_view_options(*verb, options->view);
  add_flag(*verb, "-o,--output", options->output, "the folder; `povray eclipse.ini` in it renders")
      .writes_folder()
      .required();
  add_switch(*verb, "--json", options->json, "one JSON document on stdout");
  add_recipe_option(*verb);
  on_run(*verb, [verb, options] { run(*verb, *options); });
}

}  // namespace coppermoon::verbs
