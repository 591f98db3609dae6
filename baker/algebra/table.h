// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace coppermoon::algebra {

/// A table of numbers with named columns, read from comma-separated text.
struct Table {
  std::map<std::string, std::vector<double>, std::less<>> columns;

  /// The numbers in a column. Throws Error if there is no such column.
  const std::vector<double>& operator[](std::string_view column) const;
};

/// The text of a file as editors of any system save it, without a byte-order mark.
///
/// Given   name   of the file, for the message
/// Throws  Error  if the text is in UTF-16
std::string_view utf8_text(std::string_view bytes, std::string_view name);

/// Reads comma-separated text: lines that begin with `#` are comments, the first other line names
/// the columns, all further lines are numbers.
///
/// Given     text   the table
///           name   the table's name in error messages
/// Throws    Error  "<name>:<line>: …" if a cell is not a number or a line has the wrong length
Table parse_table(std::string_view text, std::string_view name);

/// Splits comma-separated text into cells [row][column], of which the header is the first row. Comments are left out.
std::vector<std::vector<std::string>> parse_text_table(std::string_view text);

}  // namespace coppermoon::algebra
