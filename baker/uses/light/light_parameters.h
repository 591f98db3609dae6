// SPDX-License-Identifier: MIT
#pragma once

#include "request/recipe.h"
#include "uses/light/moonlight.h"

namespace coppermoon::uses {

/// Headings in the help text.
inline constexpr const char *air_heading = "The Earth's air",
                            *light_heading = "How light is computed";

/// Parameters of a column of air: those that a fit determines, then (describe_layers) those that it takes as given.
void describe_sought(request::Parameters& is, ColumnChange& column);
void describe_layers(request::Parameters& is, ColumnChange& column);

/// Parameters of a region: its place on the limb and its column of air.
void describe(request::Parameters& is, AirRegion& region);

/// Parameters of the atmosphere and its terms, except those of columns and regions.
void describe_terms(request::Parameters& is, Air& air);

/// All parameters of the air, including regions.
void describe(request::Parameters& is, Air& air);

/// Parameters for light from the Sun and the stars: limb darkening, scattered light, starlight.
void describe_sunlight(request::Parameters& is, LightRequest& light);

/// Requested accuracy and computing time of the light, as strings.
struct Effort {
  std::string quality = "standard";
  std::optional<std::string> tolerance{}, budget{};
};
void describe(request::Parameters& is, Effort& effort);

/// The requested tolerance and time budget. If neither is given, the tolerance is the one that the quality stands for.
///
/// Throws  Error  when one of them cannot be understood, or both a tolerance and a quality are given
plan::Wish wish_of(const Effort& effort);

/// Parameters for the numbers of bands, rays, planes and so on. If the user sets one, the plan does not choose it.
void describe_knobs(request::Parameters& is, plan::ByHand& knobs);

/// Parameters for the solver and its photons, such as their number and the length of their steps.
void describe_solver(request::Parameters& is, LightRequest& light);

/// Parses a region of the limb from a string such as "from-latitude=-90,to-latitude=0,dust-extinction=1e-5".
///
/// Throws  Error  when the text cannot be understood, or does not say where the region is
AirRegion region_from(const std::string& text);

/// Work with all terms except those in a list such as "ellipsoid,regions". The list "none" leaves out nothing.
///
/// Throws  Error  when the list contains something that is not a term
plan::Work everything_but(const std::string& list);

/// The air in words, for titles: "standard air, stratospheric aerosol extreme".
///
/// Given  parameters  those of the air; any others are ignored
std::string air_in_words(const request::Parameters& parameters);

/// Recipe with the numbers that the planner chose, such as rays, instead of the settings it planned from, such as the
/// tolerance. Every machine then renders the same Moon. `quality` is kept, because it may imply other settings too.
request::Recipe with_work(const request::Recipe& recipe, const plan::Work& work);

/// Whether a setting is chosen by the planner, such as rays, or is one it plans from, such as the tolerance.
bool is_planned(const request::Setting& setting);

/// Recipe of all settings on which photons depend. Sums of photons with a different recipe are refused.
std::string photons_recipe(const request::Parameters& parameters);

}  // namespace coppermoon::uses
