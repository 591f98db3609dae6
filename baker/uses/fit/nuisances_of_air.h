// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "uses/fit/nuisance_table.h"

namespace coppermoon::uses {

/// Shares of the limb in each photograph's bins. Empty if weather is not an error of any photograph.
using Limbs = std::vector<algebra::Grid<double>>;
Limbs limbs_of(std::span<const Binned> photographs);

/// The nuisance "aerosol", with a parameter for each part of the limb: the month's aerosol differs from place to place.
Nuisance aerosol_of(std::span<const Binned> photographs, const NightErrors& night,
                    const NightRows& rows, const Limbs& limbs);

/// The nuisance "weather", with a parameter for each part of the limb, change in time, and kind of weather.
Nuisance weather_of(std::span<const Binned> photographs, const NightErrors& night,
                    const NightRows& rows, const Limbs& limbs);

}  // namespace coppermoon::uses
