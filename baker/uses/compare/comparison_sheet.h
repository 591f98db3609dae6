// SPDX-License-Identifier: MIT
#pragma once

#include "texture/image.h"
#include "uses/compare/comparison.h"

namespace coppermoon::uses {

/// Draws a sheet of three panels side by side: the photograph, the render at the photograph's exposure, and their
/// difference. It is red where the photograph is brighter, blue where it is darker, saturated at two stops, and black
/// where either is dark.
///
/// Given     photo  as it was read and compared
/// Returned  sRGB-coded, 0 to 1: R, G, B; three squares of at most 640 pixels
texture::Image comparison_sheet(const texture::Image& photo, const Comparison& found);

}  // namespace coppermoon::uses
