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

/// Number of photons, their seed, and settings for tracing and gathering them.
struct PhotonSettings {
  std::uint64_t photons = 1'000'000;  ///< 1 to 1e12; rounded up to whole blocks of 1024
  std::uint64_t seed = 1;
  /// if true, photons are traced as in Yapo & Cutler (2009) (photons::trace), in three dimensions and each with one
  /// wavelength. If false, each photon carries all wavelengths through a table of the limb's rays (photons::WholeLimb)
  bool literal = false;
  photons::Stepping stepping;  ///< step lengths, used only if `literal` is true
  int rays = 500;              ///< number of rays in the limb's table
  double ring_width_m = 50e3;  ///< width of the rings that gather photons, 1e3 to 2e6 m
  /// number of sectors of position angle, 1 to 1000; with 1, photons are gathered regardless of position angle
  std::size_t sectors = 1;
  std::optional<StoppingRule> enough;  ///< rule that ends the run early, once it is met
  std::optional<BlockRange> blocks;    ///< blocks of photons to trace; if absent, all
  std::string key;                     ///< identifies the simulation, see PhotonSums::key
};

/// Traces photons to find the refracted light in any atmosphere. More photons can be added to the resulting sums.
///
/// A literal photon (traced step by step) has one random wavelength. It leaves a random point of the solar disc towards
/// a random point of the ring of air around the Earth. On every plane, it is gathered in the ring of axis distances
/// (and the sector) where it lands. A photon traced with the table carries all wavelengths, and a block of these
/// photons is stratified in tangent height and in the direction and distance of landing (LimbLandings). With one
/// sector, each photon stands for all position angles, which requires symmetric air. Blocks are traced until none is
/// left or, if there is a stopping rule, in batches that double in size until the rule is met.
///
/// Given     before   earlier sums, whose blocks are not traced again
/// Returned  the sums of `before` and of the new blocks. With the table, they are bit-identical for any number of
///           threads on processors with the same vector width. Memory does not grow with the number of photons
/// Throws    Error  if an argument is outside its range, one sector is requested for air that differs by region, or the
///                  key of `before` differs
/// Source    Yapo & Cutler (2009) §3.1 and 3.2
PhotonSums traced(const atmosphere::Atmosphere& atmosphere, const Arrangement& arrangement,
                  std::span<const double> wavelengths_nm, const PhotonSettings& settings,
                  const PhotonSums* before = nullptr, const algebra::Progress& progress = {});

/// Refracted light estimated from photons: estimated(traced(…)).
RefractedLight by_photons(const atmosphere::Atmosphere& atmosphere, const Arrangement& arrangement,
                          std::span<const double> wavelengths_nm, const PhotonSettings& settings,
                          const algebra::Progress& progress = {});

/// Smooths light by convolution along the axis distance with a Gaussian of standard deviation sigma_m. Rings are
/// weighted by their area, and standard errors are propagated as if rings were independent.
///
/// Source  Yapo & Cutler (2009) §3.2, who remove noise in this way
RefractedLight smoothed(const RefractedLight& light, double sigma_m);

}  // namespace coppermoon::shadow
