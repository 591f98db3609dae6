// SPDX-License-Identifier: MIT
#include "verbs/recipes/recorded_scene.h"

#include "verbs/flags/plan_options.h"
#include "verbs/recipes/recipe.h"
#include "verbs/reports/progress_bar.h"

namespace coppermoon::verbs {
uses::LitScene lit_scene(const CLI::App& verb, const MoonOptions& moon,
                         const uses::ViewRequest& view, const uses::Baking& baking) {
  const auto recipe = recipe_of(verb);
  const auto request = moon_request(moon);
  const auto sky = eclipsed_sky(moon);
  auto scene = [&] {
    ProgressBar bar("light");
    return uses::lit_scene(request, view, sky, {baking, bar.progress()});
  }();
  const auto sized = with_width(recipe, *scene.moon.request.texture_width);
  scene.texture.attributes["coppermoon:recipe"] =
      made_recipe(sized, request.unshadowed, scene.moon.light->plan);
  return scene;
}

Report report_of(const std::string& file, const uses::LitScene& scene, double seconds) {
  const auto& light = *scene.moon.light;
  return {{file},
          std::get<std::string>(scene.texture.attributes.at("coppermoon:recipe")),
          seconds,
          light.error_found,
          light.plan};
}

}  // namespace coppermoon::verbs
