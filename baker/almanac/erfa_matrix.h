// SPDX-License-Identifier: MIT
#pragma once

#include <glm/mat3x3.hpp>

namespace coppermoon::almanac {

/// Converts an ERFA matrix, stored by rows, to a GLM matrix, stored by columns.
inline glm::dmat3 matrix_from_rows(const double r[3][3]) {
  return {r[0][0], r[1][0], r[2][0], r[0][1], r[1][1], r[2][1], r[0][2], r[1][2], r[2][2]};
}

}  // namespace coppermoon::almanac
