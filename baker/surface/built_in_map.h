// SPDX-License-Identifier: MIT
#pragma once

#include "algebra/grid.h"

namespace coppermoon::surface {

/// The Moon's normal albedo: a map of the near and the far side, which is part of the library.
///
/// Returned  up to a factor, 2048 x 4096, as albedo_map.h says; not yet normalised
/// Accuracy  5 % rms of the normal albedos of Sato et al. (2014), cell by cell of one degree on the near
///           side. Its storing adds 0.23 % rms: 0.14 % rms and 1.3 % at most within 64 degrees of latitude;
///           240 texels about the poles are cut, by up to 11 %
/// Source    NASA's CGI Moon Kit of 2019 (LRO; public domain) with its poles mended: see with_polar_contrast and
///           baker/surface/data/make_moon_albedo.py
algebra::Grid<float> built_in_map();

}  // namespace coppermoon::surface
