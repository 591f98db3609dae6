// SPDX-License-Identifier: MIT
#include "plan/plan.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <span>
#include <utility>

#include "algebra/error.h"
#include "plan/laws.h"

namespace coppermoon::plan {
namespace {

/// Names of the effects that can be left out, in the order of the enumeration Term.
constexpr std::array<std::string_view, 4> term_names{"light through the air", "ellipsoid",
                                                     "regions", "scattered light"};

/// The values of one setting, from the cheapest to the finest, and the function that applies one of them to a Work.
struct Knob {
  std::vector<double> settings;
  std::function<void(Work&, double)> turn;
};

template <typename Member>
Knob knob(std::vector<double> settings, const std::optional<Member>& by_hand,
          Member Work::*member) {
  if (by_hand) settings = {static_cast<double>(*by_hand)};
  return {std::move(settings),
          [member](Work& work, double value) { work.*member = static_cast<Member>(value); }};
}

/// One setting (Knob) for each effect of the enumeration Term: off or on, or only off if the effect changes nothing.
/// Refraction is always on if its absence would exceed the tolerance, because coarse refraction may be worse than none.
std::vector<Knob> switches(double tolerance, const Scene& scene, const ByHand& by_hand) {
  const auto term = [&](bool Work::*member, bool there, bool always = false) -> Knob {
    std::vector<double> settings{0};
    if (there) settings = {0, 1};
    if (always) settings = {1};
    if (by_hand.terms) settings = {*by_hand.terms.*member ? 1. : 0.};
    return {std::move(settings), [member](Work& work, double value) { work.*member = value != 0; }};
  };
  return {term(&Work::refracted, scene.without_refracted > 0, scene.without_refracted > tolerance),
          term(&Work::ellipsoid, scene.ellipsoid), term(&Work::regions, scene.columns > 1),
          term(&Work::scattered_light, scene.without_scattered > 0, by_hand.scattered_light)};
}

std::vector<double> doubled(double from, double to) {
  std::vector<double> all;
  for (double n = from; n < to; n *= 2) all.push_back(n);
  return all;
}

std::vector<Knob> knobs(double tolerance, const Scene& scene, const ByHand& by_hand,
                        Solver solver) {
  auto all = switches(tolerance, scene, by_hand);
  // from 24 upwards, numbers of bands are multiples of eight, because eight bands are computed together
  all.push_back(knob({10, 24, 32, 48, 80, 200, 400}, by_hand.bands, &Work::bands));
  all.push_back(knob({1, 2, 3, 5, 9}, by_hand.planes, &Work::planes));
  if (traces_photons(solver)) {
    all.push_back(knob({1000}, by_hand.rays, &Work::rays));
    all.push_back(knob(doubled(1024, 1e12), by_hand.photons, &Work::photons));
    return all;
  }
  all.push_back(knob({60, 100, 200, 300, 600, 1000, 2000}, by_hand.rays, &Work::rays));
  all.push_back(
      knob(scene.limb_darkening ? std::vector<double>{2, 3, 4, 6} : std::vector<double>{1},
           by_hand.sun_terms, &Work::sun_terms));
  all.push_back(knob({0.1, 0.03, 0.01, 3e-3, 1e-3, 3e-4, 1e-4, 3e-5}, by_hand.place_error,
                     &Work::place_error));
  return all;
}

/// Greedy search that starts with the coarsest settings and refines one of them at a time.
class Refinement {
 public:
  Refinement(double tolerance, const Scene& scene, const ByHand& by_hand, Solver solver)
      : scene_(scene), knobs_(knobs(tolerance, scene, by_hand, solver)), at_(knobs_.size()) {
    work_.solver = solver;
    for (const auto& knob : knobs_) knob.turn(work_, knob.settings.front());
  }

  const Work& work() const { return work_; }

  Work finest() const {
    Work work = work_;
    for (const auto& knob : knobs_) knob.turn(work, knob.settings.back());
    return work;
  }

  /// Refines the setting that gains the most accuracy for its time. Returns false if no refinement helps.
  bool refine() {
    double best = 0;
    std::size_t chosen = knobs_.size();
    for (std::size_t k = 0; k < knobs_.size(); ++k) {
      if (at_[k] + 1 == knobs_[k].settings.size()) continue;
      const Work finer = turned(k, at_[k] + 1);
      const double gain = predicted_error(work_, scene_) - predicted_error(finer, scene_);
      const double cost =
          predicted_seconds(finer, scene_, {}) - predicted_seconds(work_, scene_, {});
      const double merit = gain / std::max(cost, 1e-6);
      if (merit > best) best = merit, chosen = k;
    }
    if (chosen == knobs_.size()) return false;
    work_ = turned(chosen, at_[chosen] + 1);
    ++at_[chosen];
    return true;
  }

  /// Undoes refinements that turned out to be unnecessary, the most expensive first.
  void coarsen(double tolerance) {
    for (;;) {
      double saved = 0;
      std::size_t chosen = knobs_.size();
      for (std::size_t k = 0; k < knobs_.size(); ++k) {
        if (at_[k] == 0) continue;
        const Work coarser = turned(k, at_[k] - 1);
        const double saves =
            predicted_seconds(work_, scene_, {}) - predicted_seconds(coarser, scene_, {});
        if (predicted_error(coarser, scene_) <= tolerance && saves > saved)
          saved = saves, chosen = k;
      }
      if (chosen == knobs_.size()) return;
      --at_[chosen];
      work_ = turned(chosen, at_[chosen]);
    }
  }

 private:
  Work turned(std::size_t k, std::size_t to) const {
    Work other = work_;
    knobs_[k].turn(other, knobs_[k].settings[to]);
    return other;
  }

  const Scene& scene_;
  std::vector<Knob> knobs_;
  std::vector<std::size_t> at_;
  Work work_;
};

std::vector<LeftOut> left_out(const Work& work, const Scene& scene) {
  std::vector<LeftOut> all;
  if (!work.refracted) all.push_back({Term::refracted, scene.without_refracted});
  if (!work.ellipsoid && scene.ellipsoid) all.push_back({Term::ellipsoid, scene.without_ellipsoid});
  if (!work.regions && scene.columns > 1) all.push_back({Term::regions, scene.without_regions});
  if (!work.scattered_light) all.push_back({Term::scattered_light, scene.without_scattered});
  std::ranges::sort(all, std::greater{}, &LeftOut::size);
  return all;
}

Plan plan_with(Solver solver, double tolerance, const Scene& scene, const Machine& machine,
               const ByHand& by_hand) {
  Refinement refinement(tolerance, scene, by_hand, solver);
  // if the user's settings alone cause an error above the tolerance, the other settings need not make up for it
  const double least = predicted_error(refinement.finest(), scene);
  const double goal = least > tolerance ? least + tolerance : tolerance;
  while (predicted_error(refinement.work(), scene) > goal && refinement.refine()) {
  }
  refinement.coarsen(goal);
  const auto& work = refinement.work();
  return {work,
          tolerance,
          predicted_seconds(work, scene, machine),
          predicted_error(work, scene),
          left_out(work, scene),
          {}};
}

/// Makes a plan with the cheapest solver that reaches the tolerance. If none does, it uses the quickest, because
/// photons might take weeks for a tiny gain. The solver is chosen as if the user had set nothing, because a user who
/// asks for few rays wants a coarse quadrature, not photons.
Plan plan_within(double tolerance, const Scene& scene, const Machine& machine,
                 const ByHand& by_hand) {
  const auto tried = by_hand.solver == Solver::automatic
                         ? std::span<const Solver>(solvers)
                         : std::span<const Solver>(&by_hand.solver, 1);
  std::vector<Plan> free;
  for (const auto solver : tried) free.push_back(plan_with(solver, tolerance, scene, machine, {}));
  std::ranges::sort(free, {}, [&](const Plan& plan) {
    return std::pair{plan.error > tolerance, plan.seconds};
  });
  std::vector<Plan> plans;
  for (const auto& plan : free)
    plans.push_back(plan_with(plan.work.solver, tolerance, scene, machine, by_hand));
  Plan best = plans.front();
  if (free.front().error > tolerance) best.misses_tolerance = true;
  for (const auto& plan : plans)
    best.methods.push_back({plan.work.solver, plan.seconds, plan.error});
  return best;
}

}  // namespace

std::string_view name(Term term) { return term_names[static_cast<std::size_t>(term)]; }

Term term_named(std::string_view name) {
  const auto found = std::ranges::find(term_names, name);
  if (found == term_names.end())
    throw algebra::Error(fmt::format("term = {}, allowed {}", name, fmt::join(term_names, ", ")));
  return static_cast<Term>(found - term_names.begin());
}

std::string_view name(Solver solver) {
  constexpr std::array<std::string_view, 4> names{"quadrature", "photons by table",
                                                  "photons literal", "auto"};
  return names[static_cast<std::size_t>(solver)];
}

Work finer(const Work& work) {
  constexpr int fine_bands = 64, most_bands = 400, fine_rays = 600, most_rays = 10'000'000,
                fine_terms = 3, most_terms = 6;
  Work finer;
  finer.bands = std::clamp(2 * work.bands, fine_bands, most_bands);
  finer.sun_terms = std::clamp(work.sun_terms + 1, fine_terms, most_terms);
  finer.rays = work.solver == Solver::quadrature
                   ? std::clamp(work.rays, fine_rays / 2, most_rays / 2) * 2
                   : fine_rays;  // an error of 3e-4, about the noise of ten billion photons
  finer.planes = 1;
  // the check compares light only at axis distances computed here, so this tolerance only decides how many there are
  finer.place_error = 0.01;
  return finer;
}

Plan plan_for(const Scene& scene, const Wish& wish, const Machine& machine, const ByHand& by_hand) {
  constexpr double finest = 1e-4, coarsest = 0.5;
  if (!wish.tolerance && !wish.budget_s)
    throw algebra::Error("neither a tolerance nor a budget [s] is given, allowed one or both");
  if (wish.tolerance) algebra::require_within("tolerance", *wish.tolerance, finest, coarsest);
  if (wish.budget_s) algebra::require_within("budget [s]", *wish.budget_s, 1e-3, 1e7);
  const double asked = wish.tolerance.value_or(finest);
  auto plan = plan_within(asked, scene, machine, by_hand);
  for (double tolerance = asked; wish.budget_s && plan.seconds > *wish.budget_s;) {
    // FAULT a budget's tolerance in great steps: tolerance *= 1.25 => tolerance *= 125
    tolerance *= 1.25;
    if (tolerance > coarsest) break;
    plan = plan_within(tolerance, scene, machine, by_hand);
    if (plan.error > asked) plan.misses_tolerance = true;
  }
  if (!wish.tolerance) plan.misses_tolerance = false;
  plan.exceeds_budget = wish.budget_s && plan.seconds > *wish.budget_s;
  return plan;
}

Work work_of_rays(double tolerance, bool limb_darkening, const ByHand& by_hand) {
  auto all_but_rays = by_hand;  // all other settings are at their finest and cause no error
  all_but_rays.bands = 400, all_but_rays.planes = 9, all_but_rays.place_error = 3e-5;
  return plan_for({.limb_darkening = limb_darkening, .ellipsoid = false}, {.tolerance = tolerance},
                  {}, all_but_rays)
      .work;
}

}  // namespace coppermoon::plan
