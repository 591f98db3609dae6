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

/// What a plot of the shadow shows besides its light.
struct ShadowMarks {
  std::string title;
  double umbra_m, penumbra_m;         ///< radii of the shadow; the umbra's is ≤ 0 beyond its tip
  std::optional<double> moon_m = {};  ///< distance of the Moon's centre from the axis
};

/// The edges of umbra and penumbra, and where the Moon stands.
///
/// Given  cut  one plane
///        sky  at the moment of the plot, if it has one
/// Source of the edges  eclipse::shadow_radii, Danjon's convention
ShadowMarks marks_of(const shadow::Arrangement& cut, const std::optional<almanac::SkyState>& sky,
                     std::string title);

/// Plots the ratio of irradiance to sunlight against distance from the axis, each wavelength in its own colour, with
/// gnuplot.
///
/// Given   picture  ends in .png, .svg or .pdf
/// Throws  Error    as write_plot
void write_shadow_plot(const std::filesystem::path& picture, const ShadowProfile& profile,
                       const ShadowMarks& marks);

/// The colour in which a plot on white draws a wavelength, as sRGB "#rrggbb": the colour of its light to the CIE
/// 1931 observer, as saturated as the display allows, and dark enough to be read.
///
/// Given  wavelength_nm  380 to 780
std::string plot_colour(double wavelength_nm);

double hours_from_greatest(const eclipse::Eclipse& eclipse, const almanac::Instant& when);

/// Plot against hours from the greatest eclipse, with the contacts marked, but no panels yet.
Plot plot_over(const eclipse::Eclipse& eclipse, const almanac::Instant& from,
               const almanac::Instant& to);

/// Plot with a panel of magnitudes by band above one of illuminance; dashed lines show what the curve's place sees.
///
/// Given  place  of the curve, in words; empty if it has none
Plot plot_of(const LightCurve& curve, const eclipse::Eclipse& eclipse, const std::string& place);

}  // namespace coppermoon::uses
