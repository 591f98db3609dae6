// SPDX-License-Identifier: MIT
// Light across the umbra as a camera has it and as it is computed: tables in Markdown, magnitudes of
// observed less computed brightness, red and green of linear Rec.709.
#include <fmt/format.h>

#include <functional>

#include "tests/measurements/umbral_light.h"

using namespace coppermoon;
using namespace coppermoon::measurements;

namespace {

/// A way to choose the air, and what it is called.
struct Choice {
  std::string words;
  std::function<void(uses::Air&)> change;
};

const std::vector<Choice> choices{
    {"`undated`: the standard until version 0.1",
     [](uses::Air& air) { air.atmosphere = "undated"; }},
    {"`standard`", [](uses::Air&) {}},
    {"`calibrated`", [](uses::Air& air) { air.atmosphere = "calibrated"; }},
    {"ozone of US 1976, 345 DU (`--ozone-profile us-1976 --ozone-du 345`)",
     [](uses::Air& air) {
       air.ozone_profile = uses::OzoneProfile::us_1976;
       air.column.ozone_du = 345;
     }},
    {"density of US 1976 (`--density us-1976`)",
     [](uses::Air& air) { air.density = atmosphere::Density::us_1976; }},
    {"stratospheric aerosol of a quiet year (`--stratospheric-aerosol 0.0067`)",
     [](uses::Air& air) { air.column.stratosphere = 0.0067; }},
    {"the global mean of the month everywhere (`--stratospheric-aerosol 0.015`)",
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
