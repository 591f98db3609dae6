// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "almanac/instant.h"
#include "uses/picture/lit_scene.h"
#include "uses/picture/picture_parameters.h"
#include "uses/picture/still.h"
#include "uses/picture/texture_recipe.h"
#include "verbs/command_line.h"
#include "verbs/flags/moon_options.h"
#include "verbs/reports/in_words.h"
#include "verbs/reports/report.h"

namespace coppermoon::verbs {
namespace of_plan {
namespace {

struct Options {
  MoonOptions moon;
  uses::ViewRequest view;
  bool json = false;
};

/// Whether to plan a picture and not only a texture. A picture is planned if the user set any parameter of the view.
bool of_a_picture(const Verb& verb) {
  for (const auto* flag : {"at", "width", "height", "field", "focal-length", "sensor-width"})
    if (is_given(verb, flag)) return true;
  return false;
}

/// A plan for computing light, and the sizes of the texture and picture for which it was made.
struct Planned {
  plan::Plan plan;
  std::size_t texture_width = 0;
  std::optional<double> frame_bytes;  ///< memory that a picture's frame needs; absent for a texture
  std::vector<std::string> picture_left_out;
};

Planned planned(const Options& options, bool picture) {
  auto moon = moon_request(options.moon);
  const auto sky = eclipsed_sky(options.moon, options.view.observer);
  Planned result;
  if (picture) {
    const auto seen = uses::view_for_frame(options.view, sky);
    moon = fitted(moon, seen.view.camera);
    result.picture_left_out = seen.left_out;
    result.frame_bytes = uses::frame_memory(seen.view.camera.width, seen.view.camera.height);
  }
  result.texture_width = texture_width_of(moon);
  const auto texels = static_cast<double>(result.texture_width * result.texture_width / 2);
  if (moon.unshadowed)
    uses::unshadowed_light(moon.light, sky);
  else
    result.plan =
        uses::planned_light(moon.light, sky, {picture ? texels / 2 : texels, reads_map(moon)});
  return result;
}

/// A plan, and the recipe that carries it out.
struct Document {
  std::string recipe;
  Planned planned;
};

template <class Field>
void describe(Field&& is, const Document& document) {
  is.a("Document", "What a texture or a picture requires, and what it will cost.");
  is(
      "chosen", [&] { return as_json(document.recipe); }, "recipe of the work that is planned");
  describe(is, document.planned.plan);
  is("frame_bytes", algebra::if_any(document.planned.frame_bytes), algebra::unit::bytes,
     "memory for a picture's frame");
}

void print(const Planned& all) {
  const auto& [plan, width, frame_bytes, picture_left_out] = all;
  const auto& work = plan.work;
  if (!work.refracted)
    fmt::print("light       direct sunlight alone\n");
  else if (work.solver == plan::Solver::quadrature)
    fmt::print("light       quadrature: {} wavelengths, {} rays, {} of the Sun's terms\n",
               work.bands, work.rays, work.sun_terms);
  else
    fmt::print("light       {}: {:.2g} photons, {} wavelengths\n", name(work.solver), work.photons,
               work.bands);
  if (work.refracted)
    fmt::print("            {} plane{} across the Moon's depth, {} between places\n", work.planes,
               work.planes == 1 ? "" : "s", in_percent(work.place_error));
  fmt::print("Earth       {}, {}{}\n", work.ellipsoid ? "ellipsoid" : "sphere",
             work.regions ? "air by latitude and region" : "air alike all around",
             work.scattered_light ? ", scattered light" : "");
  fmt::print("texture     {} x {} texels\n", width, width / 2);
  if (frame_bytes) fmt::print("picture     {:.2g} GB of memory\n", *frame_bytes / 1e9);
  for (const auto& [term, size] : plan.left_out)
    fmt::print("left out    {}: {} of luminance at most\n", name(term), in_percent(size));
  for (const auto& text : picture_left_out) fmt::print("left out    {}\n", text);
  fmt::print("predicted   {}, {}\n", duration(plan.seconds), within(plan.error));
  for (std::size_t i = 1; i < plan.methods.size(); ++i)
    fmt::print("or          {} by {}, {}\n", duration(plan.methods[i].seconds),
               name(plan.methods[i].solver), within(plan.methods[i].error));
  if (plan.exceeds_budget)
    fmt::print("not reached budget: {} are predicted\n", duration(plan.seconds));
  if (plan.misses_tolerance)
    fmt::print("not reached tolerance: {} is predicted\n", in_percent(plan.error));
}

void run(const Verb& verb, const Options& options) {
  const auto all = planned(options, of_a_picture(verb));
  if (!options.json) return print(all);
  auto recipe = request::recipe_of(verb.parameters);
  if (!options.moon.request.texture_width) recipe = uses::with_width(recipe, all.texture_width);
  auto json = result::as_json(Document{text_of(uses::with_work(recipe, all.plan.work)), all});
  for (const auto& text : all.picture_left_out)
    json["left_out"].push_back({{"term", text}, {"size", nullptr}});
  fmt::print("{}\n", json.dump(2));
}

}  // namespace
}  // namespace of_plan

void add_plan(Program& program) {
  using namespace of_plan;
  auto& verb =
      add_verb(program, "plan",
               "says what a texture or a picture requires, and what it will cost, before any work");
  const auto options = std::make_shared<Options>();
  add_moon_options(verb, options->moon);
  add_described(verb, options->view);
  add_json_switch(verb, options->json, {result::fields_of<Document>});
  on_run(verb, [&verb, options] { run(verb, *options); });
}

}  // namespace coppermoon::verbs
