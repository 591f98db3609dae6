// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "eclipse/shadow_axis.h"
#include "shadow/irradiance.h"
#include "shadow/lookup.h"

namespace coppermoon::uses {

/// Refracted light at any place, by wavelength: linear between planes, cubic between sectors.
class RefractedAt {
 public:
  /// Given  light  in all sectors, or in those of the places and one more at either end; outlives this
  explicit RefractedAt(const shadow::RefractedLight& light);

  /// Writes the ratio to unshadowed sunlight at each wavelength.
  void read(const eclipse::ShadowPlace& place, std::span<double> ratios);

 private:
  const shadow::RefractedLight& light_;
  shadow::BetweenPlaces between_places_;
  std::vector<double> some_;
};

}  // namespace coppermoon::uses
