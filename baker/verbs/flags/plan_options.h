// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "plan/plan.h"
#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// How exact a Moon is to be, or how quick; and every knob by hand.
struct PlanOptions {
  std::string quality = "standard";
  std::optional<std::string> tolerance, budget, leave_out;
  std::optional<int> bands, rays, sun_terms, planes;
  std::optional<double> place_error;
};

void add_plan_options(CLI::App& verb, PlanOptions& options);

/// What is asked for: a tolerance as "1%", a budget as "2s", "500ms" or "2"; without
/// either the tolerance of the quality.
///
/// Throws  Error  when one of them cannot be understood, or a tolerance and a quality are both given
plan::Wish wish_of(const PlanOptions& options);

/// Throws  Error  when a knob is outside its range
plan::ByHand by_hand(const PlanOptions& options);

/// All terms but those that a list names, as "ellipsoid,regions", or "none".
///
/// Throws  Error  when it names what is no term
plan::Work everything_but(const std::string& list);

/// A recipe in which the work that was planned stands knob by knob, in the place of what was asked
/// for: the same Moon on any machine. The quality stays: it may say more. Quoted as recipe_of quotes.
std::string with_work(const std::string& recipe, const plan::Work& work);

/// The recipe of what was made: with the work that was planned, unless the Moon is unshadowed.
std::string made_recipe(const std::string& recipe, bool unshadowed, const plan::Plan& plan);

/// A recipe in which neither stands, nor what was asked for.
std::string without_work(const std::string& recipe);

}  // namespace coppermoon::verbs
