// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "shadow/by_photons.h"
#include "verbs/flags.h"

namespace coppermoon::verbs {

/// How photons are shared among runs: which part this one traces, and what goes from run to run.
struct PhotonOptions {
  std::string shard, keep;
  std::vector<std::string> add;
  std::function<std::string()> key;  ///< what photons belong to, once the command line is read
};

/// --shard K/N, --keep FILE, --add FILE. The key is those lines of the verb's recipe that change
/// photons: the air, the Sun's disc, seed, way of tracing, rays, steps, precision, rings.
void add_photon_options(CLI::App& verb, PhotonOptions& options);

/// Whether any of them was given: they mean nothing to another solver.
bool given(const PhotonOptions& options);

/// by_photons, with what the files hold added, in the part asked for; the sums are kept where a
/// file is named.
///
/// Throws  Error  when a shard is not "K/N", a file cannot be read or written, or its photons are
///                of another scene or the same blocks as another's
shadow::RefractedLight light_of_photons(const PhotonOptions& options,
                                        const atmosphere::Atmosphere& air,
                                        const shadow::Arrangement& arrangement,
                                        std::span<const double> wavelengths_nm,
                                        shadow::PhotonSettings settings,
                                        const algebra::Progress& progress);

}  // namespace coppermoon::verbs
