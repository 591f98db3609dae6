// SPDX-License-Identifier: MIT
// How much a term of the physics changes: one row of a Markdown table, of two shadows
// (`coppermoon shadow --json`) and two pictures (`coppermoon still`), the standard's first. A dash
// stands for shadows that are not there.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>
#include <string>
#include <vector>

#include "algebra/error.h"
#include "colour/cie_observer.h"
#include "colour/difference.h"
#include "photons/solar_disc.h"
#include "texture/read_image.h"

using namespace coppermoon;

namespace {

/// Bands about the wavelengths, the first and the last cut in half.
std::vector<double> edges_about(const std::vector<double>& wavelengths_nm) {
  std::vector<double> edges{wavelengths_nm.front()};
  for (std::size_t i = 1; i < wavelengths_nm.size(); ++i)
    edges.push_back((wavelengths_nm[i - 1] + wavelengths_nm[i]) / 2);
  edges.push_back(wavelengths_nm.back());
  return edges;
}

/// What neutral ground in that light shows: CIE Y, the luminance, and Z, all but blind to red.
struct Shown {
  double luminance, blue;
};

Shown shown(const std::vector<double>& ratio, const std::vector<double>& edges_nm) {
  const auto sunlight = photons::solar_irradiance(edges_nm);
  const auto weights = colour::xyz_weights(edges_nm);
  Shown sum{};
  for (std::size_t band = 0; band < sunlight.size(); ++band) {
    sum.luminance += weights(1, band) * sunlight[band] * ratio[band];
    sum.blue += weights(2, band) * sunlight[band] * ratio[band];
  }
  return sum;
}

/// One for each place.
std::vector<Shown> shown_across(const std::string& shadow_json) {
  std::ifstream file(shadow_json);
  if (!file) throw algebra::Error(shadow_json + ": cannot be read");
  const auto shadow = nlohmann::json::parse(file);
  const auto edges = edges_about(shadow["wavelengths_nm"].get<std::vector<double>>());
  std::vector<Shown> across;
  for (const auto& ratio : shadow["irradiance_ratio"])
    across.push_back(shown(ratio.get<std::vector<double>>(), edges));
  return across;
}

std::string stops(double standard, double changed) {
  if (changed == 0) return "−∞";
  const double size = std::log2(changed / standard);
  if (std::abs(size) < 5e-4) return "0.000";
  return (size < 0 ? "−" : "+") + fmt::format("{:.3f}", std::abs(size));
}

std::string shadow_cells(const std::string& standard_json, const std::string& changed_json) {
  if (standard_json == "-") return " | | | | | |";
  const auto standard = shown_across(standard_json), changed = shown_across(changed_json);
  std::string cells;
  for (std::size_t place = 0; place < standard.size(); ++place)
    cells += fmt::format(" {} | {} |", stops(standard[place].luminance, changed[place].luminance),
                         stops(standard[place].blue, changed[place].blue));
  return cells;
}

colour::Rgb pixel(const texture::Image& image, std::size_t row, std::size_t column) {
  return {image(row, column, 0), image(row, column, 1), image(row, column, 2)};
}

/// Differences of all pixels that either picture has lit, increasing.
std::vector<double> differences(const texture::Image& standard, const texture::Image& changed) {
  if (standard.width != changed.width || standard.height != changed.height)
    throw algebra::Error("the two pictures differ in size");
  std::vector<double> sizes;
  for (std::size_t r = 0; r < standard.height; ++r)
    for (std::size_t c = 0; c < standard.width; ++c) {
      const auto one = pixel(standard, r, c), other = pixel(changed, r, c);
      if (one != colour::Rgb{} || other != colour::Rgb{})
        sizes.push_back(
            colour::delta_e_2000(colour::lab_from_srgb(one), colour::lab_from_srgb(other)));
    }
  std::ranges::sort(sizes);
  return sizes;
}

std::string picture_cells(const std::string& standard_png, const std::string& changed_png) {
  const auto sizes =
      differences(texture::read_image(standard_png), texture::read_image(changed_png));
  if (sizes.empty()) throw algebra::Error(standard_png + ": nothing is lit");
  const double mean =
      std::accumulate(sizes.begin(), sizes.end(), 0.) / static_cast<double>(sizes.size());
  return fmt::format(" {:.2f} | {:.2f} |", mean, sizes[sizes.size() * 99 / 100]);
}

}  // namespace

int main(int count, char** words) {
  if (count != 6) {
    fmt::print(stderr, "term_sizes: five words, TERM SHADOW SHADOW PICTURE PICTURE\n");
    return 2;
  }
  try {
    fmt::print("| {} |{}{}\n", words[1], shadow_cells(words[2], words[3]),
               picture_cells(words[4], words[5]));
  } catch (const std::exception& error) {
    fmt::print(stderr, "term_sizes: {}\n", error.what());
    return 1;
  }
}
