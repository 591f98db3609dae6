// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "almanac/instant.h"
#include "colour/cie_observer.h"
#include "eclipse/contacts.h"
#include "photons/solar_disc.h"
#include "texture/bake.h"
#include "verbs/disc_brightness.h"
#include "verbs/moon_options.h"
#include "verbs/photometric_bands.h"
#include "verbs/recipe.h"
#include "verbs/spectral_bands.h"
#include "verbs/verbs.h"

namespace coppermoon::verbs {
namespace {

struct Options {
  MoonOptions moon;
  bool json = false;
};

/// The photometric bands, and after them the luminance.
algebra::Grid<double> responses() {
  const auto edges = band_edges_nm();
  const auto bands = photometric_response(edges), xyz = colour::xyz_weights(edges);
  algebra::Grid<double> all(bands.rows() + 1, bands.columns());
  for (std::size_t b = 0; b < all.columns(); ++b) {
    for (std::size_t k = 0; k < bands.rows(); ++k) all(k, b) = bands(k, b);
    all(bands.rows(), b) = xyz(1, b);
  }
  return all;
}

/// The Sun's irradiance at 1 au in each.
std::vector<double> sunlight_in(const algebra::Grid<double>& response) {
  const auto sunlight = photons::solar_irradiance(band_edges_nm());
  std::vector<double> sums(response.rows());
  for (std::size_t k = 0; k < response.rows(); ++k)
    for (std::size_t b = 0; b < sunlight.size(); ++b) sums[k] += response(k, b) * sunlight[b];
  return sums;
}

bool in_totality(const almanac::Instant& when) {
  const auto eclipse = eclipse::eclipse_at(when, eclipse::ShadowConvention::danjon);
  if (!eclipse || !eclipse->contacts.U2 || !eclipse->contacts.U3) return false;
  return almanac::seconds_between(*eclipse->contacts.U2, when) >= 0 &&
         almanac::seconds_between(when, *eclipse->contacts.U3) >= 0;
}

nlohmann::ordered_json described(const Options& options) {
  constexpr std::size_t rows = 360;
  const auto sky = almanac::sky_at(almanac::instant_from_utc(options.moon.instant));
  const auto response = responses();
  const auto light = light_on_the_moon(options.moon.light, sky, options.moon.unshadowed)
                         .in_channels(moonlight_weights(response));
  const auto moon =
      irradiance_of_disc(texture::bake(normal_albedo(options.moon), sky, light,
                                       {"B", "V", "R", "Y"}, rows, photometry_of(options.moon)),
                         sky);
  const auto sun = sunlight_in(response);
  nlohmann::ordered_json magnitudes;
  const auto bands = photometric_bands();
  for (std::size_t k = 0; k < bands.size(); ++k)
    magnitudes[bands[k].name] = bands[k].solar_magnitude - 2.5 * std::log10(moon[k] / sun[k]);
  nlohmann::ordered_json all{{"instant", almanac::utc_text(sky.when)},
                             {"magnitudes", magnitudes},
                             {"mean_luminance_cd_m2", moon.back() / solid_angle_of_disc(rows, sky)},
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
  auto* verb = program.add_subcommand(
      "brightness", "Magnitudes and mean luminance of the whole disc, above the air");
  const auto options = std::make_shared<Options>();
  add_moon_options(*verb, options->moon);
  verb->add_flag("--json", options->json, "one JSON document on stdout");
  add_recipe_option(*verb);
  verb->callback([options] { run(*options); });
}

}  // namespace coppermoon::verbs
