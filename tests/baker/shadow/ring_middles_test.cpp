// SPDX-License-Identifier: MIT
// Light of photons read between the middles of their rings, against the quadrature.
#include "algebra/interpolation.h"
#include "shadow/by_photons.h"
#include "shadow/by_quadrature.h"
#include "shadow/lookup.h"
#include "shadow/photon_sums.h"
#include "support/testing.h"

namespace coppermoon::shadow::ring_middles_test {

const Arrangement february_2008{1.479e11, {3.83e8}};

/// How far photons are from the quadrature between 0 and 4500 km, where light is refracted alone, at
/// 420 nm, of which the paper's air lets least through.
struct Distance {
  double rms = 0;     ///< relative
  double within = 0;  ///< part of places that are within three standard errors
};

Distance from_quadrature(std::uint64_t photons, double ring_m) {
  const std::vector<double> violet{420};
  std::vector<double> places;
  for (double at_m = 0; at_m < 4.5e6; at_m += 31e3) places.push_back(at_m);
  const auto exact = by_quadrature({}, february_2008, violet, places, {.rays = 4000});
  PhotonSettings settings;
  settings.photons = photons;
  settings.ring_width_m = ring_m;
  const auto light = estimated(traced({}, february_2008, violet, settings));
  const BetweenPlaces between(light);
  std::vector<double> errors(light.standard_error[0].values().begin(),
                             light.standard_error[0].values().end());
  Distance distance;
  for (std::size_t i = 0; i < places.size(); ++i) {
    double value = NAN;
    between.read(0, 0, places[i], {&value, 1});
    const double off = value - exact.ratio[0](i, 0);
    const double share = 1 / static_cast<double>(places.size());
    distance.rms += share * std::pow(off / exact.ratio[0](i, 0), 2);
    if (std::abs(off) <= 3 * algebra::interpolated(light.axis_distances_m, errors, places[i]))
      distance.within += share;
  }
  distance.rms = std::sqrt(distance.rms);
  return distance;
}

TEST(RingMiddles, AreTheQuadraturesWithinThreeStandardErrors) {
  const auto few = from_quadrature(100'000, 50e3), many = from_quadrature(10'000'000, 50e3),
             wide = from_quadrature(10'000'000, 200e3);
  EXPECT_GT(few.within, 0.98);
  EXPECT_GT(many.within, 0.98) << "more where light has kinks that rings do not resolve";
  EXPECT_GT(wide.within, 0.98);
  EXPECT_LT(many.rms, 3e-3) << "half of it noise";
}

}  // namespace coppermoon::shadow::ring_middles_test
