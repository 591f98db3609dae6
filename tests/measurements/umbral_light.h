// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "algebra/error.h"
#include "algebra/table.h"
#include "almanac/sky.h"
#include "colour/cie_observer.h"
#include "colour/working_space.h"
#include "eclipse/shadow_axis.h"
#include "photons/solar_disc.h"
#include "uses/light/shadow_profile.h"

namespace coppermoon::measurements {

inline constexpr double km_of_an_arcmin = 60 / 990. * 1737.4;

/// A mean over places of one frame at one distance from the axis.
struct Seen {
  double arcmin, red, green;
};

using Frames = std::map<std::string, std::vector<Seen>>;  // by UTC

inline Frames frames_in(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw algebra::Error(path + ": cannot be read");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  Frames frames;
  const auto rows = algebra::parse_text_table(text);
  for (std::size_t r = 1; r < rows.size(); ++r)
    frames[rows[r][0]].push_back(
        {std::stod(rows[r][1]), std::stod(rows[r][2]), std::stod(rows[r][3])});
  return frames;
}

inline std::vector<double> middles(const std::vector<double>& edges) {
  std::vector<double> all;
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) all.push_back((edges[i] + edges[i + 1]) / 2);
  return all;
}

/// Irradiance over full sunlight in the channels of linear Rec.709, of light by band.
inline glm::dvec3 in_rec709(const std::vector<double>& edges_nm, std::span<const double> ratio) {
  const auto sunlight = photons::solar_irradiance(edges_nm);
  const auto weights = colour::xyz_weights(edges_nm);
  glm::dvec3 light(0), full(0);
  for (std::size_t b = 0; b < sunlight.size(); ++b)
    for (int k = 0; k < 3; ++k) {
      const double whole = weights(static_cast<std::size_t>(k), b) * sunlight[b];
      full[k] += whole;
      light[k] += whole * ratio[b];
    }
  const auto matrix = colour::channels_from_xyz(colour::WorkingSpace::linear_rec709);
  return (matrix * light) / (matrix * full);
}

/// Observed less computed, + where the photograph is brighter [mag].
inline std::vector<std::array<double, 2>> differences(const uses::Air& air, const std::string& utc,
                                                      const std::vector<Seen>& seen) {
  std::vector<double> edges;
  for (double edge = 385; edge <= 755; edge += 10) edges.push_back(edge);
  const uses::LightRequest request{.air = air};
  const auto sky = almanac::sky_at(almanac::instant_from_utc(utc));
  const auto centre = eclipse::place_in_shadow(eclipse::shadow_axis(sky), sky.moon_m);
  uses::ProfilePlaces places{.wavelengths_nm = middles(edges),
                             .position_angle_deg = algebra::in_degrees(centre.position_angle)};
  if (*places.position_angle_deg < 0) *places.position_angle_deg += 360;
  for (const auto& one : seen)
    places.axis_distances_m.push_back(one.arcmin * km_of_an_arcmin * 1e3);
  const auto profile =
      uses::shadow_profile(request, uses::shadow_at_the_moon(request, sky), places);
  std::vector<std::array<double, 2>> all;
  for (std::size_t d = 0; d < seen.size(); ++d) {
    const auto ours = in_rec709(edges, profile.ratio.row(d));
    all.push_back(
        {2.5 * std::log10(seen[d].red / ours.r), 2.5 * std::log10(seen[d].green / ours.g)});
  }
  return all;
}

}  // namespace coppermoon::measurements
