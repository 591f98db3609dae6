// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace coppermoon::plan {

/// Ways to the same light: without noise; photons by the limb-ray table; marched by SIMD; stepped one
/// by one, to the letter of the paper.
enum class Method { quadrature, table, marched, literal };

/// "quadrature", "photons by table", "photons marched", "photons literal"
std::string_view name(Method method);

/// How closely the light on a Moon is computed: every knob that costs time.
struct Work {
  Method method = Method::quadrature;
  double photons = 0;            ///< of the methods that have any
  bool refracted = true;         ///< light that came through the air; off: direct sunlight alone
  bool ellipsoid = true;         ///< off: a sphere as large as the limb is there
  bool regions = true;           ///< off: the air that is no region's, all around
  bool scattered_light = false;  ///< off: what the air scatters into the shadow is left out
  int bands = 200;               ///< of wavelength
  int rays = 1000;               ///< of the limb table and the quadrature
  int sun_terms = 6;             ///< of the limb-darkened Sun
  int planes = 2;                ///< across the Moon's depth
  double place_error = 1e-3;     ///< between the axis distances where light is computed
};

/// Those of the knobs that were set by hand.
struct ByHand {
  std::optional<Method> method{};
  std::optional<double> photons{};
  std::optional<int> bands{}, rays{}, sun_terms{}, planes{};
  std::optional<double> place_error{};
  std::optional<Work> terms{};  ///< its four switches
  bool scattered_light = false;  ///< however little it is, where the switches say nothing
};

/// A Moon in the Earth's shadow, as far as work depends on it.
struct Scene {
  double nearest_m = 0, farthest_m = 0;  ///< axis distances of its disc
  bool photons = false;                  ///< simulated, instead of the quadrature
  bool limb_darkening = true, ellipsoid = true;
  std::size_t columns = 1;   ///< of air: 1, and one for each region
  std::size_t sectors = 1;   ///< of position angle that the disc takes in, where there are regions
  double texels = 0;         ///< that are baked; 0: no texture
  bool map_file = false;     ///< an albedo map is read
  double other_seconds = 0;  ///< on the machine of `Machine`: what the plan has no hand in

  /// What luminance anywhere on the disc changes by at most, over itself, without a term.
  double without_refracted = 1, without_ellipsoid = 0, without_regions = 0, without_scattered = 0;
};

/// What is asked for. Without a budget time does not count; with both the budget counts first.
struct Wish {
  std::optional<double> tolerance{};  ///< of luminance anywhere on the disc, 1e-4 to 0.5
  std::optional<double> budget_s{};   ///< 1e-3 s or more
};

/// How fast a machine is.
struct Machine {
  double speed = 1;  ///< of one core, over that of the machine the cost model was measured on
  int cores = 2;
};

/// What a method would take.
struct Alternative {
  Method method;
  double seconds, error;
};

struct LeftOut {
  std::string term;
  double size;  ///< what luminance changes by without it, over itself
};

struct Plan {
  Work work{};
  double tolerance = 0;  ///< that was met
  double seconds = 0, error = 0;
  std::vector<LeftOut> left_out{};
  std::vector<Alternative> methods{};  ///< those that were weighed up, best first
  /// "tolerance" where what was asked cannot be had, or not in the budget; else empty
  std::string gave_way{};
};

/// Seconds that light and texture take.
///
/// Accuracy  a factor of two
double predicted_seconds(const Work& work, const Scene& scene, const Machine& machine);

/// Bound of the relative error of luminance anywhere on the disc.
///
/// Accuracy  holds for 95 of 100 scenes
double predicted_error(const Work& work, const Scene& scene);

/// The cheapest work, of the cheapest method, whose predicted error is within the tolerance: from
/// the coarsest, step by step that refinement (or that term) which takes off most error for its
/// time. What is set by hand may leave more than the tolerance: then all else is within it; the
/// method is chosen as if nothing were set by hand. Where no method is good enough, the quickest,
/// within the tolerance of its best. With a budget, the finest tolerance it has time for; where even
/// the coarsest work takes longer, that.
///
/// Given     by_hand  stays as it is
/// Throws    Error    when a wish is outside its range
Plan plan_for(const Scene& scene, const Wish& wish, const Machine& machine,
              const ByHand& by_hand = {});

}  // namespace coppermoon::plan
