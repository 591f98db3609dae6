// SPDX-License-Identifier: MIT
#include "verbs/recipes/recorded_scene.h"

#include "uses/picture/texture_recipe.h"
#include "verbs/reports/progress_bar.h"

namespace coppermoon::verbs {

uses::LitScene lit_scene(const Verb& verb, const MoonOptions& moon, const uses::ViewRequest& view,
                         uses::Baking baking) {
  baking.recipe = [asked = request::recipe_of(verb.parameters)](const auto& lit, const auto&) {
    return text_of(recipe_made(uses::with_width(asked, *lit.request.texture_width), lit));
  };
  const auto request = moon_request(moon);
  const auto sky = eclipsed_sky(moon, view.observer);
  ProgressBar bar("light");
  return uses::lit_scene(request, view, sky, {baking, bar.progress()});
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
