// SPDX-License-Identifier: MIT
#include "verbs/reports/one_line.h"

#include <fmt/format.h>

#include <algorithm>

namespace coppermoon::verbs {
namespace {

unsigned char byte(std::string_view text, std::size_t i) {
  return static_cast<unsigned char>(text[i]);
}

std::size_t length_told_by(unsigned char first) {
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first <= 0xDF) return 2;
  if (first >= 0xE0 && first <= 0xEF) return 3;
  return first >= 0xF0 && first <= 0xF4 ? 4 : 0;
}

/// Whether UTF-8 allows this second byte of a character after this first byte. UTF-8 forbids overlong encodings,
/// surrogates and characters above U+10FFFF.
bool second_allowed(unsigned char first, unsigned char second) {
  if (first == 0xE0) return second >= 0xA0;
  if (first == 0xED) return second <= 0x9F;
  if (first == 0xF0) return second >= 0x90;
  return first != 0xF4 || second <= 0x8F;
}

/// Length of the first character of a string [bytes]; 0 if the string does not begin with valid UTF-8.
std::size_t character_length(std::string_view text) {
  const std::size_t length = length_told_by(byte(text, 0));
  if (length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(text, i) & 0xC0) != 0x80) return 0;
  return length < 2 || second_allowed(byte(text, 0), byte(text, 1)) ? length : 0;
}

/// Whether a character lies in U+0000 to U+001F or U+007F to U+009F. Terminals treat some of these as commands.
bool is_control(std::string_view character) {
  const auto first = byte(character, 0);
  return first < ' ' || first == 0x7F || (first == 0xC2 && byte(character, 1) < 0xA0);
}

std::string shown(std::string_view text) {
  std::string line;
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    const auto character = text.substr(0, std::max<std::size_t>(length, 1));
    if (character == "\n")
      line += "\\n";
    else if (length > 0 && !is_control(character))
      line += character;
    else
      for (const char c : character)
        line += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    text.remove_prefix(character.size());
  }
  return line;
}

}  // namespace

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

std::string one_line(std::string_view text) {
  constexpr std::size_t longest = 2000, beginning = 1200, ending = 600;
  while (text.ends_with('\n')) text.remove_suffix(1);
  if (text.size() <= longest) return shown(text);
  return shown(text.substr(0, beginning)) + " ... " + shown(text.substr(text.size() - ending));
}

std::string in_single_quotes(std::string_view text) {
  std::string safe;
  for (const char letter : text) safe += letter == '\'' ? "'\\''" : std::string{letter};
  return "'" + safe + "'";
}

}  // namespace coppermoon::verbs
