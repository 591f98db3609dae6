// SPDX-License-Identifier: MIT
#pragma once

#include "request/recipe.h"
#include "uses/light/moonlight.h"

namespace coppermoon::uses {

/// Headings of help.
inline constexpr const char *air_heading = "The Earth's air",
                            *light_heading = "How light is computed";

/// Parameters of a column of air: those that a fit seeks, and those that it takes as given.
void describe_sought(request::Parameters& is, ColumnChange& column);
void describe_layers(request::Parameters& is, ColumnChange& column);

/// Place and column of a part of the limb.
void describe(request::Parameters& is, AirRegion& region);

/// The atmosphere and its terms, without columns and regions.
void describe_terms(request::Parameters& is, Air& air);

/// All of the air; regions too.
void describe(request::Parameters& is, Air& air);

/// Light of the Sun and the stars: limb darkening, scattered light, starlight.
void describe_sunlight(request::Parameters& is, LightRequest& light);

/// Exactness and time of the light as they are asked for, in words.
struct Effort {
  std::string quality = "standard";
  std::optional<std::string> tolerance{}, budget{};
};
void describe(request::Parameters& is, Effort& effort);

/// Tolerance and budget that are asked for; without either the tolerance of the quality.
///
/// Throws  Error  when one of them cannot be understood, or a tolerance and a quality are both given
plan::Wish wish_of(const Effort& effort);

/// Number of wavelengths, rays, planes …, in place of those that the plan chooses.
void describe_knobs(request::Parameters& is, plan::ByHand& knobs);

/// Solver, photons and their steps.
void describe_solver(request::Parameters& is, LightRequest& light);

/// A part of the limb with air of its own, as "from-latitude=-90,to-latitude=0,dust-extinction=1e-5".
///
/// Throws  Error  when it cannot be understood, or does not say where the region is
AirRegion region_from(const std::string& text);

/// Terms that a list leaves out of the light, as "ellipsoid,regions" or "none": all others are in.
///
/// Throws  Error  when it names what is no term
plan::Work everything_but(const std::string& list);

/// The air in words, for titles: "standard air, stratospheric aerosol extreme".
///
/// Given  parameters  of the air, among others
std::string air_in_words(const request::Parameters& parameters);

/// Recipe in which the planned work, knob by knob, replaces what it was planned from: the same Moon on any machine.
/// The quality stays: it may say more.
request::Recipe with_work(const request::Recipe& recipe, const plan::Work& work);

/// Whether a setting is work, or what work is planned from.
bool is_planned(const request::Setting& setting);

/// Recipe of all that photons depend on: sums of photons with another one are refused.
std::string photons_recipe(const request::Parameters& parameters);

}  // namespace coppermoon::uses
