// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "eclipse/contacts.h"
#include "eclipse/shadow_axis.h"
#include "uses/light/shadow_profile.h"
#include "uses/picture/brightness.h"
#include "uses/plot/plot.h"

namespace coppermoon::uses {

/// Title and marks of a plot of the shadow.
struct ShadowMarks {
  std::string title;
  double umbra_m, penumbra_m;         ///< radii of the shadow; umbra_m ≤ 0 beyond the umbra's tip
  std::optional<double> moon_m = {};  ///< distance of the Moon's centre from the axis
};

/// The marks in a plot of the shadow: the radii of umbra and penumbra, and the Moon's distance from the shadow's axis.
///
/// Given  cut  one plane across the shadow
///        sky  the sky at the moment of the plot; if absent, the Moon is not marked
/// Source of the radii  eclipse::shadow_radii, Danjon's convention
ShadowMarks marks_of(const shadow::Arrangement& cut, const std::optional<almanac::SkyState>& sky,
                     std::string title);

/// Plots, with gnuplot, the ratio of irradiance to full sunlight against the distance from the shadow's axis. Each
/// wavelength has its own colour.
///
/// Given   picture  ends in .png, .svg or .pdf
/// Throws  Error    when write_plot does
void write_shadow_plot(const std::filesystem::path& picture, const ShadowProfile& profile,
                       const ShadowMarks& marks);

/// Colour for a wavelength in a plot on white, as sRGB "#rrggbb". It is the colour that the CIE 1931 observer sees, as
/// saturated as the display allows, but dark enough to be readable.
///
/// Given  wavelength_nm  380 to 780
std::string plot_colour(double wavelength_nm);

double hours_from_greatest(const eclipse::Eclipse& eclipse, const almanac::Instant& when);

/// A plot over time, in hours from greatest eclipse, with the contacts marked. The caller adds the panels.
Plot plot_over(const eclipse::Eclipse& eclipse, const almanac::Instant& from,
               const almanac::Instant& to);

/// A plot with two panels: magnitudes by band above, illuminance below. Dashed lines are for the observer's place.
///
/// Given  place  name of the observer's place; empty if the curve has no observer
Plot plot_of(const LightCurve& curve, const eclipse::Eclipse& eclipse, const std::string& place);

}  // namespace coppermoon::uses
