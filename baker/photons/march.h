// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <variant>

#include "photons/bending.h"
#include "photons/march_air.h"

namespace coppermoon::photons {

/// Floating-point precision of a march: single (7 digits) marches twice as many rays at a time as full (16).
enum class Precision { single, full };

/// Step and precision of a march.
struct Marching {
  double step_m = 1000;  ///< length of one step, 1 to 100 000 m; single: rounded to 1/8 m
  Precision precision = Precision::full;
};

/// Marching of many rays through spherically symmetric air, step by step, each in its own plane, with one ray in
/// each SIMD lane.
///
///     x'' = n ∇n        in σ, ds = n dσ;        ∇n = n'(q) x / R,  q = (|x|² − R²) / 2R
///     w_{k+1} − 2 w_k + w_{k−1} = Δσ² x''_k      w = x − x'' Δσ² / 12
///
/// which is Størmer's (Verlet's) step, with one look-up of the air, raised to fourth order by Numerov's w. The x''
/// in the definition of w is taken from the previous step. The state is the small difference from the straight line,
/// in position and in n t; amounts are sums over the same points. Where profiles or their slopes jump (and where
/// the air begins and ends), the first two terms of Euler and Maclaurin correct the sums for the place of the jump
/// within the step. Δσ equals the step's length: n − 1 < 3e-4.
///
/// limb_path integrates over altitude, with the invariant b = n r; a march does not use the invariant.
///
/// Accuracy  relative, of bending and of the amount of air, against limb_path, for tangent heights from 500 m to
///           40 km: steps of 1 km 5e-7, 10 km 6e-5, 30 km 5e-4; single precision 4e-6 at 1 km, 4e-5 at
///           100 m. Of ozone and aerosol, against an equally exact integral: 3e-6 at 1 km, 6e-5 at 10 km,
///           1.5e-3 at 30 km; single precision 6e-6 at 1 km
/// Omits     jumps of the air that a ray dips under within one step, less deep than step²/8R (2 cm
///           at 1 km): up to 2e-3 of bending with steps of 1 km and 1e-2 with 10 km; just under the top of the
///           air all bending. The jump of refractivity where US 1976 ends at 86 km, 1.5e-9
/// Throws    Error  when the step or the Earth's radius, 1e6 to 1e7 m, is outside its range
/// Source    Sharma, Kumar & Ghatak (1982), Appl. Opt. 21, 984, for the parameter σ; Hairer, Nørsett &
///           Wanner (1993), Solving Ordinary Differential Equations I, III.10, for the step
class Marcher {
 public:
  /// Given  earth_radius_m  radius of curvature of the ground along the path
  Marcher(const atmosphere::Column& column, double earth_radius_m, const Marching& marching);

  /// Marches rays and writes their paths, as limb_path computes them. Neighbours of similar height finish
  /// together, which keeps all lanes busy.
  ///
  /// Given     tangent_heights_m  0 to the top of the air
  ///           refractivity       n₀ − 1, at sea level, 0 to 0.001
  ///           paths              output, one for each tangent height
  /// Returned  number of steps, all rays together
  /// Throws    Error              when an argument is outside its range
  std::uint64_t follow(std::span<const double> tangent_heights_m, double refractivity,
                       std::span<LimbPath> paths) const;

 private:
  atmosphere::Column column_;
  double earth_radius_m_, step_m_;
  std::variant<MarchAir<double>, MarchAir<float>> air_;
};

}  // namespace coppermoon::photons
