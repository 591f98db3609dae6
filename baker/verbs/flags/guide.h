// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace coppermoon::verbs {

/// What a newcomer to a verb needs first.
struct Guide {
  std::string_view verb;
  std::vector<std::string_view> common;    ///< its flags that --help lists, without dashes
  std::vector<std::string_view> examples;  ///< command lines
};

/// Verbs that do one kind of thing, as the program's help lists them.
struct GuideGroup {
  std::string_view heading;
  std::vector<Guide> guides;
};

/// Every verb once.
const std::vector<GuideGroup>& guides();

/// The guide of a verb; an empty one for a verb that has none.
const Guide& guide_to(std::string_view verb);

}  // namespace coppermoon::verbs
