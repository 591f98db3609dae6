// SPDX-License-Identifier: MIT
// How exact so many photons are: a table of the number of photons, and the root mean square of
// their relative error against the quadrature, at 550 nm over eight rings of 1000 km; traced step by
// step, and, a hundred times as many, by the table.
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <vector>

#include "shadow/by_photons.h"
#include "shadow/by_quadrature.h"

using namespace coppermoon;

namespace {

const shadow::Arrangement february_2008{1.479e11, {3.83e8}};
const std::vector<double> wavelength{550};
constexpr double ring_m = 1000e3;
constexpr std::size_t rings = 8;

/// The quadrature's mean over each ring.
std::vector<double> exact_means() {
  constexpr std::size_t places = 512;  // of a ring: 1e-5, where the light has kinks
  std::vector<double> distances, means;
  for (std::size_t i = 0; i < rings * places; ++i)
    distances.push_back((static_cast<double>(i) + 0.5) / places * ring_m);
  const auto exact =
      shadow::by_quadrature({}, february_2008, wavelength, distances, {.rays = 3000});
  for (std::size_t ring = 0; ring < rings; ++ring) {
    double sum = 0, area = 0;
    for (std::size_t i = ring * places; i < (ring + 1) * places; ++i) {
      sum += distances[i] * exact.ratio[0](i, 0);
      area += distances[i];
    }
    means.push_back(sum / area);
  }
  return means;
}

void print_errors(bool literal, double photons, const std::vector<double>& exact) {
  shadow::PhotonSettings settings;
  settings.photons = static_cast<std::uint64_t>(photons);
  settings.literal = literal;
  settings.ring_width_m = ring_m;
  settings.rays = 3000;  // of the table, as of the quadrature
  double squares = 0, variances = 0, traced = 0;
  constexpr std::uint64_t seeds = 4;
  for (settings.seed = 1; settings.seed <= seeds; ++settings.seed) {
    const auto sums = shadow::traced({}, february_2008, wavelength, settings);
    const auto light = shadow::means_over_rings(sums);
    traced = static_cast<double>(light.photons);
    for (std::size_t ring = 0; ring < rings; ++ring) {
      squares += std::pow(light.ratio[0](ring, 0) / exact[ring] - 1, 2);
      variances += std::pow(light.standard_error[0](ring, 0) / exact[ring], 2);
    }
  }
  fmt::print("{},{:.0f},{:.4g},{:.4g}\n", literal ? "literal" : "table", traced,
             std::sqrt(squares / (seeds * rings)), std::sqrt(variances / (seeds * rings)));
}

}  // namespace

int main(int count, char** words) {
  const double most = count > 1 ? std::atof(words[1]) : 1e6;
  const auto exact = exact_means();
  fmt::print("solver,photons,relative_error,standard_error\n");
  for (const bool literal : {true, false})
    for (double photons = 1e4; photons < 1.1 * most * (literal ? 1 : 100);
         photons *= std::sqrt(10.))
      print_errors(literal, photons, exact);
}
