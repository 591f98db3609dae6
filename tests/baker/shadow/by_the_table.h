// SPDX-License-Identifier: MIT
#pragma once

#include "baker/shadow/ring_means.h"
#include "shadow/by_photons.h"
#include "shadow/limb_landings.h"
#include "support/testing.h"

namespace coppermoon::shadow {

inline const Arrangement february_2008{1.479e11, {3.83e8}};
inline const std::vector<double> waves{500, 580, 680};

/// By the table in rings of 50 km over the umbra, against the quadrature.
class ByTheTable : public testing::Test {
 protected:
  static constexpr std::size_t rings = 90;
  const algebra::Grid<double> exact = ring_means({}, february_2008, waves, 50e3, rings);

  PhotonSettings settings(std::uint64_t photons, std::uint64_t seed) const {
    PhotonSettings settings;
    settings.photons = photons;
    settings.seed = seed;
    return settings;
  }
};

}  // namespace coppermoon::shadow
