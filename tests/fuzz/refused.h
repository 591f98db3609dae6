// SPDX-License-Identifier: MIT
// What a fuzzer takes for an answer: the work done, or an Error. Anything else is a finding.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string_view>

#include "algebra/error.h"

namespace coppermoon::fuzz {

inline void require(bool holds) {
  if (!holds) std::abort();
}

inline std::string_view as_text(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// Returned  whether it was done; else it was refused, with a reason
template <class Action>
bool done(const Action& action) {
  try {
    action();
    return true;
  } catch (const algebra::Error& error) {
    require(std::strlen(error.what()) > 0);
  }
  return false;
}

}  // namespace coppermoon::fuzz
