// SPDX-License-Identifier: MIT
// Light across the umbra as a camera has it and as it is computed: tables in Markdown, magnitudes of
// observed less computed brightness, red and green of linear Rec.709.
#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <functional>
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

using namespace coppermoon;

namespace {

constexpr double km_of_an_arcmin = 60 / 990. * 1737.4;

/// A mean over places of one frame at one distance from the axis.
struct Seen {
  double arcmin, red, green;
};

using Frames = std::map<std::string, std::vector<Seen>>;  // by UTC

Frames frames_in(const std::string& path) {
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

std::vector<double> middles(const std::vector<double>& edges) {
  std::vector<double> all;
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) all.push_back((edges[i] + edges[i + 1]) / 2);
  return all;
}

/// Irradiance over full sunlight in the channels of linear Rec.709, of light by band.
glm::dvec3 in_rec709(const std::vector<double>& edges_nm, std::span<const double> ratio) {
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
std::vector<std::array<double, 2>> differences(const uses::Air& air, const std::string& utc,
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

/// A way to choose the air, and what it is called.
struct Choice {
  std::string words;
  std::function<void(uses::Air&)> change;
};

const std::vector<Choice> choices{
    {"`undated`: the standard until version 0.1",
     [](uses::Air& air) { air.atmosphere = "undated"; }},
    {"`standard`", [](uses::Air&) {}},
    {"ozone of US 1976, 345 DU (`--ozone-profile us-1976 --ozone-du 345`)",
     [](uses::Air& air) {
       air.ozone_profile = uses::OzoneProfile::us_1976;
       air.column.ozone_du = 345;
     }},
    {"density of US 1976 (`--density us-1976`)",
     [](uses::Air& air) { air.density = atmosphere::Density::us_1976; }},
    {"stratospheric aerosol of a quiet year (`--stratospheric-aerosol 0.0067`)",
     [](uses::Air& air) { air.column.stratosphere = 0.0067; }},
    {"half of what the eruption of January 2022 added (`--stratospheric-aerosol 0.015`)",
     [](uses::Air& air) { air.column.stratosphere = 0.015; }},
    {"cloud half as likely (`--cloud-chance 0.5`)",
     [](uses::Air& air) { air.column.cloud_chance = 0.5; }},
    {"cloud half as likely again (`--cloud-chance 1.5`)",
     [](uses::Air& air) { air.column.cloud_chance = 1.5; }},
    {"no thin cirrus (`--cirrus 0`)", [](uses::Air& air) { air.column.cirrus = 0; }},
    {"no aerosol of the free troposphere (`--free-troposphere 0`)",
     [](uses::Air& air) { air.column.free_troposphere = 0; }},
    {"no aerosol near the ground (`--tropospheric-aerosol 0`)",
     [](uses::Air& air) { air.column.tropospheric_optical_depth = 0; }},
    {"no pairs of oxygen (`--oxygen-pairs off`)", [](uses::Air& air) { air.oxygen_pairs = false; }},
    {"no nitrogen dioxide (`--nitrogen-dioxide off`)",
     [](uses::Air& air) { air.nitrogen_dioxide = false; }}};

uses::Air air_of(const Choice& choice) {
  uses::Air air;
  choice.change(air);
  return air;
}

std::string signed_text(double value) {
  return (value < 0 ? "−" : "+") + fmt::format("{:.2f}", std::abs(value));
}

void print_profile(const Frames& frames) {
  fmt::print(
      "| UTC | from the axis | red, `undated` | green | red, `standard` | green |\n"
      "| --- | ---: | ---: | ---: | ---: | ---: |\n");
  for (const auto& [utc, seen] : frames) {
    const auto before = differences(air_of(choices[0]), utc, seen),
               now = differences(air_of(choices[1]), utc, seen);
    for (std::size_t d = 0; d < seen.size(); ++d)
      fmt::print("| {} | {:g}' | {} | {} | {} | {} |\n", utc, seen[d].arcmin,
                 signed_text(before[d][0]), signed_text(before[d][1]), signed_text(now[d][0]),
                 signed_text(now[d][1]));
  }
}

void print_choices(const Frames& frames) {
  fmt::print(
      "| the air | red, rms | mean | about the mean | green, rms | mean | about the mean |\n"
      "| --- | ---: | ---: | ---: | ---: | ---: | ---: |\n");
  for (const auto& choice : choices) {
    std::array<double, 2> sum{}, squares{};
    double count = 0;
    for (const auto& [utc, seen] : frames)
      for (const auto& apart : differences(air_of(choice), utc, seen)) {
        for (std::size_t k = 0; k < 2; ++k) sum[k] += apart[k], squares[k] += apart[k] * apart[k];
        ++count;
      }
    fmt::print("| {} |", choice.words);
    for (std::size_t k = 0; k < 2; ++k) {
      const double mean = sum[k] / count, square = squares[k] / count;
      fmt::print(" {:.2f} | {} | {:.2f} |", std::sqrt(square), signed_text(mean),
                 std::sqrt(square - mean * mean));
    }
    fmt::print("\n");
  }
}

}  // namespace

int main(int count, char** words) {
  try {
    if (count != 3) throw algebra::Error("two words: umbra_profile.csv, and profile or choices");
    const auto frames = frames_in(words[1]);
    std::string(words[2]) == "profile" ? print_profile(frames) : print_choices(frames);
  } catch (const std::exception& error) {
    fmt::print(stderr, "umbra: {}\n", error.what());
    return 1;
  }
}
