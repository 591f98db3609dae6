// SPDX-License-Identifier: MIT
#include "result/as_json.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

namespace coppermoon::result {
namespace {

std::string text_of(const Json& value) {
  if (value.is_null()) return "";
  return value.is_string() ? value.get<std::string>() : value.dump();
}

/// Text of a CSV cell (RFC 4180). A cell with a comma, quote or line break is quoted, and quotes in it are doubled.
std::string cell(const Json& value) {
  auto text = text_of(value);
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

}  // namespace

std::string as_csv(const Json& rows) {
  std::string text;
  for (const auto& row : rows) {
    std::vector<std::string> names, cells;
    for (const auto& [name, value] : row.items()) {
      names.push_back(name);
      cells.push_back(cell(value));
    }
    if (text.empty()) text = fmt::format("{}\n", fmt::join(names, ","));
    text += fmt::format("{}\n", fmt::join(cells, ","));
  }
  return text;
}

std::string as_lines(const Json& object, const std::string& number) {
  std::string lines;
  for (const auto& [key, value] : object.items())
    lines += fmt::format("{:<30}{}\n", key,
                         value.is_number() ? fmt::format(fmt::runtime(number), value.get<double>())
                                           : text_of(value));
  return lines;
}

}  // namespace coppermoon::result
