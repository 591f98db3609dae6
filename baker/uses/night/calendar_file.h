// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "uses/night/circumstances.h"

namespace coppermoon::uses {

/// The eclipse and each of its contacts that is seen, as events of a calendar: RFC 5545, times in UTC, so
/// that each calendar shows its own. The same night gives the same bytes.
///
/// Given  place_name  "Honolulu", or coordinates
std::string as_calendar(const Circumstances& night, const std::string& place_name);

}  // namespace coppermoon::uses
