// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace coppermoon::plan {

/// How closely the light on a Moon is computed: every knob that costs time.
struct Work {
  bool refracted = true;         ///< light that came through the air; off: direct sunlight alone
  bool ellipsoid = true;         ///< off: a sphere as large as the limb is there
  bool regions = true;           ///< off: the air that is no region's, all around
  bool scattered_light = false;  ///< off: what the air scatters into the shadow is left out
  int bands = 200;               ///< of wavelength
  int rays = 1000;               ///< of the limb table and the quadrature
  int sun_terms = 6;             ///< of the limb-darkened Sun
  int planes = 3;                ///< across the Moon's depth
  double spacing_km = 25;        ///< of axis distance
};

/// Those of the knobs that were set by hand.
struct ByHand {
  std::optional<int> bands, rays, sun_terms, planes;
  std::optional<double> spacing_km;
  std::optional<bool> scattered_light;
};

/// A Moon in the Earth's shadow, as far as work depends on it.
struct Scene {
  double nearest_m = 0, farthest_m = 0;  ///< axis distances of its disc
  bool limb_darkening = true, ellipsoid = true;
  std::size_t columns = 1;  ///< of air: 1, and one for each region
  std::size_t sectors = 1;  ///< of position angle that the disc takes in, where there are regions
  double texels = 0;        ///< that are baked; 0: no texture
  bool map_file = false;    ///< an albedo map is read
  double other_seconds = 0; ///< on the machine of `Machine`: what the plan has no hand in

  /// What luminance anywhere on the disc changes by at most, over itself, without a term.
  double without_refracted = 1, without_ellipsoid = 0, without_regions = 0, without_scattered = 0;
};

/// What is asked for. Without a budget time does not count; with both the budget counts first.
struct Wish {
  std::optional<double> tolerance;  ///< of luminance anywhere on the disc, 1e-4 to 0.5
  std::optional<double> budget_s;   ///< 1e-3 s or more
};

/// How fast a machine is.
struct Machine {
  double speed = 1;  ///< of one core, over that of the machine the cost model was measured on
  int cores = 2;
};

struct LeftOut {
  std::string term;
  double size;  ///< what luminance changes by without it, over itself
};

struct Plan {
  Work work;
  double tolerance;  ///< that was met
  double seconds, error;
  std::vector<LeftOut> left_out;
  std::string gave_way;  ///< "tolerance" where the budget took more than was asked, else empty
};

/// Seconds that light and texture take.
///
/// Accuracy  a factor of two
double predicted_seconds(const Work& work, const Scene& scene, const Machine& machine);

/// Bound of the relative error of luminance anywhere on the disc.
///
/// Accuracy  holds for 95 of 100 scenes
double predicted_error(const Work& work, const Scene& scene);

/// The cheapest work whose predicted error is within the tolerance: from the coarsest, step by step
/// that refinement (or that term) which takes off most error for its time. With a budget, the
/// finest tolerance it has time for; where even the coarsest work takes longer, that.
///
/// Given     by_hand  stays as it is
/// Throws    Error    when a wish is outside its range
Plan plan_for(const Scene& scene, const Wish& wish, const Machine& machine,
              const ByHand& by_hand = {});

}  // namespace coppermoon::plan
