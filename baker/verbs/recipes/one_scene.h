// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace coppermoon::verbs {

/// Refuses two photographs that are not of one scene, as far as their headers tell: of other sizes or
/// windows, more than a minute apart, in other spaces or units, or with recipes that differ in more
/// than exposure, noise and development.
///
/// Throws  Error  with both names, and what differs
void require_one_scene(const std::string& first, const std::string& other);

}  // namespace coppermoon::verbs
