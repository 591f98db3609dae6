// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace coppermoon::verbs {

/// What a verb that made a file has to say.
struct Report {
  std::string file, recipe;
  double seconds, relative_error;
};

/// On stdout: one line, or one JSON document with the keys file, chosen and reached.
void report(const Report& made, bool json);

}  // namespace coppermoon::verbs
