// SPDX-License-Identifier: MIT
#pragma once

namespace coppermoon::algebra {

/// Named number of a result: a key of its JSON, a line of its table, a property in Python.
template <class Result>
struct Column {
  const char* name;  ///< ends in its unit: "altitude_deg"
  double (*value)(const Result&);
  const char* text;  ///< description for documentation
};

}  // namespace coppermoon::algebra
