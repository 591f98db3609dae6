// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace coppermoon::verbs {

/// What a new user of a command needs to know first.
struct Guide {
  std::string_view verb;
  std::vector<std::string_view> common;    ///< names of flags that --help lists, without dashes
  std::vector<std::string_view> examples;  ///< example command lines
};

/// A group of commands for one kind of task, under a heading in the program's help.
struct GuideGroup {
  std::string_view heading;
  std::vector<Guide> guides;
};

/// Guides to all commands, in groups. Each command appears once.
const std::vector<GuideGroup>& guides();

/// The guide to a command; if there is none, an empty guide.
const Guide& guide_to(std::string_view verb);

}  // namespace coppermoon::verbs
