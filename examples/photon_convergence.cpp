// SPDX-License-Identifier: MIT
// How exact so many photons are: a table of the number of photons, and the root mean square of
// their relative error against the quadrature, at 550 nm over eight rings of 1000 km.
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <vector>

#include "shadow/by_photons.h"
#include "shadow/by_quadrature.h"

using namespace coppermoon;

int main(int count, char** words) {
  const double most = count > 1 ? std::atof(words[1]) : 1e6;
  const shadow::Arrangement february_2008{1.479e11, {3.83e8}};
  const std::vector<double> wavelength{550};
  shadow::PhotonSettings settings;
  settings.ring_width_m = 1000e3;

  fmt::print("photons,relative_error,standard_error\n");
  for (double photons = 1e3; photons < 1.1 * most; photons *= std::sqrt(10.)) {
    double squares = 0, variances = 0;
    int terms = 0;
    for (settings.seed = 1; settings.seed <= 4; ++settings.seed) {
      settings.photons = static_cast<std::uint64_t>(photons);
      const auto light = shadow::by_photons({}, february_2008, wavelength, settings);
      for (std::size_t ring = 0; ring < 8; ++ring, ++terms) {
        // the quadrature's mean over the ring
        std::vector<double> places;
        for (int k = 0; k < 8; ++k)
          places.push_back((static_cast<double>(ring) + (k + 0.5) / 8) * 1000e3);
        const auto exact = shadow::by_quadrature({}, february_2008, wavelength, places);
        double sum = 0, area = 0;
        for (std::size_t k = 0; k < 8; ++k) {
          sum += places[k] * exact.ratio[0](k, 0);
          area += places[k];
        }
        squares += std::pow(light.ratio[0](ring, 0) * area / sum - 1, 2);
        variances += std::pow(light.standard_error[0](ring, 0) * area / sum, 2);
      }
    }
    fmt::print("{:.0f},{:.4g},{:.4g}\n", photons, std::sqrt(squares / terms),
               std::sqrt(variances / terms));
  }
}
