// SPDX-License-Identifier: MIT
#include "uses/film/shadow_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec3.hpp>

#include "colour/cie_observer.h"
#include "colour/working_space.h"
#include "eclipse/shadow_cone.h"
#include "uses/picture/gnuplot.h"

namespace coppermoon::uses {
namespace {

constexpr double km = 1e3;

const char* terminal_for(const std::filesystem::path& picture) {
  const auto ending = picture.extension();
  if (ending == ".svg") return "svg size 1000,640 dynamic font 'Sans,14'";
  if (ending == ".pdf") return "pdfcairo size 25cm,16cm font 'Sans,14'";
  return "pngcairo size 1000,640 font 'Sans,12'";
}

/// Decades of the whole plot: from below the darkest light shown to full sunlight.
std::pair<double, double> range_of(const ShadowProfile& profile) {
  double darkest = 1;
  for (const double ratio : profile.ratio.values())
    if (ratio > 1e-12) darkest = std::min(darkest, ratio);
  return {std::pow(10, std::floor(std::log10(darkest))), 3};
}

std::string edge(const char* name, double radius_m) {
  return fmt::format(
      "set arrow from {0:.6g},graph 0 to {0:.6g},graph 1 nohead dashtype 2 linecolor rgb "
      "'#707070'\n"
      "set label '{1}' at {0:.6g},graph 0.12 rotate by 90 left offset -1,0 textcolor rgb "
      "'#505050'\n",
      radius_m / km, name);
}

std::string moon(double centre_m, double end_m) {
  const double radius_m = algebra::in_metres(almanac::lunar_radius);
  const double from = std::max(0., centre_m - radius_m) / km,
               to = std::min(end_m, centre_m + radius_m) / km;
  if (from >= to) return {};
  return fmt::format(
      "set object rectangle from {0:.6g},graph 0 to {1:.6g},graph 1 behind fillstyle solid "
      "noborder "
      "fillcolor rgb '#eeeae2'\n"
      "set label 'Moon' at {2:.6g},graph 0.03 center textcolor rgb '#505050'\n",
      from, to, (from + to) / 2);
}

std::string curves(const ShadowProfile& profile) {
  std::string data = "$light << EOD\n", plot;
  for (std::size_t d = 0; d < profile.axis_distances_m.size(); ++d) {
    data += fmt::format("{:g}", profile.axis_distances_m[d] / km);
    for (std::size_t w = 0; w < profile.wavelengths_nm.size(); ++w)
      data += fmt::format(" {:.6g}", profile.ratio(d, w));
    data += '\n';
  }
  for (std::size_t w = 0; w < profile.wavelengths_nm.size(); ++w)
    plot += fmt::format(
        "{} $light using 1:(${} > 0 ? ${} : NaN) with lines linewidth 2.5 linecolor rgb '{}' title "
        "'{:g} nm'",
        w == 0 ? "plot" : ",", w + 2, w + 2, plot_colour(profile.wavelengths_nm[w]),
        profile.wavelengths_nm[w]);
  return data + "EOD\n" + plot + '\n';
}

std::string script_for(const ShadowProfile& profile, const ShadowMarks& marks) {
  const auto [bottom, top] = range_of(profile);
  const double end_m = profile.axis_distances_m.back();
  std::string script = fmt::format(
      "set encoding utf8\nset title \"{}\" noenhanced\nset logscale y\nset format y '10^{{%L}}'\n"
      "set grid\nset key top left\nset xrange [0:{:.6g}]\nset yrange [{:g}:{:g}]\n"
      "set xlabel 'Distance from the middle of the shadow [km]'\n"
      "set ylabel 'Light, as a fraction of full sunlight'\n",
      marks.title, std::max(end_m, km) / km, bottom, top);
  if (marks.moon_m) script += moon(*marks.moon_m, end_m);
  if (marks.umbra_m > 0 && marks.umbra_m < end_m)
    script += edge("edge of the umbra", marks.umbra_m);
  if (marks.penumbra_m < end_m) script += edge("edge of the penumbra", marks.penumbra_m);
  return script + curves(profile);
}

double srgb(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

}  // namespace

std::string plot_colour(double wavelength_nm) {
  using enum colour::WorkingSpace;
  const auto weights = colour::xyz_weights(std::array{wavelength_nm - 0.5, wavelength_nm + 0.5});
  auto channels = colour::channels_from_xyz(linear_rec709) *
                  glm::dvec3(weights(0, 0), weights(1, 0), weights(2, 0));
  double most = 0;
  for (int c = 0; c < 3; ++c) most = std::max(most, channels[c] = std::max(0., channels[c]));
  channels /= most;
  constexpr double brightest = 0.25;  // whiter is hard to read on white: a contrast of 3.5 to 1
  const double luminance =
      colour::luminance(linear_rec709, std::array{channels.x, channels.y, channels.z});
  constexpr double well_seen = 0.1;  // of 555 nm: what the eye hardly sees is drawn darker
  const double efficiency = weights(1, 0) / colour::luminous_efficacy_lm_per_W;
  channels *=
      std::min(1., brightest / luminance) * std::pow(std::min(1., efficiency / well_seen), 0.2);
  const auto code = [](double linear) { return std::lround(255 * srgb(linear)); };
  return fmt::format("#{:02x}{:02x}{:02x}", code(channels.x), code(channels.y), code(channels.z));
}

ShadowMarks marks_of(const shadow::Arrangement& cut, const std::optional<almanac::SkyState>& sky,
                     std::string title) {
  auto axis = eclipse::ShadowAxis{glm::dmat3(1), algebra::metres(cut.sun_distance_m)};
  const eclipse::ShadowPlace on_axis{algebra::metres(0), algebra::radians(0),
                                     algebra::metres(cut.depths_m.front())};
  const auto radii = eclipse::shadow_radii(eclipse::ShadowConvention::danjon, axis, on_axis);
  const auto radius_m = [&](algebra::Angle seen) {
    return algebra::in_metres(eclipse::axis_distance_at(seen, on_axis));
  };
  ShadowMarks marks{std::move(title), radius_m(radii.umbra), radius_m(radii.penumbra)};
  if (sky)
    marks.moon_m = algebra::in_metres(
        eclipse::place_in_shadow(eclipse::shadow_axis(*sky), sky->moon_m).axis_distance);
  return marks;
}

void write_shadow_plot(const std::filesystem::path& picture, const ShadowProfile& profile,
                       const ShadowMarks& marks) {
  write_plot(picture, terminal_for(picture), script_for(profile, marks));
}

}  // namespace coppermoon::uses
