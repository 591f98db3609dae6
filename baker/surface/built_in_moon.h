// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "algebra/grid.h"

namespace coppermoon::surface {

/// A recognisable Moon at any size, for when no map is at hand: the maria and their coasts, the
/// bright craters and their rays, on highlands strewn with old craters.
///
/// Ellipses of the project's table, seen through noise that bends their outlines, are painted one
/// over the other; then come scattered old craters, then the ray craters. All of it is a function
/// of the place on the sphere: no seam at longitude 180, no pinch at the poles, the same at every
/// size but for detail finer than a texel.
///
/// Given     rows    8 to 32768
/// Returned  normal albedo, rows × 2 rows, as albedo_map.h says; not yet normalised. The same for
///           any number of threads
/// Accuracy  places to about a degree; albedos of single places to a third
/// Throws    Error   when rows is outside its range
/// Source    baker/surface/data/moon_features.csv
algebra::Grid<float> built_in_moon(std::size_t rows);

}  // namespace coppermoon::surface
