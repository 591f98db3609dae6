// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "almanac/instant.h"
#include "eclipse/contacts.h"
#include "texture/bake.h"
#include "verbs/disc_brightness.h"
#include "verbs/moon_options.h"
#include "verbs/photometer.h"
#include "verbs/recipe.h"
#include "verbs/verbs.h"

namespace coppermoon::verbs {
namespace {

struct Options {
  MoonOptions moon;
  bool json = false;
};

bool in_totality(const almanac::Instant& when) {
  const auto eclipse = eclipse::eclipse_at(when, eclipse::ShadowConvention::danjon);
  if (!eclipse || !eclipse->contacts.U2 || !eclipse->contacts.U3) return false;
  return almanac::seconds_between(*eclipse->contacts.U2, when) >= 0 &&
         almanac::seconds_between(when, *eclipse->contacts.U3) >= 0;
}

nlohmann::ordered_json described(const Options& options) {
  constexpr std::size_t rows = 360;
  const auto sky = almanac::sky_at(almanac::instant_from_utc(options.moon.instant));
  const auto meter = photometer();
  const auto light = light_on_the_moon(options.moon.light, sky, options.moon.unshadowed)
                         .in_channels(meter.weights);
  const auto disc = measured(meter,
                             texture::bake(normal_albedo(options.moon), sky, light, meter.channels,
                                           rows, photometry_of(options.moon)),
                             sky);
  nlohmann::ordered_json magnitudes;
  for (std::size_t k = 0; k < disc.magnitudes.size(); ++k)
    magnitudes[meter.channels[k]] = disc.magnitudes[k];
  nlohmann::ordered_json all{{"instant", almanac::utc_text(sky.when)},
                             {"magnitudes", magnitudes},
                             {"mean_luminance_cd_m2", disc.mean_luminance_cd_m2},
                             {"danjon", nullptr}};
  if (!options.moon.unshadowed && in_totality(sky.when))
    all["danjon"] = danjon_estimate(magnitudes["V"]);
  return all;
}

void run(const Options& options) {
  const auto all = described(options);
  if (options.json) {
    fmt::print("{}\n", all.dump(2));
    return;
  }
  for (const auto& [band, magnitude] : all["magnitudes"].items())
    fmt::print("{}               {:8.2f} mag\n", band, magnitude.get<double>());
  fmt::print("mean luminance  {:8.3g} cd/m²\n", all["mean_luminance_cd_m2"].get<double>());
  if (all["danjon"].is_null())
    fmt::print("Danjon                 - (not in totality)\n");
  else
    fmt::print("Danjon          {:8.1f}\n", all["danjon"].get<double>());
}

}  // namespace

void add_brightness(CLI::App& program) {
  auto* verb = add_verb(program, "brightness",
                        "Magnitudes and mean luminance of the whole disc, above the air");
  const auto options = std::make_shared<Options>();
  add_moon_options(*verb, options->moon);
  add_switch(*verb, "--json", options->json, "one JSON document on stdout");
  add_recipe_option(*verb);
  on_run(*verb, [options] { run(*options); });
}

}  // namespace coppermoon::verbs
