// SPDX-License-Identifier: MIT
#pragma once

#include "algebra/grid.h"
#include "colour/photograph.h"
#include "colour/working_space.h"
#include "texture/image.h"
#include "uses/light/spectral_bands.h"

namespace coppermoon::uses {

/// The first three channels.
///
/// Throws  Error  when there are fewer
colour::Image pixels_of(const texture::Image& image);

/// One channel alone.
algebra::Grid<float> channel_of(const texture::Image& image, std::size_t channel);

/// Channels R, G, B.
texture::Image image_of(const colour::Image& pixels);

/// Channels R, G, B of numbers of 16 bits: 65535 as 1.
texture::Image image_of(const algebra::Grid<colour::RawPixel>& raw);

/// Channels R, G, B, and `valid`: 1 where none is clipped.
texture::Image image_of(const colour::Image& pixels, const algebra::Grid<float>& valid);

}  // namespace coppermoon::uses
