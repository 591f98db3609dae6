// SPDX-License-Identifier: MIT
#pragma once

#include "algebra/grid.h"
#include "colour/photograph.h"
#include "colour/working_space.h"
#include "texture/image.h"

namespace coppermoon::verbs {

/// Space of frames, strips and sheets: what POV-Ray and shaders take values for.
constexpr auto picture_space = colour::WorkingSpace::linear_rec709;

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

}  // namespace coppermoon::verbs
