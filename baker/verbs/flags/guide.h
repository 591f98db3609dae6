// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace coppermoon::verbs {

/// What a newcomer to a command needs first.
struct Guide {
  std::string_view verb;
  std::vector<std::string_view> common;    ///< flags that --help lists, without dashes
  std::vector<std::string_view> examples;  ///< command lines
};

/// Commands for one kind of task, as the program's help lists them.
struct GuideGroup {
  std::string_view heading;
  std::vector<Guide> guides;
};

/// Guides to all commands, each command once.
const std::vector<GuideGroup>& guides();

/// The guide to a command; empty if the command has none.
const Guide& guide_to(std::string_view verb);

}  // namespace coppermoon::verbs
