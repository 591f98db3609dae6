// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

namespace coppermoon::algebra {

/// The number that a text spells, as "1.5", "-2e-3" or "+20".
///
/// Returned  nothing when the text is anything else, "inf" and "nan" included
std::optional<double> number_in(std::string_view text);

}  // namespace coppermoon::algebra
