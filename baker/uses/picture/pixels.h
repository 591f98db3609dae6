// SPDX-License-Identifier: MIT
#pragma once

#include "algebra/grid.h"
#include "colour/photograph.h"
#include "colour/working_space.h"
#include "texture/image.h"
#include "uses/light/spectral_bands.h"

namespace coppermoon::uses {

/// The nearest half float, of a number that is not below 0; itself beyond the last one.
float as_half(double value);

/// Throws  Error  when an image has fewer than three channels
void require_colours(const texture::Image& image);

/// The first three channels.
///
/// Throws  Error  when there are fewer
colour::Image pixels_of(const texture::Image& image);

/// A scene-linear image's colours in another working space, luminance kept: channels R, G, B, or X, Y, Z.
///
/// Throws  Error  when it has fewer than three channels
texture::Image in_space(const texture::Image& image, colour::WorkingSpace from,
                        colour::WorkingSpace to);

/// One channel alone.
algebra::Grid<float> channel_of(const texture::Image& image, std::size_t channel);

/// Image with all its rows in memory, made some at a time.
texture::Image image_of(const texture::Layout& layout, const texture::Rows& rows);

/// Channels R, G, B.
texture::Image image_of(const colour::Image& pixels);

/// Channels R, G, B of numbers of 16 bits: 65535 as 1.
texture::Image image_of(const algebra::Grid<colour::RawPixel>& raw);

/// Channels R, G, B, and `valid`: 1 where none is clipped.
texture::Image image_of(const colour::Image& pixels, const algebra::Grid<float>& valid);

}  // namespace coppermoon::uses
