// SPDX-License-Identifier: MIT
#include "uses/picture/texture_recipe.h"

#include "uses/light/light_parameters.h"
#include "uses/picture/picture_parameters.h"

namespace coppermoon::uses {
namespace {

/// ISO 8601 text with enough decimals of a second to read back the same instant.
std::string exact_text(const almanac::Instant& when) {
  constexpr int most = 9;
  for (int decimals = 0;; ++decimals) {
    auto text = almanac::utc_text(when, decimals);
    if (decimals == most || almanac::seconds_between(almanac::instant_from_utc(text), when) == 0)
      return text;
  }
}

/// The observer, and the air that the Moon's sightline passes through.
ViewRequest view_in(const LitMoon& moon) {
  ViewRequest view{.observer = moon.observer};
  if (!moon.observer) return view;
  view.reddening = moon.sightline.has_value();
  if (!moon.sightline) return view;
  view.observer_ozone_du = moon.sightline->air.ozone_du;
  view.observer_aerosol = moon.sightline->air.aerosol_optical_depth;
  return view;
}

}  // namespace

std::string recipe_of_light(const LitMoon& moon, bool with_width,
                            const std::function<void(request::Parameters&)>& more) {
  auto instant = exact_text(moon.sky.when);
  auto request = moon.request;
  request::Parameters all;
  all.add(request::parameter("instant", instant, ""));
  describe_map(all, request);
  if (with_width) describe_width(all, request);
  describe_unshadowed(all, request);
  describe(all, request.light.air);
  describe_sunlight(all, request.light);
  describe_knobs(all, request.light.by_hand);
  describe_solver(all, request.light);
  more(all);
  const auto recipe = request::recipe_of(all);
  return text_of(recipe_made(recipe, moon));
}

request::Recipe recipe_made(const request::Recipe& asked, const LitMoon& moon) {
  return moon.request.unshadowed ? asked : with_work(asked, moon.light->plan.work);
}

request::Recipe with_width(const request::Recipe& recipe, std::size_t width) {
  return with({{.name = "texture-width", .texts = {request::text_of(width)}, .bare = true}},
              recipe);
}

std::string texture_recipe(const LitMoon& moon, const TextureContent& content) {
  auto view = view_in(moon);
  auto response = moon.request.response;
  auto held = content;
  held.space = space_of(content);
  return recipe_of_light(moon, true, [&](request::Parameters& all) {
    describe_observer(all, view);
    describe(all, held);
    describe_response(all, response);
  });
}

}  // namespace coppermoon::uses
