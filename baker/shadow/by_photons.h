// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "algebra/progress.h"
#include "photons/march.h"
#include "photons/trace.h"
#include "shadow/irradiance.h"
#include "shadow/photon_sums.h"

namespace coppermoon::shadow {

/// How a photon finds its way through the air. `step_by_step` follows it in three dimensions, to the
/// letter of the paper (photons::trace); each photon has one random wavelength. The others follow it in
/// its own plane, with all wavelengths at once: `marched` through the air itself (photons::Marcher),
/// `table` by a table of the limb's rays (photons::WholeLimb).
enum class Trace { step_by_step, marched, table };

/// How many photons, which, and how they are traced and gathered.
struct PhotonSettings {
  std::uint64_t photons = 1'000'000;  ///< 1 to 1e12; rounded up to whole blocks of 1024
  std::uint64_t seed = 1;
  Trace trace = Trace::step_by_step;
  photons::Stepping stepping;  ///< of photons traced step by step
  photons::Marching marching;  ///< of photons that are marched
  int rays = 500;              ///< of the table
  double ring_width_m = 50e3;  ///< of the rings that gather, 1e3 to 2e6 m
  /// parts of the position angle, 1 to 1000; 1 takes every photon all around the axis
  std::size_t sectors = 1;
  std::optional<StoppingRule> enough;  ///< when met, ends before all photons are traced
  std::optional<BlockRange> blocks;    ///< the only ones that are traced; else all
  std::string key;                     ///< the sums' own: what they belong to
};

/// Refracted light by photons, for any atmosphere, as sums that can be added to.
///
/// Traced step by step, a photon has one wavelength, drawn at random; leaves a random place of the
/// solar disc, aimed at the ring of the air; and is gathered on every plane in the ring of axis
/// distances (and the sector) where it lands. Marched or by the table, it carries all
/// wavelengths, and a block of photons is spread evenly: over tangent heights, over directions and
/// distances of landing (LimbLandings). For those that are marched a coarse table only says where
/// to aim, which costs noise at worst; where they land, and with how much light, is that of the ray
/// that each went (MarchedPhotons). One sector replicates each photon all around the axis, which
/// only symmetric air allows. Blocks are added until all are done, or, in batches that double,
/// until there are enough.
///
/// Given     before   what was traced already, and is not traced again
/// Returned  `before` and more; marched or by the table alike to the last bit for any number of
///           threads, on processors with the same vectors; memory does not grow with the number of
///           photons
/// Throws    Error  when an argument is outside its range, one sector is asked of air that differs
///                  by region, or `before` belongs to something else
/// Source    Yapo & Cutler (2009) §3.1 and 3.2
PhotonSums traced(const atmosphere::Atmosphere& atmosphere, const Arrangement& arrangement,
                  std::span<const double> wavelengths_nm, const PhotonSettings& settings,
                  const PhotonSums* before = nullptr, const algebra::Progress& progress = {});

/// The light of the photons that are traced: estimated(traced(…)).
RefractedLight by_photons(const atmosphere::Atmosphere& atmosphere, const Arrangement& arrangement,
                          std::span<const double> wavelengths_nm, const PhotonSettings& settings,
                          const algebra::Progress& progress = {});

/// Light convolved along the axis distance with a Gaussian of that standard deviation,
/// rings weighted by their area; the standard error follows, its rings taken as independent.
///
/// Source  Yapo & Cutler (2009) §3.2, against grain
RefractedLight smoothed(const RefractedLight& light, double sigma_m);

}  // namespace coppermoon::shadow
