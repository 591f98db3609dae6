// SPDX-License-Identifier: MIT
#pragma once

#include "algebra/grid.h"

namespace coppermoon::surface {

/// Normal albedo of the whole Moon, from a map that is part of the library.
///
/// Returned  2048 x 4096 texels, laid out as in albedo_map.h; not normalised, so known only up to a constant factor
/// Accuracy  5 % rms compared with the normal albedos of Sato et al. (2014), in cells of one degree on the near side.
///           Compression adds 0.23 % rms over the whole map; within 64 degrees of latitude it adds 0.14 % rms, 1.3 % at
///           most. 240 texels around the poles are clipped, by up to 11 %
/// Source    NASA's CGI Moon Kit of 2019 (LRO; public domain), with its poles corrected (see with_polar_contrast) by
///           baker/surface/data/make_moon_albedo.py
algebra::Grid<float> built_in_map();

}  // namespace coppermoon::surface
