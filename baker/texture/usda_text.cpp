// SPDX-License-Identifier: MIT
#include "texture/usda_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace coppermoon::texture {
namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_octal(char c) { return c >= '0' && c <= '7'; }

/// A piece of USD text: a quoted text without its quotes, a word, or one character.
struct Token {
  enum Kind { text, word, sign, end } kind = end;
  std::string value{};

  bool is(std::string_view wanted) const { return kind != text && value == wanted; }
  bool names(std::string_view wanted) const {
    return (kind == text || kind == word) && value == wanted;
  }
};

/// USD text taken apart from its beginning on; what is cut off ends it.
class Tokens {
 public:
  explicit Tokens(std::string_view left) : left_(left) {}

  Token next() {
    skip_space();
    if (left_.empty()) return {};
    if (left_.front() == '"' || left_.front() == '\'') return quoted();
    const auto length = static_cast<std::size_t>(
        std::ranges::find_if_not(left_, [](char c) { return is_letter(c) || is_digit(c); }) -
        left_.begin());
    if (length > 0) return {Token::word, taken(length)};
    return {Token::sign, taken(1)};
  }

 private:
  std::string taken(std::size_t length) {
    std::string part(left_.substr(0, length));
    left_.remove_prefix(part.size());
    return part;
  }

  void skip_space() {
    while (!left_.empty()) {
      const auto space = std::min(left_.find_first_not_of(" \t\r\n"), left_.size());
      const auto comment = left_.substr(space).starts_with('#');
      if (space == 0 && !comment) return;
      left_.remove_prefix(comment ? std::min(left_.find('\n', space), left_.size()) : space);
    }
  }

  Token quoted() {
    const std::string three(3, left_.front());
    const std::string mark = left_.starts_with(three) ? three : three.substr(2);
    left_.remove_prefix(mark.size());
    Token token{Token::text};
    while (!left_.empty() && !left_.starts_with(mark))
      token.value += left_.front() == '\\' && left_.size() > 1 ? escaped() : taken(1);
    if (left_.empty()) return {};
    left_.remove_prefix(mark.size());
    return token;
  }

  std::string escaped() {
    constexpr std::string_view letters = "abfnrtv", meant = "\a\b\f\n\r\t\v";
    left_.remove_prefix(1);
    if (left_.front() == 'x') {
      left_.remove_prefix(1);
      return number(16, 2);
    }
    if (is_octal(left_.front())) return number(8, 3);
    const auto letter = letters.find(left_.front());
    const auto itself = taken(1);
    return letter == std::string_view::npos ? itself : std::string{meant[letter]};
  }

  std::string number(int base, std::size_t most_digits) {
    int value = 0;
    for (std::size_t i = 0; i < most_digits && !left_.empty(); ++i) {
      constexpr std::string_view digits = "0123456789abcdefABCDEF";
      const auto digit = digits.find(left_.front());
      const int worth = static_cast<int>(digit < 16 ? digit : digit - 6);
      if (digit == std::string_view::npos || worth >= base) break;
      value = value * base + worth;
      left_.remove_prefix(1);
    }
    return {static_cast<char>(value)};
  }

  std::string_view left_;
};

}  // namespace

std::string usda_quoted(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    const bool control = (c >= 0 && c < ' ') || c == '\x7F';
    if (c == '\n')
      quoted += "\\n";
    else if (control)
      quoted += fmt::format("\\{:03o}", static_cast<int>(c));
    else
      quoted += c == '"' || c == '\\' ? std::string{'\\', c} : std::string{c};
  }
  return quoted + '"';
}

std::string usda_asset(std::string_view file_name) {
  if (file_name.find('@') == std::string_view::npos) return fmt::format("@./{}@", file_name);
  std::string name(file_name);
  for (auto at = name.find("@@@"); at != std::string::npos; at = name.find("@@@", at + 4))
    name.insert(at, 1, '\\');
  return fmt::format("@@@./{}@@@", name);
}

std::string usda_key(std::string_view name) {
  const bool identifier =
      !name.empty() && !is_digit(name.front()) &&
      std::ranges::all_of(name, [](char c) { return is_letter(c) || is_digit(c); });
  return identifier ? std::string(name) : usda_quoted(name);
}

/// The layer's metadata are the first thing in parentheses. In them every bracket is followed, and
/// the name that stood before each.
std::optional<std::string> string_in_layer_data(std::string_view layer, std::string_view dictionary,
                                                std::string_view name) {
  Tokens tokens(layer);
  if (!tokens.next().is("(")) return {};
  std::vector<std::string> inside{"("};
  Token type, key, before;  // the last three
  for (auto token = tokens.next(); token.kind != Token::end; token = tokens.next()) {
    const bool opens = token.is("(") || token.is("[") || token.is("{");
    if (opens) inside.push_back(before.is("=") ? key.value : "");
    if (token.is(")") || token.is("]") || token.is("}")) inside.pop_back();
    if (inside.empty() || inside.size() > 64) return {};
    const bool there =
        inside.size() == 3 && inside[1] == "customLayerData" && inside[2] == dictionary;
    if (there && type.is("string") && key.names(name) && before.is("=") &&
        token.kind == Token::text)
      return token.value;
    type = std::move(key);
    key = std::move(before);
    before = std::move(token);
  }
  return {};
}

}  // namespace coppermoon::texture
