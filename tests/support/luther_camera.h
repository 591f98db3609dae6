// SPDX-License-Identifier: MIT
// A camera whose curves are combinations of the CIE 1931 observer's: it has to see as that observer.
#pragma once

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <string>

#include "algebra/table.h"

namespace coppermoon {

/// Contents of its .csv, every 1 nm from 380 to 780.
inline std::string luther_camera() {
  std::ifstream file(COPPERMOON_TEST_DATA "/../colour/data/cie_1931_observer.csv");
  const auto cie =
      algebra::parse_table(std::string(std::istreambuf_iterator<char>(file), {}), "observer");
  std::string text = "# Luther's condition\nwavelength_nm,r,g,b\n";
  for (std::size_t i = 20; i <= 420; ++i) {
    const double x = cie["x_bar"][i], y = cie["y_bar"][i], z = cie["z_bar"][i];
    text += fmt::format("{},{},{},{}\n", cie["wavelength_nm"][i], 0.3 * x + 0.1 * y,
                        0.05 * x + 2 * y + 0.1 * z, 0.01 * x + 0.1 * y + 7 * z);
  }
  return text;
}

}  // namespace coppermoon
