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

/// Counts of a sensor under a mosaic of colour filters.
struct RawPhotograph {
  /// [DN], black level included; even rows are red and green in turn, odd ones green and blue
  algebra::Grid<std::uint16_t> numbers;
  double black_dn = 0, white_dn = 65535;  ///< of no light; of saturation, black included
  glm::dmat3 camera_from_xyz{
      1};  ///< matrix from XYZ (white of D65 has Y = 1) to numbers above black, 1 at saturation
  std::string camera;          ///< its name
  double focal_length_mm = 0;  ///< more than 0
};

/// Writes a raw photograph to a DNG file (1.4), not compressed, as raw converters read a camera's; whole or
/// not at all. Its as-shot white balance is D65's.
///
/// Given   attributes  `capDate`, `expTime`, `aperture` and `isoSpeed` become EXIF's; others are left out
/// Throws  Error       without a pixel; when white is not above black, both within 0 to 65535; a matrix that
///                     gives white no number above 0; a file that cannot be written
/// Source  Adobe, Digital Negative (DNG) Specification 1.4.0.0 (2012); CIPA DC-008 (Exif 2.31)
void write_dng(const std::filesystem::path& path, const RawPhotograph& photograph,
               const Attributes& attributes = {});

}  // namespace coppermoon::texture
