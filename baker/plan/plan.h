// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace coppermoon::plan {

/// Methods of computing refracted light: the quadrature, which has no noise; photons by a table of the limb's
/// rays; photons marched in SIMD lanes; photons step by step, exactly as Yapo & Cutler (2009) trace them.
enum class Method { quadrature, table, marched, step_by_step };

/// All methods, in order.
inline constexpr std::array methods{Method::quadrature, Method::table, Method::marched,
                                    Method::step_by_step};

/// Name of a method in reports: "quadrature", "photons by table", "photons marched", or "photons
/// literal" for `Method::step_by_step`.
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

/// Settings that the error of some work is found against: one plane, all terms, every knob twice as fine, and
/// never coarse, for two coarse settings may be wrong alike.
Work finer(const Work& work);

/// The knobs that were set by hand; the others are empty, and free.
struct ByHand {
  std::optional<Method> method{};
  std::optional<double> photons{};
  std::optional<int> bands{}, rays{}, sun_terms{}, planes{};
  std::optional<double> place_error{};
  std::optional<Work> terms{};   ///< sets the four switches, and nothing else
  bool scattered_light = false;  ///< wanted however little it is, where `terms` is empty
};

/// A Moon in the Earth's shadow, as far as work depends on it.
struct Scene {
  double nearest_m = 0, farthest_m = 0;  ///< axis distances of its disc
  bool limb_darkening = true, ellipsoid = true;
  std::size_t columns = 1;  ///< of air: 1; with regions or belts more
  std::size_t parts = 1;  ///< of the limb that have rays of their own, where there are more columns
  bool borders = false;   ///< whether one air ends and another begins somewhere, as of regions
  double texels = 0;      ///< that are baked; 0: no texture
  bool map_file = false;  ///< an albedo map is read

  /// Largest relative change of luminance anywhere on the disc when a term is left out.
  double without_refracted = 1, without_ellipsoid = 0, without_regions = 0, without_scattered = 0;
};

/// Tolerance, budget or both, as asked for. Without a budget time does not count; with both the budget counts first.
struct Wish {
  std::optional<double> tolerance{};  ///< of luminance anywhere on the disc, 1e-4 to 0.5
  std::optional<double> budget_s{};   ///< 1e-3 s or more
};

/// How fast a machine is.
struct Machine {
  double speed = 1;  ///< of one core, over that of the machine the cost model was measured on
  int cores = 2;
};

/// A method that was weighed up: its predicted time and error.
struct Alternative {
  Method method;
  double seconds, error;
};

/// Terms of the light that may be left out: light through the air, the Earth's flattening, differences of the
/// air around the limb, scattered light.
enum class Term { refracted, ellipsoid, regions, scattered_light };

/// The term's name in reports: "light through the air", "ellipsoid", "regions" or "scattered light".
std::string_view name(Term term);

/// The term of a name in reports.
///
/// Throws  Error  when there is none
Term term_named(std::string_view name);

struct LeftOut {
  Term term;
  double size;  ///< relative change of luminance without it
};

struct Plan {
  Work work{};
  double tolerance = 0;  ///< that the work was chosen for
  double seconds = 0, error = 0;
  std::vector<LeftOut> left_out{};
  std::vector<Alternative> methods{};  ///< those that were weighed up, best first
  bool misses_tolerance = false;  ///< the one asked for cannot be had, or not within the budget
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
/// Throws    Error    when a wish is outside its range, or asks for nothing
Plan plan_for(const Scene& scene, const Wish& wish, const Machine& machine,
              const ByHand& by_hand = {});

/// The rays and the terms of the Sun that light at given places and wavelengths takes, on one plane;
/// nothing else of the work is chosen.
///
/// Given   by_hand  its rays and terms stay as they are
/// Throws  Error    when the tolerance is outside its range
Work work_of_rays(double tolerance, bool limb_darkening, const ByHand& by_hand = {});

}  // namespace coppermoon::plan
