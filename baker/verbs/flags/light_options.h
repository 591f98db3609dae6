// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>

#include "uses/light/light_parameters.h"
#include "uses/light/moonlight.h"
#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// Fields of the flags of light; `light_request` is what they mean.
struct LightOptions {
  uses::LightRequest request;
  uses::Effort effort;
  std::function<std::string()> key;  ///< what photons belong to, once the command line is read
};

/// All flags of light but those that share photons among runs.
void add_light_options(CLI::App& verb, LightOptions& options);

/// --shard K/N, --keep FILE, --add FILE.
void add_photon_file_options(CLI::App& verb, LightOptions& options);

/// Wish, knobs and photons put together; the quality "paper" stands for other flags.
///
/// Throws  Error  when they contradict one another
uses::LightRequest light_request(const LightOptions& options);

/// Tells who waits when no air makes the eclipse as dark or as bright as --danjon asks.
void say_unless_danjon_is_reached(const uses::Air& air, const almanac::SkyState& sky);

}  // namespace coppermoon::verbs
