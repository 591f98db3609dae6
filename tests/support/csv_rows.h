// SPDX-License-Identifier: MIT
// Tables that the program has written, read back.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace coppermoon {

inline std::vector<std::string> csv_cells(const std::string& line) {
  std::vector<std::string> cells(1);
  for (const char c : line)
    if (c == ',')
      cells.emplace_back();
    else
      cells.back() += c;
  return cells;
}

/// The rows below the head, each cell by its column's name. A row of more or fewer cells than the head
/// fails the test.
inline std::vector<std::map<std::string, std::string>> csv_rows(const std::string& csv) {
  std::istringstream text(csv);
  std::string line;
  std::getline(text, line);
  const auto names = csv_cells(line);
  std::vector<std::map<std::string, std::string>> rows;
  while (std::getline(text, line)) {
    const auto cells = csv_cells(line);
    EXPECT_EQ(cells.size(), names.size()) << line;
    auto& row = rows.emplace_back();
    for (std::size_t i = 0; i < std::min(cells.size(), names.size()); ++i) row[names[i]] = cells[i];
  }
  return rows;
}

}  // namespace coppermoon
