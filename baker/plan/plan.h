// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "algebra/described.h"

namespace coppermoon::plan {

/// Ways to compute refracted light: the quadrature, which has no noise; photons through a table of the limb's rays;
/// literal photons, traced step by step exactly as Yapo & Cutler (2009) do; or automatic, which lets the plan choose.
enum class Solver { quadrature, table, literal, automatic };

/// Solvers among which a plan chooses.
inline constexpr std::array solvers{Solver::quadrature, Solver::table, Solver::literal};

constexpr bool traces_photons(Solver solver) {
  return solver == Solver::table || solver == Solver::literal;
}

/// Name of a solver in reports: "quadrature", "photons by table" or "photons literal".
std::string_view name(Solver solver);

/// Settings for computing the light on the Moon, which trade accuracy against time.
struct Work {
  Solver solver = Solver::quadrature;
  double photons = 0;     ///< number of photons; 0 for the quadrature
  bool refracted = true;  ///< light refracted by the air; if false, only direct sunlight
  /// if false, the Earth is a sphere with the radius that the limb has at the Moon's position angle
  bool ellipsoid = true;
  bool regions = true;           ///< if false, the air outside all regions is used everywhere
  bool scattered_light = false;  ///< twilight that the air scatters into the shadow
  int bands = 200;               ///< number of wavelength bands
  int rays = 1000;               ///< number of rays in the limb table and the quadrature
  int sun_terms = 6;             ///< number of terms that represent the limb-darkened Sun
  int planes = 2;                ///< number of shadow planes, spread over the Moon's depth
  double place_error = 1e-3;     ///< tolerance for interpolation between axis distances
};

/// Settings finer than the given ones, for reference light from which their error is found: one plane, all terms of
/// refracted light, one more term for the Sun, and twice as many bands and rays. None is coarse, because two coarse
/// settings may err alike. Photons are compared with a quadrature whose rays err by less than the photons' noise.
Work finer(const Work& work);

/// Settings made by the user; the plan chooses those that are absent.
struct ByHand {
  Solver solver = Solver::automatic;
  std::optional<double> photons{};
  std::optional<int> bands{}, rays{}, sun_terms{}, planes{};
  std::optional<double> place_error{};
  std::optional<Work> terms{};   ///< only refracted, ellipsoid, regions, scattered_light are used
  bool scattered_light = false;  ///< forces scattered light, however faint, unless `terms` is given
};

/// Properties of a scene (the Moon in the Earth's shadow) on which the computing time and the error depend.
struct Scene {
  double nearest_m = 0, farthest_m = 0;  ///< least and largest axis distance of the Moon's disc
  bool limb_darkening = true, ellipsoid = true;
  std::size_t columns = 1;  ///< number of columns of air; more than 1 if the air varies with place
  std::size_t parts = 1;    ///< number of parts of the limb, each with its own rays, if columns > 1
  bool borders = false;     ///< whether the air changes abruptly somewhere, as with regions
  double texels = 0;        ///< number of texels in the baked texture; 0 without a texture
  bool map_file = false;    ///< whether an albedo map is read

  /// Largest relative change of luminance anywhere on the disc if the effect in the member's name is left out.
  double without_refracted = 1, without_ellipsoid = 0, without_regions = 0, without_scattered = 0;
};

/// Requested tolerance, time budget, or both. If both are given, the budget takes precedence.
struct Wish {
  std::optional<double> tolerance{};  ///< relative error of luminance on the disc, 1e-4 to 0.5
  std::optional<double> budget_s{};   ///< computing time, at least 1e-3 s
};

struct Machine {
  double speed = 1;  ///< speed of one core; 1 for the machine on which costs were measured
  int cores = 2;
};

/// A solver that a plan has considered, with its predicted time and error.
struct Alternative {
  Solver solver;
  double seconds, error;
};

/// Terms of the light that may be left out: light through the air, the Earth's flattening, differences in the air
/// around the limb, and scattered light.
enum class Term { refracted, ellipsoid, regions, scattered_light };

/// Name of a term in reports: "light through the air", "ellipsoid", "regions" or "scattered light".
std::string_view name(Term term);

/// Term that has the given name in reports.
///
/// Throws  Error  if no term has that name
Term term_named(std::string_view name);

struct LeftOut {
  Term term;
  double size;  ///< relative change of luminance if the term is left out
};

struct Plan {
  Work work{};
  double tolerance = 0;  ///< tolerance for which the settings were chosen
  double seconds = 0, error = 0;
  std::vector<LeftOut> left_out{};
  std::vector<Alternative> methods{};  ///< solvers considered, best first
  bool misses_tolerance = false;       ///< whether no affordable plan meets the tolerance
  bool exceeds_budget = false;         ///< whether the coarsest settings exceed the time budget
};

/// Computing time in seconds, and the largest relative error of luminance on the Moon's disc.
struct Cost {
  double seconds = 0, error = 0;
};

template <class Field>
void describe(Field&& is, const Cost& cost) {
  is.a("Cost", "Time and error of light.");
  is("seconds", cost.seconds, algebra::unit::seconds, "time");
  is("error", cost.error, "relative error of luminance, the largest on the disc");
}

template <class Field>
void describe(Field&& is, const Alternative& one) {
  is.a("Alternative", "A method that was weighed.");
  is("method", name(one.solver), "its name");
  describe(is, Cost{one.seconds, one.error});
}

template <class Field>
void describe(Field&& is, const LeftOut& one) {
  is.a("LeftOut", "A term of the light that is left out.");
  is("term", name(one.term), "its name");
  is("size", one.size, "relative change of luminance without it");
}

template <class Field>
void describe(Field&& is, const Plan& plan) {
  const auto any = [](const auto& list) {
    return list.empty() ? std::nullopt : std::optional(list);
  };
  const char* gave_way = plan.exceeds_budget ? "budget" : "tolerance";
  is.a("Plan", "What light requires, and what it will cost.");
  is("left_out", plan.left_out, "terms that are too small to count");
  is("predicted", Cost{plan.seconds, plan.error}, "what is predicted");
  is("methods", algebra::if_any(any(plan.methods)), "methods that were weighed, best first");
  is("gave_way",
     algebra::if_any(plan.misses_tolerance || plan.exceeds_budget
                         ? std::optional(algebra::Word{gave_way, {"tolerance", "budget"}})
                         : std::nullopt),
     "wish that is not met");
}

/// Predicted time to compute the light and the texture, in seconds.
///
/// Accuracy  a factor of two
double predicted_seconds(const Work& work, const Scene& scene, const Machine& machine);

/// Predicted bound on the relative error of luminance anywhere on the disc.
///
/// Accuracy  the error stays within the bound in 95 of 100 scenes
double predicted_error(const Work& work, const Scene& scene);

/// Finds the cheapest settings, with the cheapest solver, whose predicted error is within the tolerance. The search is
/// greedy: it begins with the coarsest settings and adds, one at a time, the refinement or the term that removes the
/// most error for its time. If the user names no solver, the user's other settings are ignored when one is chosen. If
/// no solver reaches the tolerance, the quickest is used. If that solver or the user's settings make the tolerance
/// unreachable, the error may exceed the least possible error by up to the tolerance. With a time budget, the plan has
/// the finest tolerance for which there is time, or the coarsest settings if there is no time for any tolerance.
///
/// Given     by_hand  settings made by the user, which the plan keeps
/// Throws    Error    if the tolerance or the time budget is outside its range, or both are absent
Plan plan_for(const Scene& scene, const Wish& wish, const Machine& machine,
              const ByHand& by_hand = {});

/// Settings for light at given places and wavelengths on one plane. Only the numbers of rays and limb-darkening terms
/// are chosen. The other settings are the finest ones.
///
/// Given   by_hand  the user's numbers of rays and of limb-darkening terms, which the plan keeps
/// Throws  Error    if the tolerance is outside its range
Work work_of_rays(double tolerance, bool limb_darkening, const ByHand& by_hand = {});

}  // namespace coppermoon::plan
