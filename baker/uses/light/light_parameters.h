// SPDX-License-Identifier: MIT
#pragma once

#include "request/recipe.h"
#include "uses/light/moonlight.h"

namespace coppermoon::uses {

/// Headings in the help text.
inline constexpr const char *air_heading = "The Earth's air",
                            *light_heading = "How light is computed";

/// Parameters of a column of air: those that a fit determines, and those that it takes as given.
void describe_sought(request::Parameters& is, ColumnChange& column);
void describe_layers(request::Parameters& is, ColumnChange& column);

/// Place and column of a part of the limb.
void describe(request::Parameters& is, AirRegion& region);

/// The atmosphere and its terms, without columns and regions.
void describe_terms(request::Parameters& is, Air& air);

/// All parameters of the air, including regions.
void describe(request::Parameters& is, Air& air);

/// Parameters for light from the Sun and the stars: limb darkening, scattered light, starlight.
void describe_sunlight(request::Parameters& is, LightRequest& light);

/// Requested accuracy and computing time of the light, as text.
struct Effort {
  std::string quality = "standard";
  std::optional<std::string> tolerance{}, budget{};
};
void describe(request::Parameters& is, Effort& effort);

/// The requested tolerance and budget; if neither is given, the tolerance that the quality stands for.
///
/// Throws  Error  when one of them cannot be understood, or both a tolerance and a quality are given
plan::Wish wish_of(const Effort& effort);

/// Numbers of wavelengths, rays, planes and so on, set by hand instead of chosen by the plan.
void describe_knobs(request::Parameters& is, plan::ByHand& knobs);

/// Parameters for the solver, the number of photons and the length of their steps.
void describe_solver(request::Parameters& is, LightRequest& light);

/// A part of the limb with air of its own, from a text such as
/// "from-latitude=-90,to-latitude=0,dust-extinction=1e-5".
///
/// Throws  Error  when the text cannot be understood, or does not say where the region is
AirRegion region_from(const std::string& text);

/// Work with all terms except those in a list such as "ellipsoid,regions", or "none".
///
/// Throws  Error  when the list contains something that is not a term
plan::Work everything_but(const std::string& list);

/// The air in words, for titles: "standard air, stratospheric aerosol extreme".
///
/// Given  parameters  those of the air, perhaps with others
std::string air_in_words(const request::Parameters& parameters);

/// Recipe with the planned work, knob by knob, in place of the settings it was planned from, so that any machine makes
/// the same Moon. The quality stays, since it may imply more.
request::Recipe with_work(const request::Recipe& recipe, const plan::Work& work);

/// Whether a setting is part of the work, or something that the work is planned from.
bool is_planned(const request::Setting& setting);

/// Recipe with everything that photons depend on. Sums of photons with a different recipe are refused.
std::string photons_recipe(const request::Parameters& parameters);

}  // namespace coppermoon::uses
