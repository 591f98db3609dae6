// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace coppermoon::verbs {

/// Checks by their headers that two photographs show the same scene. They must have the same size, window, colour space
/// and unit. Their times may differ by a minute at most, and their recipes only in exposure, noise and development.
///
/// Throws  Error  with the names of both files and what differs, if they do not show the same scene
void require_one_scene(const std::string& first, const std::string& other);

}  // namespace coppermoon::verbs
