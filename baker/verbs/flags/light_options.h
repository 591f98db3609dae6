// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>

#include "uses/light/light_parameters.h"
#include "uses/light/moonlight.h"
#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// Fields that the flags of light fill; `light_request` makes a request of them.
struct LightOptions {
  uses::LightRequest request;
  uses::Effort effort;
  /// Recipe that photons depend on, once the command line is read
  std::function<std::string()> key;
};

/// Adds all flags of light but those that share photons among runs.
void add_light_options(Verb& verb, LightOptions& options);

/// Adds --shard K/N, --keep FILE, --add FILE.
void add_photon_file_options(Verb& verb, LightOptions& options);

/// Request that the flags of light make; the quality "paper" sets several of them.
///
/// Throws  Error  when they contradict one another
uses::LightRequest light_request(const LightOptions& options);

/// Says on stderr when no air makes the eclipse as dark or as bright as --danjon asks.
void say_unless_danjon_is_reached(const uses::Air& air, const almanac::SkyState& sky);

}  // namespace coppermoon::verbs
