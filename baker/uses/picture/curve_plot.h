// SPDX-License-Identifier: MIT
#pragma once

#include "eclipse/contacts.h"
#include "uses/picture/brightness.h"
#include "uses/plot/plot.h"

namespace coppermoon::uses {

double hours_from_greatest(const eclipse::Eclipse& eclipse, const almanac::Instant& when);

/// Plot over hours from the greatest eclipse, with its contacts, still without panels.
Plot plot_over(const eclipse::Eclipse& eclipse, const almanac::Instant& from,
               const almanac::Instant& to);

/// Plot of magnitudes by band above illuminance; dashed what the place of the curve sees.
///
/// Given  place  of the curve, in words; empty without one
Plot plot_of(const LightCurve& curve, const eclipse::Eclipse& eclipse, const std::string& place);

}  // namespace coppermoon::uses
