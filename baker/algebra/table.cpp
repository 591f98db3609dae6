// SPDX-License-Identifier: MIT
#include "algebra/table.h"

#include "algebra/error.h"
#include "algebra/number.h"

namespace coppermoon::algebra {
namespace {

struct Line {
  int number;
  std::vector<std::string> cells;
};

std::vector<std::string> cells_of(std::string_view line) {
  std::vector<std::string> cells;
  for (;;) {
    const auto comma = line.find(',');
    cells.emplace_back(line.substr(0, comma));
    if (comma == std::string_view::npos) return cells;
    line.remove_prefix(comma + 1);
  }
}

std::vector<Line> lines_of(std::string_view text) {
  std::vector<Line> lines;
  for (int number = 1; !text.empty(); ++number) {
    const auto end = text.find('\n');
    auto line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (!line.empty() && line.front() != '#') lines.push_back({number, cells_of(line)});
  }
  return lines;
}

}  // namespace

const std::vector<double>& Table::operator[](std::string_view column) const {
  const auto found = columns.find(column);
  if (found == columns.end()) throw Error(fmt::format("table has no column {}", column));
  return found->second;
}

std::string_view utf8_text(std::string_view bytes, std::string_view name) {
  using namespace std::string_view_literals;
  const auto begin = bytes.substr(0, 2);
  if (begin == "\xFF\xFE"sv || begin == "\xFE\xFF"sv || begin.find('\0') != begin.npos)
    throw Error(fmt::format("{}: text in UTF-16, allowed UTF-8", name));
  if (constexpr auto mark = "\xEF\xBB\xBF"sv; bytes.starts_with(mark))
    bytes.remove_prefix(mark.size());
  return bytes;
}

Table parse_table(std::string_view text, std::string_view name) {
  const auto lines = lines_of(utf8_text(text, name));
  if (lines.empty()) throw Error(fmt::format("{}: empty table", name));
  const auto& header = lines.front().cells;
  Table table;
  for (std::size_t r = 1; r < lines.size(); ++r) {
    const auto& [number, cells] = lines[r];
    if (cells.size() != header.size())
      throw Error(
          fmt::format("{}:{}: {} cells, expected {}", name, number, cells.size(), header.size()));
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const auto value = number_in(cells[c]);
      if (!value) throw Error(fmt::format("{}:{}: \"{}\" is no number", name, number, cells[c]));
      table.columns[header[c]].push_back(*value);
    }
  }
  return table;
}

std::vector<std::vector<std::string>> parse_text_table(std::string_view text) {
  std::vector<std::vector<std::string>> rows;
  for (auto& line : lines_of(text)) rows.push_back(std::move(line.cells));
  return rows;
}

}  // namespace coppermoon::algebra
