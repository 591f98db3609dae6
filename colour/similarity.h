// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>

#include "algebra/grid.h"

namespace coppermoon::colour {

/// Transform that maps one picture to another: optional mirroring, rotation, scale and shift.
///
///     X = scale (c m x − s y) + x_px,  Y = scale (s m x + c y) + y_px
///
/// Here c and s are the cosine and sine of the rotation, and m is −1 when mirrored, else 1. Pixels are counted from the
/// upper left corner, with y down and the first pixel's centre at (0.5, 0.5), so positive rotations are clockwise.
struct Similarity {
  double scale = 1, rotation_rad = 0;
  double x_px = 0, y_px = 0;  ///< where the upper left corner ends up
  bool mirrored = false;      ///< whether left and right are swapped first
};

/// Where a point of the first picture lies in the other.
glm::dvec2 moved(const Similarity& similarity, const glm::dvec2& pixel);

/// The inverse similarity.
///
/// Given  similarity  with a scale other than 0
Similarity inverse(const Similarity& similarity);

/// The similarity that applies `first`, then `second`.
Similarity composed(const Similarity& first, const Similarity& second);

/// A picture resampled to the pixels of another: interpolated bilinearly between pixel centres, or averaged over each
/// pixel when it is scaled down.
class Resampled {
 public:
  /// Given   image       must outlive this object
  ///         similarity  from the image to the other picture; scale above 0
  /// Throws  Error       when the scale is outside 1e-4 to 1e4
  Resampled(const algebra::Grid<float>& image, const Similarity& similarity);

  /// The image's value at a pixel of the other picture; 0 if the image does not reach that far.
  float at(std::size_t row, std::size_t column) const;

 private:
  const algebra::Grid<float>* image_;
  glm::dvec2 corner_, across_, down_;
  int side_;  ///< samples along one side of a pixel
};

/// Resamples an image to all pixels of another picture.
///
/// Returned  grid of rows × columns. An image of ones gives the share of each pixel that the image covers
/// Throws    Error  as for Resampled
algebra::Grid<float> resampled(const algebra::Grid<float>& image, const Similarity& similarity,
                               std::size_t rows, std::size_t columns);

/// Noise of a mean over many pixels of a resampled picture: the variance of the mean times the number of pixels,
/// divided by the variance of one pixel. The latter is taken as half the mean square difference between pixels two
/// apart in a row.
///
/// The image is assumed to result from bilinear interpolation between a sensor's pixels, either in demosaicing or in a
/// rotation. If the image's pixels are independent instead, the result is too large by a factor of up to two.
///
/// Given     scale  number of image pixels along one side of a pixel of the other picture, 1e-4 to 1e4
/// Accuracy  6 % for scales of 1 or more, averaged over the positions of pixels; also for a rotated picture
/// Throws    Error  when the scale is out of range
double noise_of_means(double scale);

/// The image's value at a point, interpolated bilinearly between pixel centres; 0 outside.
double between_pixels(const algebra::Grid<float>& image, const glm::dvec2& pixel);

}  // namespace coppermoon::colour
