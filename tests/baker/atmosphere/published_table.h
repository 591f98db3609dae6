// SPDX-License-Identifier: MIT
#pragma once

#include <fstream>
#include <iterator>
#include <string>

#include "algebra/error.h"
#include "algebra/table.h"

/// A table of published figures that lies under tests/.
inline coppermoon::algebra::Table published_table(const std::string& path) {
  std::ifstream file(COPPERMOON_TEST_DATA "/" + path);
  if (!file) throw coppermoon::algebra::Error("cannot read tests/" + path);
  const std::string text(std::istreambuf_iterator<char>(file), {});
  return coppermoon::algebra::parse_table(text, path);
}
