// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>

#include "uses/light/light_parameters.h"
#include "uses/light/moonlight.h"
#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// Fields that the flags for light fill in; `light_request` turns them into a request.
struct LightOptions {
  uses::LightRequest request;
  uses::Effort effort;
  /// Returns the part of the recipe that photons depend on, once the command line is read
  std::function<std::string()> key;
};

/// Adds all flags for light except those that share photons among runs.
void add_light_options(Verb& verb, LightOptions& options);

/// Adds --shard K/N, --keep FILE, --add FILE.
void add_photon_file_options(Verb& verb, LightOptions& options);

/// Request that the flags for light describe. The quality "paper" sets several of its fields.
///
/// Throws  Error  if the flags contradict one another
uses::LightRequest light_request(const LightOptions& options);

/// Says so on stderr if no air makes the eclipse as dark or as bright as --danjon asks.
void say_unless_danjon_is_reached(const uses::Air& air, const almanac::SkyState& sky);

}  // namespace coppermoon::verbs
