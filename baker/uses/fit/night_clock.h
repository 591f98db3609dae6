// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "uses/fit/compared_night.h"
#include "uses/fit/placing.h"

namespace coppermoon::uses {

/// Whether the clock of a night's photographs is looked for, beyond what light tells within a minute or so.
bool clock_is_free(const FitRequest& request);

/// Skies over the moments of a request's photographs, or over the whole eclipse where these are uncertain.
std::vector<almanac::SkyState> skies_of(const FitRequest& request);

/// Clock of a night's photographs, at which the shadow is where it is on six of them: in steps of half an hour where
/// half hours are free, then as scanned_clock. Where the clock is not free, or no photograph is registered: as it was
/// told.
///
/// Throws  Error  when half hours are free and none makes an eclipse of the instants
Clock scanned_clock(const Stage& stage, std::span<const Reading> readings);

}  // namespace coppermoon::uses
