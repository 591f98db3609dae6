// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "algebra/progress.h"
#include "photons/trace.h"
#include "shadow/irradiance.h"
#include "shadow/photon_sums.h"

namespace coppermoon::shadow {

/// Number of photons, their seed, and settings of tracing and gathering.
struct PhotonSettings {
  std::uint64_t photons = 1'000'000;  ///< 1 to 1e12; rounded up to whole blocks of 1024
  std::uint64_t seed = 1;
  /// traced as Yapo & Cutler (2009) do (photons::trace), in three dimensions and with one wavelength each; off: all
  /// wavelengths of a photon at once, by a table of the limb's rays (photons::WholeLimb)
  bool literal = false;
  photons::Stepping stepping;  ///< of literal photons
  int rays = 500;              ///< of the table
  double ring_width_m = 50e3;  ///< of the rings that gather photons, 1e3 to 2e6 m
  /// sectors of position angle, 1 to 1000; with 1, photons are gathered regardless of position angle
  std::size_t sectors = 1;
  std::optional<StoppingRule> enough;  ///< ends the run before all photons are traced, when met
  std::optional<BlockRange> blocks;    ///< blocks to trace; none: all
  std::string key;                     ///< PhotonSums::key
};

/// Refracted light by photons, for any atmosphere, as sums to which more photons can be added.
///
/// A literal photon has one wavelength, drawn at random; it leaves a random point of the
/// solar disc towards a random point of the ring of air, and is gathered on every plane in the ring of axis
/// distances (and the sector) where it lands. By the table a photon carries all wavelengths, and a block of
/// photons is stratified in tangent height and in direction and distance of landing (LimbLandings). With one
/// sector each photon stands for all position angles, which requires symmetric air. Blocks are added until all are traced or, in
/// batches that double, until the stopping rule is met.
///
/// Given     before   earlier sums, whose blocks are not traced again
/// Returned  `before` and the new blocks; by the table, identical bit by bit for any number of
///           threads, on processors with the same vector width; memory does not grow with the number of
///           photons
/// Throws    Error  when an argument is outside its range, one sector is asked for in air that differs
///                  by region, or the key of `before` differs
/// Source    Yapo & Cutler (2009) §3.1 and 3.2
PhotonSums traced(const atmosphere::Atmosphere& atmosphere, const Arrangement& arrangement,
                  std::span<const double> wavelengths_nm, const PhotonSettings& settings,
                  const PhotonSums* before = nullptr, const algebra::Progress& progress = {});

/// Refracted light estimated by photons: estimated(traced(…)).
RefractedLight by_photons(const atmosphere::Atmosphere& atmosphere, const Arrangement& arrangement,
                          std::span<const double> wavelengths_nm, const PhotonSettings& settings,
                          const algebra::Progress& progress = {});

/// Light convolved along the axis distance with a Gaussian of standard deviation σ, rings weighted by their
/// area. Standard errors are propagated with rings taken as independent.
///
/// Source  Yapo & Cutler (2009) §3.2, where it removes noise
RefractedLight smoothed(const RefractedLight& light, double sigma_m);

}  // namespace coppermoon::shadow
