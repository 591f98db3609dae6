// SPDX-License-Identifier: MIT
#pragma once

#include <string>

/// A FITS file: cards, a line each, and data, both in whole blocks.
inline std::string fits_bytes(const std::string& cards, std::string data) {
  std::string header;
  for (std::size_t at = 0; at < cards.size(); at = cards.find('\n', at) + 1) {
    auto card = cards.substr(at, cards.find('\n', at) - at);
    card.resize(80, ' ');
    header += card;
  }
  header += "END";
  header.resize((header.size() + 2879) / 2880 * 2880, ' ');
  data.resize((data.size() + 2879) / 2880 * 2880, '\0');
  return header + data;
}
