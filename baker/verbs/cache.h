// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace coppermoon::verbs {

/// Size of the usual cache above which `bake --cache` removes what was used longest ago [GB]: that of the variable
/// COPPERMOON_CACHE_LIMIT, or 20.
///
/// Throws  Error  when the variable has no number of 0 or more
double cache_limit_gb();

/// Time since which a texture must have been used to stay in a cache that is too large: a scene that is open may show it.
std::filesystem::file_time_type a_day_ago();

}  // namespace coppermoon::verbs
