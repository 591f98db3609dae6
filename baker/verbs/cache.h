// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace coppermoon::verbs {

/// Size above which `bake --cache` removes the least recently used textures from the usual cache [GB]. It is the value
/// of the environment variable COPPERMOON_CACHE_LIMIT or, if that is not set, 20.
///
/// Throws  Error  if the variable is not a number of 0 or more
double cache_limit_gb();

/// The time one day ago. Textures used within the last day are kept even if the cache is too large, because an open
/// scene may still show them.
std::filesystem::file_time_type a_day_ago();

}  // namespace coppermoon::verbs
