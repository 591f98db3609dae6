// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "uses/night/circumstances.h"

namespace coppermoon::uses {

/// Calendar file, RFC 5545 with times in UTC, of an eclipse and those of its contacts that a place sees. Events of the
/// same eclipse and place keep their UIDs, so that a later file replaces them; another place's events have others.
///
/// Given  place_name  "Honolulu", or coordinates
///        made        time of the file
std::string as_calendar(const Circumstances& night, const std::string& place_name,
                        const almanac::Instant& made);

}  // namespace coppermoon::uses
