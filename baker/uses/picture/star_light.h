// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "algebra/grid.h"
#include "algebra/quantity.h"
#include "atmosphere/observer_air.h"

namespace coppermoon::uses {

/// Temperature of a black body of a star's colour [K].
///
///     4600 (1 / (0.92 (B − V) + 1.7) + 1 / (0.92 (B − V) + 0.62))
///
/// Given   b_minus_v  −0.5 to 4, held at either end
/// Source  Ballesteros (2012), EPL 97, 34008, equation 14
double star_temperature_k(double b_minus_v);

/// Light of stars above an observer's air, or through it.
class StarLights {
 public:
  /// Given  air       none: above the air
  ///        response  as in colour::channel_weights
  explicit StarLights(const std::optional<atmosphere::ObserverAir>& air = {},
                      const std::string& response = {});

  /// Light of a star on a surface that faces it: linear Rec.709 [lux].
  ///
  /// It has the spectrum of a black body, and as much of it as the V magnitude says, by the Sun's (see
  /// photometric_bands): a white star of V = 0 gives 2.6e-6 lux.
  ///
  /// Given     altitude  without refraction; as transmittance_above has it
  /// Accuracy  0.02 magnitude of luminance; colours as far as stars are black bodies
  std::array<double, 3> lux(double magnitude, double b_minus_v,
                            algebra::Angle altitude = algebra::degrees(90)) const;

 private:
  algebra::Grid<double> channels_;                  ///< weights, [channel][band]
  std::vector<atmosphere::VerticalDepths> depths_;  ///< [band]; empty: above the air
};

}  // namespace coppermoon::uses
