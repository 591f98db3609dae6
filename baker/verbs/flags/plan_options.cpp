// SPDX-License-Identifier: MIT
#include "verbs/flags/plan_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <vector>

#include "algebra/error.h"
#include "algebra/number.h"
#include "uses/light/planning.h"
#include "verbs/recipes/recipe.h"

namespace coppermoon::verbs {
namespace {

constexpr const char* planning_group = "How light is computed";

/// A term that may be left out, and its switch.
struct Term {
  std::string_view name;
  bool plan::Work::*in;
};

constexpr std::array terms{
    Term{"refracted-light", &plan::Work::refracted}, Term{"ellipsoid", &plan::Work::ellipsoid},
    Term{"regions", &plan::Work::regions}, Term{"scattered-light", &plan::Work::scattered_light}};

std::string term_names() {
  std::vector<std::string_view> names;
  for (const auto& term : terms) names.push_back(term.name);
  return fmt::format("none or {}, with commas between", fmt::join(names, ", "));
}

double tolerance_of(const std::string& text) {
  const auto percentage = algebra::number_with_unit(text, {{"%", 1}});
  if (!percentage)
    throw algebra::Error(fmt::format("tolerance = {}, allowed a percentage as 0.1%", text));
  algebra::require_within("tolerance [%]", *percentage, 0.01, 50);
  return 0.01 * *percentage;
}

double budget_of(const std::string& text) {
  const auto budget =
      algebra::number_with_unit(text, {{"ms", 1e-3}, {"s", 1}, {"min", 60}, {"", 1}});
  if (!budget)
    throw algebra::Error(fmt::format("budget = {}, allowed a time as 500ms, 2s or 1min", text));
  return *budget;
}

/// The tolerance that a quality stands for.
double tolerance_named(const std::string& quality) {
  if (quality == "draft") return 0.05;
  return quality == "reference" ? 5e-4 : 0.01;
}

}  // namespace

plan::Work everything_but(const std::string& list) {
  plan::Work work;
  for (const auto& term : terms) work.*term.in = true;
  if (list == "none") return work;
  std::istringstream names(list);
  for (std::string name; std::getline(names, name, ',');) {
    const auto term = std::ranges::find(terms, name, &Term::name);
    if (term == terms.end())
      throw algebra::Error(fmt::format("leave-out = {}, allowed {}", list, term_names()));
    work.*term->in = false;
  }
  return work;
}

void add_plan_options(CLI::App& verb, PlanOptions& options) {
  const auto add = [&](const char* flag, auto& value, const std::string& text) {
    return add_flag(verb, flag, value, text).in(planning_group);
  };
  add("--quality", options.quality,
      "error of luminance: draft (5 %), standard (1 %) or reference (0.05 %); paper: 1e7 photons "
      "step by step, as Yapo & Cutler (2009)")
      .one_of({"draft", "standard", "reference", "paper"});
  add("--tolerance", options.tolerance,
      "largest error of luminance on the disc, 0.01% to 50%, in place of --quality");
  add("--budget", options.budget,
      "time for the light, as 500ms, 2s or 1min: the most exact that it allows is made");
  add("--bands", options.bands, "number of wavelengths that light is computed at, 1 to 400");
  add("--rays", options.rays,
      "number of rays between the ground and the top of the air, for quadrature and table, 2 to "
      "1e7");
  add("--sun-terms", options.sun_terms,
      "number of terms of the Sun's limb darkening, 1 to 6; 6 is exact");
  add("--planes", options.planes, "number of planes across the Moon's depth, 1 to 9");
  add("--place-error", options.place_error,
      "error of light between the places where it is computed, 1e-5 to 1");
  add("--leave-out", options.leave_out, "terms to leave out: " + term_names());
}

plan::Wish wish_of(const PlanOptions& options) {
  plan::Wish wish;
  if (options.tolerance && options.quality != "standard")
    throw algebra::Error(fmt::format("tolerance = {}, allowed with quality standard, not {}",
                                     *options.tolerance, options.quality));
  if (options.tolerance) wish.tolerance = tolerance_of(*options.tolerance);
  if (options.budget) wish.budget_s = budget_of(*options.budget);
  if (!options.tolerance && !options.budget) wish.tolerance = tolerance_named(options.quality);
  return wish;
}

plan::ByHand by_hand(const PlanOptions& options) {
  plan::ByHand hand{.bands = options.bands,
                    .rays = options.rays,
                    .sun_terms = options.sun_terms,
                    .planes = options.planes,
                    .place_error = options.place_error};
  if (options.leave_out) hand.terms = everything_but(*options.leave_out);
  uses::require_knobs(hand);
  return hand;
}

std::string without_work(const std::string& recipe) {
  constexpr std::array replaced{"tolerance", "budget",      "bands",     "rays",    "sun-terms",
                                "planes",    "place-error", "leave-out", "photons", "solver"};
  return without(recipe, [&](const std::string& flag) {
    return std::ranges::find(replaced, flag) != replaced.end();
  });
}

std::string with_work(const std::string& recipe, const plan::Work& work) {
  std::vector<std::string_view> out;
  for (const auto& term : terms)
    if (!(work.*term.in)) out.push_back(term.name);
  std::string text = fmt::format(
      "bands = {}\nrays = {}\nsun-terms = {}\nplanes = {}\nplace-error = {}\nleave-out = '{}'\n",
      work.bands, work.rays, work.sun_terms, work.planes, work.place_error,
      out.empty() ? "none" : fmt::format("{}", fmt::join(out, ",")));
  const bool photons = work.method != plan::Method::quadrature;
  text += fmt::format("solver = '{}'\n", photons ? "photons" : "quadrature");
  if (photons) text += fmt::format("photons = {}\n", work.photons);
  return text + without_work(recipe);
}

std::string made_recipe(const std::string& recipe, bool unshadowed, const plan::Plan& plan) {
  return unshadowed ? recipe : with_work(recipe, plan.work);
}

}  // namespace coppermoon::verbs
