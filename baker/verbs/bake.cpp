// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <memory>

#include "algebra/error.h"
#include "almanac/instant.h"
#include "texture/write_image.h"
#include "verbs/moon_options.h"
#include "verbs/recipe.h"
#include "verbs/report.h"
#include "verbs/verbs.h"

namespace coppermoon::verbs {
namespace {

struct Options {
  MoonOptions moon;
  std::string output, space = "lin_rec709", type = "half";
  bool json = false;
};

void run(const CLI::App& verb, const Options& options) {
  if (std::filesystem::path(options.output).extension() != ".exr")
    throw algebra::Error(fmt::format("{}: a texture ends in .exr", options.output));
  require_place_for(options.output);
  const auto space = colour::working_space(options.space);
  const auto sky = almanac::sky_at(almanac::instant_from_utc(options.moon.instant));
  const auto recipe = recipe_of(verb);
  const auto moon = baked_moon(options.moon, sky, space, {}, recipe);
  texture::write_exr(
      options.output, moon.layout, moon.rows, moon.attributes,
      {options.type == "half" ? texture::ExrType::half : texture::ExrType::floating});
  report({options.output, moon.recipe, moon.seconds(), moon.relative_error, moon.plan},
         options.json);
}

}  // namespace

void add_bake(CLI::App& program) {
  auto* verb =
      program.add_subcommand("bake", "The lunar texture: plate carrée, scene-linear, cd/m²");
  const auto options = std::make_shared<Options>();
  add_moon_options(*verb, options->moon);
  verb->add_option("-o,--output", options->output, "the texture, .exr")->required();
  verb->add_option("--space", options->space, "lin_rec709, acescg or lin_ciexyzd65_scene");
  verb->add_option("--type", options->type, "of a texel's numbers: half or float")
      ->check(CLI::IsMember({"half", "float"}));
  verb->add_flag("--json", options->json, "one JSON document on stdout");
  add_recipe_option(*verb);
  verb->callback([verb, options] { run(*verb, *options); });
}

}  // namespace coppermoon::verbs
