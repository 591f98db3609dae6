// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "algebra/column.h"
#include "almanac/observer.h"
#include "almanac/sky.h"

namespace coppermoon::eclipse {

/// Numbers of Sun, Moon and shadow at a moment.
const std::vector<algebra::Column<almanac::SkyState>>& sky_columns();

/// Numbers of the Moon as a place sees it.
const std::vector<algebra::Column<almanac::ObserverView>>& view_columns();

}  // namespace coppermoon::eclipse
