// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "shadow/by_photons.h"
#include "shadow/by_quadrature.h"

namespace coppermoon::shadow {

/// The quadrature's mean over each ring of a width, by area: what photons gathered in rings
/// estimate.
inline algebra::Grid<double> ring_means(const atmosphere::Atmosphere& air,
                                        const Arrangement& arrangement,
                                        std::span<const double> waves, double width_m,
                                        std::size_t rings) {
  constexpr int places = 8;
  std::vector<double> distances;
  for (std::size_t r = 0; r < rings; ++r)
    for (int k = 0; k < places; ++k)
      distances.push_back((static_cast<double>(r) + (k + 0.5) / places) * width_m);
  const auto light = by_quadrature(air, arrangement, waves, distances, {.rays = 1000});
  const auto ratio = mean_ratio(light);
  algebra::Grid<double> means(rings, waves.size());
  for (std::size_t r = 0; r < rings; ++r)
    for (std::size_t w = 0; w < waves.size(); ++w) {
      double sum = 0, area = 0;
      for (std::size_t d = r * places; d < (r + 1) * places; ++d) {
        sum += distances[d] * ratio(d, w);
        area += distances[d];
      }
      means(r, w) = sum / area;
    }
  return means;
}

/// The photons' own means over rings.
inline RefractedLight in_rings(const atmosphere::Atmosphere& air, const Arrangement& arrangement,
                               std::span<const double> waves, const PhotonSettings& settings) {
  return means_over_rings(traced(air, arrangement, waves, settings));
}

}  // namespace coppermoon::shadow
