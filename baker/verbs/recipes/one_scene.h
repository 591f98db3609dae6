// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace coppermoon::verbs {

/// Refuses two photographs that do not show the same scene, judging by their headers: if they differ in size or
/// window, in colour space or units, by more than a minute in time, or if their recipes differ in more
/// than exposure, noise and development.
///
/// Throws  Error  with both names, and what differs
void require_one_scene(const std::string& first, const std::string& other);

}  // namespace coppermoon::verbs
