// SPDX-License-Identifier: MIT
#include "verbs/recipes/recorded_scene.h"

#include "request/recipe.h"
#include "uses/light/light_parameters.h"
#include "verbs/recipes/recipe.h"
#include "verbs/reports/progress_bar.h"

namespace coppermoon::verbs {
uses::LitScene lit_scene(const CLI::App& verb, const MoonOptions& moon,
                         const uses::ViewRequest& view, const uses::Baking& baking) {
  const auto recipe = recipe_of(verb);
  const auto request = moon_request(moon);
  const auto sky = eclipsed_sky(moon, view.observer);
  auto scene = [&] {
    ProgressBar bar("light");
    return uses::lit_scene(request, view, sky, {baking, bar.progress()});
  }();
  const auto sized = request::with_width(recipe, *scene.moon.request.texture_width);
  scene.texture.attributes["coppermoon:recipe"] =
      request.unshadowed ? sized : uses::with_work(sized, scene.moon.light->plan.work);
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
