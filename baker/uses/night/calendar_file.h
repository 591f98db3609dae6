// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "uses/night/circumstances.h"

namespace coppermoon::uses {

/// The eclipse and each of its contacts that is seen, as events of a calendar: RFC 5545, times in UTC, so
/// that each calendar shows its own. Another place's events have other names (UID): a calendar keeps both.
/// A file of the same place that is made later replaces the events of the earlier one.
///
/// Given  place_name  "Honolulu", or coordinates
///        made        when the file is made
std::string as_calendar(const Circumstances& night, const std::string& place_name,
                        const almanac::Instant& made);

}  // namespace coppermoon::uses
