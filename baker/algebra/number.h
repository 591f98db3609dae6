// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

namespace coppermoon::algebra {

/// The number that a text spells, as "1.5", "-2e-3" or "+20"; also "inf" and "nan", which ranges
/// refuse by name (require_within).
///
/// Returned  nothing when the text is anything else, or beyond what a double holds
std::optional<double> number_in(std::string_view text);

}  // namespace coppermoon::algebra
