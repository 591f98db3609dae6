// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>

#include "uses/light/moonlight.h"
#include "verbs/flags/flags.h"
#include "verbs/flags/plan_options.h"

namespace coppermoon::verbs {

/// The title in --help of all flags that say how light is computed.
inline constexpr const char* light_group = "How light is computed";

/// What flags say of the light; `light_request` is what they mean.
struct LightOptions {
  uses::LightRequest request;
  PlanOptions plan;
  std::function<std::string()> key;  ///< what photons belong to, once the command line is read
};

/// All flags of light but those that share photons among runs.
void add_light_options(CLI::App& verb, LightOptions& options);

/// --shard K/N, --keep FILE, --add FILE.
void add_photon_file_options(CLI::App& verb, LightOptions& options);

/// Flags of the Sun and the stars: limb darkening, scattered light, starlight.
void add_sunlight_options(CLI::App& verb, uses::LightRequest& request);

/// Wish, knobs and photons put together; the quality "paper" stands for other flags.
///
/// Throws  Error  when they contradict one another
uses::LightRequest light_request(const LightOptions& options);

}  // namespace coppermoon::verbs
