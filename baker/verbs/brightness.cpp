// SPDX-License-Identifier: MIT
#include "uses/picture/brightness.h"

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "almanac/instant.h"
#include "uses/light/photometric_bands.h"
#include "verbs/command_line.h"
#include "verbs/flags/moon_options.h"
#include "verbs/recipes/recipe.h"
#include "verbs/reports/progress_bar.h"

namespace coppermoon::verbs {
namespace {

struct Options {
  MoonOptions moon;
  bool json = false;
};

nlohmann::ordered_json described(const Options& options) {
  const auto request = moon_request(options.moon);
  const auto sky = eclipsed_sky(options.moon);
  ProgressBar bar("light");
  const auto brightness = uses::brightness_of(request, sky, bar.progress());
  const auto bands = uses::photometric_bands();
  nlohmann::ordered_json magnitudes;
  for (std::size_t k = 0; k < bands.size(); ++k)
    magnitudes[bands[k].name] = brightness.disc.magnitudes[k];
  nlohmann::ordered_json all{{"instant", almanac::utc_text(sky.when)},
                             {"magnitudes", magnitudes},
                             {"mean_luminance_cd_m2", brightness.disc.mean_luminance_cd_m2},
                             {"danjon", nullptr}};
  if (brightness.danjon) all["danjon"] = *brightness.danjon;
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
                        "computes magnitudes and mean luminance of the whole Moon, above the air");
  const auto options = std::make_shared<Options>();
  add_moon_options(*verb, options->moon);
  add_switch(*verb, "--json", options->json, "prints one JSON document");
  add_recipe_option(*verb);
  on_run(*verb, [options] { run(*options); });
}

}  // namespace coppermoon::verbs
