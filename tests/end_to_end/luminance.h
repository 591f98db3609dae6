// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "colour/working_space.h"
#include "texture/image.h"

namespace coppermoon::end_to_end {

/// Luminance of a pixel in linear Rec.709, in its own unit.
inline double luminance(const texture::Image& image, std::size_t row, std::size_t column) {
  const std::array<double, 3> rgb{image(row, column, 0), image(row, column, 1),
                                  image(row, column, 2)};
  return colour::luminance(colour::WorkingSpace::linear_rec709, rgb);
}

}  // namespace coppermoon::end_to_end
