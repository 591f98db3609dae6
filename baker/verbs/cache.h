// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace coppermoon::verbs {

/// Size above which `bake --cache` removes the least recently used textures from the usual cache [GB]: the value of the
/// variable COPPERMOON_CACHE_LIMIT, or 20.
///
/// Throws  Error  if the variable is not a number of 0 or more
double cache_limit_gb();

/// Textures used after this time stay even in a cache that is too large, since an open scene may still show them.
std::filesystem::file_time_type a_day_ago();

}  // namespace coppermoon::verbs
