// SPDX-License-Identifier: MIT
#include "uses/film/film_record.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include "algebra/error.h"
#include "texture/read_image.h"
#include "uses/light/header.h"
#include "uses/light/light_parameters.h"

namespace coppermoon::uses {
namespace {

using request::Affects, request::Recipe, request::Setting;

constexpr const char *recipe_attribute = "coppermoon:recipe",
                     *version_attribute = "coppermoon:version",
                     *map_attribute = "coppermoon:albedo_map_contents",
                     *view_attribute = "coppermoon:view_contents",
                     *view_contents_name = "view-contents";

/// The given settings, with the program's version and fingerprints of the albedo map and the display view added.
Recipe account_of(const Recipe& recipe, std::string_view version, const std::string& map,
                  const std::string& view) {
  const auto setting = [](const char* name, std::string_view text, Affects affects) {
    return Setting{.name = name, .texts = {std::string(text)}, .bare = true, .affects = affects};
  };
  return with({setting("version", version, Affects::light),
               setting("albedo-map-contents", map, Affects::ground),
               setting(view_contents_name, view, Affects::picture)},
              recipe);
}

Recipe asked_account(const FilmRecord& record) {
  return account_of(record.recipe, version(), record.map_contents, record.view_contents);
}

Recipe planned_recipe(const FilmRecord& record) {
  return record.work ? with_work(record.recipe, *record.work) : record.recipe;
}

Recipe planned_account(const FilmRecord& record) {
  return account_of(planned_recipe(record), version(), record.map_contents, record.view_contents);
}

/// The settings in a file's header, as completed by account_of. Empty if the header has no readable settings.
///
/// Throws  Error  when the file is not an image
Recipe account_in(const std::filesystem::path& file) {
  constexpr std::array<std::string_view, 4> names{recipe_attribute, version_attribute,
                                                  map_attribute, view_attribute};
  const auto values = texture::read_attributes(file, names);
  if (!values[0]) return {};
  try {
    return account_of(request::recipe_in(*values[0]), values[1].value_or("none"),
                      values[2].value_or("none"), values[3].value_or("none"));
  } catch (const algebra::Error&) {
    return {};
  }
}

/// Whether a file depends on a setting, judging by the file's name. Textures do not depend on the camera, linear frames
/// do not depend on the display's view, and pictures depend on all settings.
bool depends_on(const std::filesystem::path& file, const Setting& setting) {
  if (file.extension() == ".png") return true;
  return file.filename().string().starts_with("moon_") ? setting.affects <= Affects::sight
                                                       : setting.name != view_contents_name;
}

std::string in_words(const request::Difference& difference) {
  const auto& [name, there, asked, of_parts] = difference;
  if (of_parts) return fmt::format("other contents of {}s", name);
  const auto but_scene = [](const std::string& contents) {
    return contents.substr(0, contents.find(" scene "));
  };
  if (name == "albedo-map-contents" && but_scene(there) == but_scene(asked))
    return "other contents of scene";
  const auto of_map = [](const std::string& contents) {  // the map's fingerprint comes first
    return contents.substr(0, contents.find(' '));
  };
  if (name == "albedo-map-contents" && of_map(there) == of_map(asked))
    return "other contents of response";
  if (name.ends_with("-contents")) return "other contents of " + name.substr(0, name.rfind('-'));
  return fmt::format("{} = {}, asked {}", name, there, asked);
}

}  // namespace

texture::Attributes FilmRecord::frame_header() const {
  return {{recipe_attribute, text_of(planned_recipe(*this))},
          {version_attribute, std::string(version())},
          {map_attribute, map_contents},
          {view_attribute, view_contents}};
}

texture::Attributes FilmRecord::film_header() const {
  return {{recipe_attribute, text_of(planned_recipe(*this))}};
}

Recipe FilmRecord::light_key() const {
  auto key = asked_account(*this);
  std::erase_if(key, [](const Setting& setting) { return setting.affects > Affects::light; });
  return key;
}

std::string FilmRecord::film_key() const {
  auto key = asked_account(*this);
  std::erase_if(key, is_planned);
  return text_of(key);
}

bool FilmRecord::made_alike(const std::filesystem::path& file) const {
  return !recipe.empty() &&
         request::differences(account_in(file), planned_account(*this), [&](const auto& setting) {
           return depends_on(file, setting);
         }).empty();
}

bool FilmRecord::shows_the_same(const std::filesystem::path& frame) const {
  return !recipe.empty() &&
         request::differences(account_in(frame), planned_account(*this), [](const auto& setting) {
           return setting.affects <= Affects::frame;
         }).empty();
}

std::string FilmRecord::foreign_contents(const std::filesystem::path& file) const {
  if (recipe.empty()) return "what is not known to be of this film";
  try {
    const auto there = account_in(file);
    if (there.empty()) return "what is no film of coppermoon's";
    const auto why = uses::in_words(request::differences(
        there, planned_account(*this),
        [&](const Setting& setting) { return depends_on(file, setting) && !is_planned(setting); }));
    return why.empty() ? "" : "a film made with " + why;
  } catch (const algebra::Error&) {
    return {};
  }
}

Recipe light_key_in(const std::string& text) {
  return request::recipe_in(
      text, "",
      {"first-frame", "last-frame", "version", "albedo-map-contents", view_contents_name});
}

std::string in_words(std::vector<request::Difference> all) {
  constexpr std::size_t most = 3;
  std::ranges::sort(all, {}, [](const request::Difference& difference) {
    return std::pair(difference.first == "none", difference.name);
  });
  std::vector<std::string> some;
  for (const auto& difference : all)
    if (some.size() < most) some.push_back(in_words(difference));
  const auto more = all.size() > most ? fmt::format("; {} more", all.size() - most) : "";
  return fmt::format("{}{}", fmt::join(some, "; "), more);
}

}  // namespace coppermoon::uses
