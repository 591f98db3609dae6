// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "algebra/error.h"

namespace coppermoon {

/// What the action's algebra::Error says; empty where it throws none.
template <class Action>
std::string refusal_of(const Action& action) {
  try {
    action();
  } catch (const algebra::Error& error) {
    return error.what();
  }
  return {};
}

}  // namespace coppermoon
