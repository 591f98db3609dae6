// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>

#include "uses/light/light_parameters.h"
#include "uses/light/moonlight.h"
#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// Values of the flags for light, from which light_request makes a request.
struct LightOptions {
  uses::LightRequest request;
  uses::Effort effort;
  /// Returns the settings in the recipe on which photons depend. Call it only after the command line has been read.
  std::function<std::string()> key;
};

/// Adds all flags for light except --shard, --keep and --add, which share photons among runs.
void add_light_options(Verb& verb, LightOptions& options);

/// Adds --shard, --keep and --add, with which several runs share the work of tracing photons.
void add_photon_file_options(Verb& verb, LightOptions& options);

/// Makes a request for light from the flags. The quality "paper" sets several fields of the request.
///
/// Throws  Error  if the flags contradict one another
uses::LightRequest light_request(const LightOptions& options);

/// Warns on stderr if scaling the air cannot make the eclipse as dark or as bright as --danjon requests.
void say_unless_danjon_is_reached(const uses::Air& air, const almanac::SkyState& sky);

}  // namespace coppermoon::verbs
