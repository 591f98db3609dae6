// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace coppermoon::verbs {

/// Numbers with commas between, as "450,550.5": an empty list for an empty text, nothing when a part
/// is no number.
std::optional<std::vector<double>> number_list(const std::string& text);

}  // namespace coppermoon::verbs
