// SPDX-License-Identifier: MIT
#pragma once

#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "algebra/interpolation.h"
#include "algebra/table.h"

namespace coppermoon {

/// A tone curve as it was measured.
struct MeasuredToneCurve {
  std::vector<double> scene, displayed;  ///< light: 1 saturates the sensor; of the JPEG, by sRGB

  /// Displayed light of a scene's, between the points that were measured.
  algebra::MonotoneCubic smooth() const { return {scene, displayed}; }
};

/// Tone curves of five cameras, by name: tests/colour/data/camera_tone_curves.csv.
inline std::map<std::string, MeasuredToneCurve> measured_tone_curves() {
  std::ifstream file(COPPERMOON_TEST_DATA "/colour/data/camera_tone_curves.csv");
  const auto rows = algebra::parse_text_table(
      std::string(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()));
  std::map<std::string, MeasuredToneCurve> curves;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    curves[rows[i][0]].scene.push_back(std::stod(rows[i][1]));
    curves[rows[i][0]].displayed.push_back(std::stod(rows[i][2]));
  }
  return curves;
}

}  // namespace coppermoon
