// SPDX-License-Identifier: MIT
#include "verbs/one_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <utility>
#include <vector>

#include "algebra/error.h"
#include "texture/read_image.h"
#include "verbs/photo_file.h"
#include "verbs/recipe.h"

namespace coppermoon::verbs {
namespace {

/// The shadow goes over a sixtieth of the disc in it: 33 arcseconds.
constexpr double most_apart_s = 60;

std::string words_for(const texture::Window& window) {
  return fmt::format("{} x {} pixels", window.width, window.height);
}

std::string words_with_place_for(const texture::Window& window) {
  return fmt::format("{} from {}, {}", words_for(window), window.left, window.top);
}

void require_one_window(const std::string& first, const std::string& other) {
  const auto mine = texture::windows_of(other), its = texture::windows_of(first);
  const auto require_equal = [&](const auto& what, const texture::Window& a,
                                 const texture::Window& b) {
    if (a == b) return;
    const bool alike = a.width == b.width && a.height == b.height;
    const auto words = alike ? words_with_place_for : words_for;
    throw algebra::Error(
        fmt::format("{}: {} {}, allowed {} as {}", other, what, words(a), words(b), first));
  };
  require_equal("display window of", mine.display, its.display);
  require_equal("data window of", mine.data, its.data);
}

void require_one_time(const std::string& first, const std::string& other) {
  const auto mine = taken_at_s(other), its = taken_at_s(first);
  if (!mine || !its || std::abs(*mine - *its) <= most_apart_s) return;
  throw algebra::Error(fmt::format("{}: taken {:.0f} s {} {}, allowed {:g} s", other,
                                   std::abs(*mine - *its), *mine > *its ? "after" : "before", first,
                                   most_apart_s));
}

void require_one_meaning(const std::string& first, const std::string& other) {
  for (const char* name : {"coppermoon:colour_space", "coppermoon:unit"}) {
    const auto mine = texture::read_attribute(other, name),
               its = texture::read_attribute(first, name);
    if (mine && its && *mine != *its)
      throw algebra::Error(
          fmt::format("{}: {} = {}, allowed {} as {}", other, name, *mine, *its, first));
  }
}

/// Flags and their values; tables of the air as one.
using Lines = std::vector<std::pair<std::string, std::string>>;

Lines lines_of(const std::string& recipe) {
  constexpr std::array of_the_exposure{"time", "iso",     "f-number", "noise", "noise-seed",
                                       "view", "display", "config",   "bits"};
  std::istringstream text(without(recipe, [&](const std::string& flag) {
    return std::ranges::find(of_the_exposure, flag) != of_the_exposure.end();
  }));
  Lines lines;
  bool in_tables = false;
  for (std::string line; std::getline(text, line);) {
    if (line.empty()) continue;
    const auto sign = line.find(" = ");
    if (in_tables)
      lines.back().second += "; " + line;
    else if (line.starts_with("["))
      lines.emplace_back("atmosphere", line), in_tables = true;
    else
      lines.emplace_back(line.substr(0, sign), sign == line.npos ? "" : line.substr(sign + 3));
  }
  return lines;
}

std::string value_in(const Lines& lines, const std::string& flag) {
  const auto line = std::ranges::find(lines, flag, &Lines::value_type::first);
  return line == lines.end() ? "none" : line->second;
}

void require_one_recipe(const std::string& first, const std::string& other) {
  constexpr const char* name = "coppermoon:recipe";
  const auto mine = texture::read_attribute(other, name),
             its = texture::read_attribute(first, name);
  if (!mine || !its) return;
  const auto a = lines_of(*mine), b = lines_of(*its);
  auto both = a;
  both.insert(both.end(), b.begin(), b.end());
  for (const auto& [flag, value] : both)
    if (value_in(a, flag) != value_in(b, flag))
      throw algebra::Error(fmt::format("{}: its recipe has {} = {}, allowed {} as {}", other, flag,
                                       value_in(a, flag), value_in(b, flag), first));
}

}  // namespace

void require_one_scene(const std::string& first, const std::string& other) {
  require_one_window(first, other);
  require_one_meaning(first, other);
  require_one_time(first, other);
  require_one_recipe(first, other);
}

}  // namespace coppermoon::verbs
