// SPDX-License-Identifier: MIT
#include "verbs/flags/light_options.h"

#include <fmt/format.h>

#include <cstdio>

#include "algebra/error.h"
#include "uses/light/planning.h"

namespace coppermoon::verbs {

void add_light_options(Verb& verb, LightOptions& options) {
  auto& request = options.request;
  add_described(verb, request.air);
  add_described(verb, request, uses::describe_sunlight);
  add_described(verb, options.effort);
  add_described(verb, request.by_hand, uses::describe_knobs);
  add_described(verb, request, uses::describe_solver);
  for (auto& parameter : verb.parameters)
    if (parameter.name == "quality")  // even without a shadow, a draft has a coarser texture
      parameter.not_beside({{"unshadowed"}}, {"standard", "reference", "paper"});
    else if (parameter.heading == uses::air_heading || parameter.heading == uses::light_heading)
      parameter.not_beside({{"unshadowed"}});
  options.key = [&verb] { return uses::photons_recipe(verb.parameters); };
}

void add_photon_file_options(Verb& verb, LightOptions& options) {
  auto& files = options.request.photon_files;
  add_parsed(
      verb, "--shard", [&files](const std::string& text) { files.shard = uses::shard_from(text); },
      "share of the photons, K/N: traces the K-th of N parts")
      .in(uses::light_heading)
      .of(request::Affects::share);
  add_flag(verb, "--keep", files.keep,
           "file for the photons' sums, JSON, to which other runs can add")
      .in(uses::light_heading)
      .writes_file();
  add_flag(verb, "--add", files.add,
           "file that --keep wrote for the same scene: its photons count and are not traced "
           "again. May be given again")
      .in(uses::light_heading)
      .of(request::Affects::share)
      .reads_file();
}

uses::LightRequest light_request(const LightOptions& options) {
  auto request = options.request;
  uses::require_knobs(request.by_hand);
  request.wish = wish_of(options.effort);
  if (options.key) request.photon_files.key = options.key();
  if (options.effort.quality == "paper") {
    request.solver = uses::Solver::literal;
    request.photons = request.photons.value_or(1e7);
    request.by_hand.bands = request.by_hand.bands.value_or(200);
    if (!request.by_hand.terms) request.by_hand.terms = uses::everything_but("scattered-light");
  }
  if (!plan::traces_photons(request.solver) && request.photon_files.asked_for())
    throw algebra::Error(
        fmt::format("solver = {}, allowed photons or literal with --shard, --keep or --add",
                    request.solver == uses::Solver::quadrature ? "quadrature" : "auto"));
  return request;
}

void say_unless_danjon_is_reached(const uses::Air& air, const almanac::SkyState& sky) {
  if (reaches_danjon(air, sky)) return;
  fmt::print(stderr,
             "coppermoon: no air makes this eclipse {} on Danjon's scale; the nearest is taken\n",
             *air.column.danjon);
}

}  // namespace coppermoon::verbs
