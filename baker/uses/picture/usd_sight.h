// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "texture/usd_text.h"
#include "uses/picture/baked_moon.h"
#include "uses/picture/view.h"

namespace coppermoon::uses {

/// Camera of a view and light of its Moon, for USD.
///
/// Given  space  of the light's colour
texture::UsdMoment usd_moment(const LitMoon& moon, const View& view, colour::WorkingSpace space);

/// Luminance of each channel of a space.
std::array<double, 3> luminance_of_channels(colour::WorkingSpace space);

}  // namespace coppermoon::uses
