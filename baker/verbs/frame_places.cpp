// SPDX-License-Identifier: MIT
#include "verbs/frame_places.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "algebra/error.h"
#include "verbs/lit_scene.h"
#include "verbs/recipe_file.h"

namespace coppermoon::verbs {
namespace {

/// What of a still's flags says when it is seen and from where.
struct Flags {
  MoonOptions moon;
  ViewOptions view;
};

Flags flags_told_by(const std::filesystem::path& file) {
  Flags flags;
  CLI::App still;
  still.option_defaults()->always_capture_default();
  add_moon_options(still, flags.moon);
  add_view_options(still, flags.view);
  auto words = flags_of_recipe(still, file.string(), {});
  std::ranges::reverse(words);  // as CLI11 takes them
  try {
    still.parse(std::move(words));
  } catch (const CLI::ParseError& error) {
    throw algebra::Error(
        fmt::format("{}: its recipe is not that of one frame: {}", file.string(), error.what()));
  }
  return flags;
}

}  // namespace

FramePlaces frame_places(const std::filesystem::path& told_by) {
  if (!holds_recipe(told_by))
    throw algebra::Error(
        fmt::format("{}: allowed is an .exr made by coppermoon", told_by.string()));
  const auto flags = flags_told_by(told_by);
  const auto sky = almanac::sky_at(almanac::instant_from_utc(flags.moon.instant));
  const auto camera = view_for_frame(flags.view, sky).view.camera;
  return {sky, eclipse::shadow_axis(sky), camera, povray_scenes::sight_of(camera)};
}

std::optional<double> axis_distance_km(const FramePlaces& places, const glm::dvec2& pixel) {
  constexpr double least_emission_cosine = 0.25;  // of emission: 0.97 of the disc's radius
  const auto ground = povray_scenes::ground_at(places.sight, pixel);
  if (!ground ||
      glm::dot(*ground, glm::normalize(places.sight.position - *ground)) < least_emission_cosine)
    return std::nullopt;
  const auto at_m = places.sky.moon_m + glm::transpose(places.sky.selenographic_from_gcrs) *
                                            (algebra::in_metres(almanac::lunar_radius) * *ground);
  return algebra::in_kilometres(eclipse::place_in_shadow(places.axis, at_m).axis_distance);
}

}  // namespace coppermoon::verbs
