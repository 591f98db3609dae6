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
  /// [DN], black level included; red and green alternate in even rows, green and blue in odd ones
  algebra::Grid<std::uint16_t> numbers;
  double black_dn = 0, white_dn = 65535;  ///< without light; at saturation, black included
  glm::dmat3 camera_from_xyz{
      1};  ///< matrix from XYZ (white of D65 has Y = 1) to numbers above black, 1 at saturation
  std::string camera;          ///< its name
  double focal_length_mm = 0;  ///< more than 0
};

/// Writes a raw photograph to an uncompressed DNG file (1.4) that raw converters read like a camera's; whole or
/// not at all. Its as-shot white balance is D65.
///
/// Given   attributes  `capDate`, `expTime`, `aperture` and `isoSpeed` become EXIF's; others are left out
/// Throws  Error       when there are no pixels; when white is not above black, or either is outside 0 to 65535; when
///                     the matrix gives white a number not above 0; when the file cannot be written
/// Source  Adobe, Digital Negative (DNG) Specification 1.4.0.0 (2012); CIPA DC-008 (Exif 2.31)
void write_dng(const std::filesystem::path& path, const RawPhotograph& photograph,
               const Attributes& attributes = {});

}  // namespace coppermoon::texture
