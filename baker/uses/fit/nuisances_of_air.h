// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "uses/fit/nuisance_table.h"

namespace coppermoon::uses {

/// Shares of light from each part of the limb, in each photograph's bins. Empty if weather_error is 0 for all.
using Limbs = std::vector<algebra::Grid<double>>;
Limbs limbs_of(std::span<const Binned> photographs);

/// The nuisance "aerosol", with a parameter for each part of the limb, because a month's aerosol varies along the limb.
Nuisance aerosol_of(std::span<const Binned> photographs, const NightErrors& night,
                    const NightRows& rows, const Limbs& limbs);

/// The nuisance "weather", with parameters for each part of the limb, each change in time, and each kind of weather.
Nuisance weather_of(std::span<const Binned> photographs, const NightErrors& night,
                    const NightRows& rows, const Limbs& limbs);

}  // namespace coppermoon::uses
