// SPDX-License-Identifier: MIT
#pragma once

#include "algebra/grid.h"
#include "colour/photograph.h"
#include "colour/working_space.h"
#include "texture/image.h"
#include "uses/light/spectral_bands.h"

namespace coppermoon::uses {

/// Rounds a non-negative number to the nearest half float. Numbers above the largest half float are not changed.
float as_half(double value);

/// Throws  Error  when an image has fewer than three channels
void require_colours(const texture::Image& image);

/// The first three channels of an image.
///
/// Throws  Error  when it has fewer
colour::Image pixels_of(const texture::Image& image);

/// Converts a scene-linear image to another working space: channels R, G, B, or X, Y, Z. Its luminance does not change.
///
/// Throws  Error  when it has fewer than three channels
texture::Image in_space(const texture::Image& image, colour::WorkingSpace from,
                        colour::WorkingSpace to);

/// A single channel of an image.
algebra::Grid<float> channel_of(const texture::Image& image, std::size_t channel);

/// An image with all its rows in memory, computed a few rows at a time.
texture::Image image_of(const texture::Layout& layout, const texture::Rows& rows);

/// An image with channels R, G, B.
texture::Image image_of(const colour::Image& pixels);

/// An image with channels R, G, B from 16-bit numbers, with 65535 as 1.
texture::Image image_of(const algebra::Grid<colour::RawPixel>& raw);

/// An image with channels R, G, B, and `valid`, which is 1 if none of the three is clipped.
texture::Image image_of(const colour::Image& pixels, const algebra::Grid<float>& valid);

}  // namespace coppermoon::uses
