// SPDX-License-Identifier: MIT
#pragma once

#include "texture/image.h"
#include "uses/compare/comparison.h"

namespace coppermoon::uses {

/// A picture of three panels side by side: a photograph, the render as that camera would have taken it, and how they differ:
/// red where the photograph is brighter, blue where it is darker, full at two stops; black where
/// either is dark.
///
/// Given     photo  that was compared, as it was read
/// Returned  sRGB-coded, 0 to 1: R, G, B; three squares of at most 640 pixels
texture::Image comparison_sheet(const texture::Image& photo, const Comparison& found);

}  // namespace coppermoon::uses
