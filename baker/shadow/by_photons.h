// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "algebra/progress.h"
#include "photons/trace.h"
#include "shadow/irradiance.h"

namespace coppermoon::shadow {

/// How a photon finds its way through the air: step by step, in three dimensions, to the letter of
/// the paper; or by a table of the limb's rays (photons::WholeLimb), in the plane of its own.
enum class Trace { each, table };

/// How many photons, which, and how they are traced and gathered.
struct PhotonSettings {
  std::uint64_t photons = 1'000'000;  ///< 1 to 1e12
  std::uint64_t seed = 1;
  Trace trace = Trace::each;
  photons::Stepping stepping;  ///< of photons traced each
  int rays = 500;              ///< of the table
  double ring_width_m = 50e3;  ///< of the rings that gather, 1e3 to 2e6 m
  /// parts of the position angle; 1 takes every photon all around the axis
  std::size_t sectors = 1;
};

/// Refracted light by the paper's photon simulation, for any atmosphere.
///
/// Each photon has one wavelength, drawn at random; leaves a random place of the solar disc, aimed
/// at the ring of the air; is traced; and is gathered on every plane in the ring of axis
/// distances (and the sector) where it lands. One sector replicates each photon all around the
/// axis, which only symmetric air allows. A cell's mean and standard error come from sums and sums
/// of squares over all photons.
///
/// Returned  axis_distances_m at the rings' middles; the same for any number of threads
/// Throws    Error  when an argument is outside its range, or one sector is asked of air that
///                  differs by region
/// Source    Yapo & Cutler (2009) §3.1 and 3.2
RefractedLight by_photons(const atmosphere::Atmosphere& atmosphere, const Arrangement& arrangement,
                          std::span<const double> wavelengths_nm, const PhotonSettings& settings,
                          const algebra::Progress& progress = {});

/// The same light convolved along the axis distance with a Gaussian of that standard deviation,
/// rings weighted by their area; the standard error follows, its rings taken as independent.
///
/// Source  Yapo & Cutler (2009) §3.2, against grain
RefractedLight smoothed(const RefractedLight& light, double sigma_m);

}  // namespace coppermoon::shadow
