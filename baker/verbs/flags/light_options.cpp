// SPDX-License-Identifier: MIT
#include "verbs/flags/light_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "algebra/error.h"
#include "verbs/flags/air_options.h"
#include "verbs/recipes/recipe.h"

namespace coppermoon::verbs {
namespace {

using photons::Precision;
using shadow::Trace;
using uses::ScatteredLight;
using uses::Solver;

void add_solver_options(CLI::App& verb, uses::LightRequest& request) {
  const std::string group = light_group;
  add_choice<Solver>(verb, "--solver", request.solver,
                     {{"auto", Solver::automatic},
                      {"quadrature", Solver::quadrature},
                      {"photons", Solver::photons}},
                     "method: quadrature (without noise), photons (the paper's simulation), or "
                     "auto (the quicker; photons where --photons is given)")
      .in(group);
  add_choice<Trace>(
      verb, "--trace", request.trace,
      {{"each", Trace::step_by_step}, {"marched", Trace::marched}, {"table", Trace::table}},
      "tracing of photons: table (by a table of the limb's rays), marched (step by step, all "
      "wavelengths together) or each (step by step, each alone, as in the paper)")
      .in(group);
  add_flag(verb, "--photons", request.photons,
           "number of photons, 1 to 1e12; default: as many as the tolerance needs. 1e6 take a "
           "second by the table, some seconds marched, minutes with --trace each")
      .in(group);
  add_flag(verb, "--seed", request.seed, "seed of the photons").not_negative().in(group);
  add_flag(verb, "--step-km", request.step_km,
           "step of a photon's path [km], with --trace each or marched")
      .in(group);
  add_choice<Precision>(verb, "--precision", request.precision,
                        {{"single", Precision::single}, {"full", Precision::full}},
                        "precision of photons that are marched: single (7 digits, in two thirds of "
                        "the time) or full (16 digits)")
      .in(group);
  add_flag(verb, "--ring-km", request.ring_km, "width of the rings that gather photons [km]")
      .in(group);
  add_flag(verb, "--smoothing-km", request.smoothing_km,
           "standard deviation of the Gaussian that smooths photons [km]; 0: no smoothing")
      .in(group);
}

/// Whether photons are others when this flag is.
bool changes_photons(const CLI::App& verb, const std::string& flag) {
  constexpr std::array<std::string_view, 6> ways{"seed",    "trace",   "rays",
                                                 "step-km", "ring-km", "precision"};
  constexpr std::array<std::string_view, 2> added_later{"scattered-light", "starlight"};
  if (std::find(added_later.begin(), added_later.end(), flag) != added_later.end()) return false;
  if (std::find(ways.begin(), ways.end(), flag) != ways.end()) return true;
  return heading_of(verb, "--" + flag) == air_group;
}

/// Those of the recipe's flags that change photons, and all of its tables of air.
std::string key_of(const CLI::App& verb) {
  return without(recipe_of(verb),
                 [&](const std::string& flag) { return !changes_photons(verb, flag); });
}

}  // namespace

void add_sunlight_options(CLI::App& verb, uses::LightRequest& request) {
  add_on_off(verb, "--limb-darkening", request.limb_darkening,
             "limb darkening of the Sun; off with --atmosphere paper")
      .in(air_group);
  add_choice<ScatteredLight>(
      verb, "--scattered-light", request.scattered_light,
      {{"auto", ScatteredLight::automatic},
       {"on", ScatteredLight::on},
       {"off", ScatteredLight::off}},
      "sunlight that the air scatters into the shadow; auto: where it counts")
      .in(air_group);
  add_on_off(verb, "--starlight", request.starlight, "light of the stars on the Moon")
      .in(air_group);
}

void add_light_options(CLI::App& verb, LightOptions& options) {
  add_air_options(verb, options.request.air);
  add_sunlight_options(verb, options.request);
  add_plan_options(verb, options.plan);
  add_solver_options(verb, options.request);
  options.key = [&verb] { return key_of(verb); };
}

void add_photon_file_options(CLI::App& verb, LightOptions& options) {
  const std::string group = light_group;
  auto& files = options.request.photon_files;
  add_parsed(
      verb, "--shard", [&files](const std::string& text) { files.shard = uses::shard_from(text); },
      "share of the photons, K/N: traces the K-th of N parts")
      .in(group);
  add_parsed(
      verb, "--keep", [&files](const std::string& text) { files.keep = text; },
      "file for the photons' sums, JSON, to which other runs can add")
      .writes_file()
      .in(group);
  add_files(verb, "--add", files.add,
            "file that --keep wrote for the same scene: its photons count and are not traced "
            "again. May be given again")
      .reads_file()
      .kept_each_time()
      .in(group);
}

uses::LightRequest light_request(const LightOptions& options) {
  auto request = options.request;
  request.wish = wish_of(options.plan);
  request.by_hand = by_hand(options.plan);
  if (options.key) request.photon_files.key = options.key();
  if (options.plan.quality == "paper") {
    request.solver = Solver::photons;
    request.trace = Trace::step_by_step;
    request.photons = request.photons.value_or(1e7);
    request.by_hand.bands = request.by_hand.bands.value_or(200);
    if (!request.by_hand.terms) request.by_hand.terms = everything_but("scattered-light");
  }
  if (request.solver != Solver::photons && request.photon_files.asked_for())
    throw algebra::Error(fmt::format("solver = {}, allowed photons with --shard, --keep or --add",
                                     request.solver == Solver::quadrature ? "quadrature" : "auto"));
  return request;
}

}  // namespace coppermoon::verbs
