// SPDX-License-Identifier: MIT
#pragma once

#include "texture/image.h"
#include "uses/compare/comparison.h"

namespace coppermoon::uses {

/// Draws a sheet of three panels side by side: the photograph, the render at the photograph's exposure, and their
/// difference. The difference is red where the photograph is brighter than the render, blue where it is darker, and
/// black where either picture is dark. Its colours are saturated at two stops.
///
/// Given     photo  the photograph from which `found` was computed
/// Returned  sRGB-coded R, G, B from 0 to 1; each panel is at most 640 pixels wide and high
texture::Image comparison_sheet(const texture::Image& photo, const Comparison& found);

}  // namespace coppermoon::uses
