// SPDX-License-Identifier: MIT
#include "verbs/recipes/one_scene.h"

#include <cmath>
#include <functional>

#include "algebra/error.h"
#include "request/recipe.h"
#include "texture/read_image.h"
#include "uses/picture/photo_file.h"
#include "uses/picture/picture_parameters.h"

namespace coppermoon::verbs {
namespace {

/// Longest time between two exposures of one scene [s], in which the shadow moves by 33 arcseconds (1/60 of the disc).
constexpr double most_apart_s = 60;

std::string words_for(const texture::ImageWindow& window) {
  return fmt::format("{} x {} pixels", window.width, window.height);
}

std::string words_with_place_for(const texture::ImageWindow& window) {
  return fmt::format("{} from {}, {}", words_for(window), window.left, window.top);
}

void require_one_window(const std::string& first, const std::string& other) {
  const auto mine = texture::windows_of(other), its = texture::windows_of(first);
  const auto require_equal = [&](const auto& what, const texture::ImageWindow& a,
                                 const texture::ImageWindow& b) {
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
  const auto mine = uses::taken_at_s(other), its = uses::taken_at_s(first);
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

/// Whether this setting may differ between two exposures of one scene.
bool is_of_exposure(const request::Setting& setting) {
  uses::Development development;
  request::Parameters exposure;
  describe(exposure, development);
  return exposure.find(setting.name) != nullptr || setting.name == "noise" ||
         setting.name == "noise-seed";
}

void require_one_recipe(const std::string& first, const std::string& other) {
  constexpr const char* name = "coppermoon:recipe";
  const auto mine = texture::read_attribute(other, name),
             its = texture::read_attribute(first, name);
  if (!mine || !its) return;
  for (const auto& [parameter, here, there, of_parts] :
       request::differences(request::recipe_in(*mine, other), request::recipe_in(*its, first),
                            std::not_fn(is_of_exposure)))
    throw algebra::Error(fmt::format("{}: its recipe has {} = {}, allowed {} as {}", other,
                                     parameter, here, there, first));
}

}  // namespace

void require_one_scene(const std::string& first, const std::string& other) {
  require_one_window(first, other);
  require_one_meaning(first, other);
  require_one_time(first, other);
  require_one_recipe(first, other);
}

}  // namespace coppermoon::verbs
