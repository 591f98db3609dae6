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

/// Text of a UTF-8 file, without the byte-order mark that some editors write.
///
/// Given   name   name of the file, for the error message
/// Throws  Error  if the text is in UTF-16
std::string_view utf8_text(std::string_view bytes, std::string_view name);

/// Reads comma-separated text. Lines that begin with `#` are comments. The first other line names the columns, and all
/// further lines hold numbers.
///
/// Given     text   the table
///           name   the table's name in error messages
/// Throws    Error  "<name>:<line>: …" if a cell is not a number or a line has the wrong length
Table parse_table(std::string_view text, std::string_view name);

/// Splits comma-separated text into cells, indexed by [row][column]. Row 0 is the header. Comments are left out.
std::vector<std::vector<std::string>> parse_text_table(std::string_view text);

}  // namespace coppermoon::algebra
