// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <string>

#include "algebra/grid.h"
#include "texture/image.h"

namespace coppermoon::texture {

/// Raw numbers from a sensor under a mosaic of colour filters.
struct RawPhotograph {
  /// Raw numbers [DN], including the black level. Red and green alternate in even rows, green and blue in odd rows.
  algebra::Grid<std::uint16_t> numbers;
  double black_dn = 0, white_dn = 65535;  ///< raw numbers without light and at saturation
  glm::dmat3 camera_from_xyz{
      1};  ///< matrix from XYZ (D65 white: Y = 1) to raw numbers above black (1 at saturation)
  std::string camera;          ///< model name of the camera
  double focal_length_mm = 0;  ///< above 0
};

/// Writes a raw photograph to an uncompressed DNG file (1.4), whole or not at all. Raw converters read it like a file
/// from a camera. Its as-shot white balance is D65.
///
/// Given   attributes  `capDate`, `expTime`, `aperture` and `isoSpeed` are written as EXIF; others are left out
/// Throws  Error       when there are no pixels; when white is not above black, or either is outside 0 to 65535; when
///                     the matrix turns white into a channel that is not above 0; when the file cannot be written
/// Source  Adobe, Digital Negative (DNG) Specification 1.4.0.0 (2012); CIPA DC-008 (Exif 2.31)
void write_dng(const std::filesystem::path& path, const RawPhotograph& photograph,
               const Attributes& attributes = {});

}  // namespace coppermoon::texture
