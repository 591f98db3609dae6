// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <variant>

#include "photons/bending.h"
#include "photons/march_air.h"

namespace coppermoon::photons {

/// Digits of the numbers a march is done in: 7, twice as many rays at a time; or 16.
enum class Precision { single, full };

/// How finely rays are marched.
struct Marching {
  double step_m = 1000;  ///< length of one step, 1 to 100 000 m; if single, to 1/8 m
  Precision precision = Precision::full;
};

/// Follows many rays through a column of air that is alike all around, step by step, each in its own
/// plane, as many at a time as the machine's SIMD has lanes.
///
///     x'' = n ∇n        in σ, ds = n dσ;        ∇n = n'(q) x / R,  q = (|x|² − R²) / 2R
///     w_{k+1} − 2 w_k + w_{k−1} = Δσ² x''_k      w = x − x'' Δσ² / 12
///
/// which is Størmer's (or Verlet's) step, with one look-up of the air, made of fourth order by
/// Numerov's w. x'' in w's definition is that of the step before. What is carried is the small
/// difference from the straight line, in position and in n t; the amounts are sums over the same
/// points. Where the air begins, ends, or its profiles or their slopes break, the sums are set right
/// by Euler and Maclaurin's first two terms at the place of the break within the step. Δσ is the
/// step's length: n − 1 < 3e-4.
///
/// Unlike limb_path, which integrates along altitude with b = n r as known, this follows light with
/// no knowledge of where it will go.
///
/// Accuracy  tangent heights 500 m to 40 km, of bending and of the amount of air, against limb_path:
///           5e-7 at 1 km, 6e-5 at 10 km, 5e-4 at 30 km; single precision 4e-6 at 1 km, 4e-5 at
///           100 m. Of ozone and aerosol, against as exact an integral: 3e-6 at 1 km, 6e-5 at 10 km,
///           1.5e-3 at 30 km; single precision 6e-6 at 1 km
/// Omits     breaks of the air that a ray dips under within one step, less deep than step²/8R, 2 cm
///           at 1 km: up to 2e-3 of its bending at 1 km and 1e-2 at 10 km, under the top of the air
///           all of it; the step in refractivity where US 1976 ends at 86 km, 1.5e-9
/// Throws    Error  when the step or the Earth's radius, 1e6 to 1e7 m, is outside its range
/// Source    Sharma, Kumar & Ghatak (1982), Appl. Opt. 21, 984, for the parameter σ; Hairer, Nørsett &
///           Wanner (1993), Solving Ordinary Differential Equations I, III.10, for the step
class Marcher {
 public:
  /// Given  earth_radius_m  of the ground's curvature along the path
  Marcher(const atmosphere::Column& column, double earth_radius_m, const Marching& marching);

  /// Fills in the paths that limb_path gives, ray by ray. Rays of similar heights side by side end
  /// together, which wastes no lanes.
  ///
  /// Given     tangent_heights_m  0 to the top of the air
  ///           refractivity       n₀ − 1, at sea level, 0 to 0.001
  ///           paths              as many, to be filled
  /// Returned  the steps that the rays took, all together
  /// Throws    Error              when an argument is outside its range
  std::uint64_t follow(std::span<const double> tangent_heights_m, double refractivity,
                       std::span<LimbPath> paths) const;

 private:
  atmosphere::Column column_;
  double earth_radius_m_, step_m_;
  std::variant<MarchAir<double>, MarchAir<float>> air_;
};

}  // namespace coppermoon::photons
