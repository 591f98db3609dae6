// SPDX-License-Identifier: MIT
#pragma once

#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "algebra/error.h"
#include "algebra/table.h"

/// One line of a table of published figures; cells by the names of their columns.
using PublishedRow = std::map<std::string, std::string>;

/// A table that lies under tests/, dates and names among its cells.
inline std::vector<PublishedRow> published_rows(const std::string& path) {
  std::ifstream file(COPPERMOON_TEST_DATA "/" + path);
  if (!file) throw coppermoon::algebra::Error("cannot read tests/" + path);
  const std::string text(std::istreambuf_iterator<char>(file), {});
  const auto lines = coppermoon::algebra::parse_text_table(text);
  std::vector<PublishedRow> rows;
  for (std::size_t r = 1; r < lines.size(); ++r) {
    PublishedRow& row = rows.emplace_back();
    for (std::size_t c = 0; c < lines[r].size(); ++c) row[lines[0][c]] = lines[r][c];
  }
  return rows;
}

inline double number(const PublishedRow& row, const std::string& column) {
  return std::stod(row.at(column));
}
