// SPDX-License-Identifier: MIT
#pragma once

namespace coppermoon::algebra {

/// A number of a result by name: a key of its JSON, a line of its table, a property in Python.
template <class Result>
struct Column {
  const char* name;  ///< ends in its unit: "altitude_deg"
  double (*value)(const Result&);
  const char* text;  ///< for whoever reads about it
};

}  // namespace coppermoon::algebra
