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
#include "request/recipe.h"
#include "texture/read_image.h"
#include "uses/light/header.h"
#include "uses/light/light_parameters.h"

namespace coppermoon::uses {
namespace {

using request::Affects;

constexpr const char *recipe_attribute = "coppermoon:recipe",
                     *version_attribute = "coppermoon:version",
                     *map_attribute = "coppermoon:albedo_map_contents",
                     *view_attribute = "coppermoon:view_contents",
                     *view_contents_name = "view-contents";

/// Recipe of a file, with the program's version and the fingerprints of the map and the view as parameters.
using Account = std::string;

Account account_of(const std::string& recipe, std::string_view version, std::string_view map,
                   std::string_view view) {
  return fmt::format("version = {}\nalbedo-map-contents = {}\n{} = {}\n{}", version, map,
                     view_contents_name, view, recipe);
}

Account planned_account(const FilmRecord& record) {
  return account_of(record.work ? with_work(record.recipe, *record.work) : record.recipe, version(),
                    record.map_contents, record.view_contents);
}

/// Account that a file's header keeps; empty without a recipe.
///
/// Throws  Error  when it is no image
Account account_in(const std::filesystem::path& file) {
  constexpr std::array<std::string_view, 4> names{recipe_attribute, version_attribute,
                                                  map_attribute, view_attribute};
  const auto values = texture::read_attributes(file, names);
  if (!values[0]) return {};
  return account_of(*values[0], values[1].value_or("none"), values[2].value_or("none"),
                    values[3].value_or("none"));
}

Affects affected_by(const FilmRecord& record, const std::string& name) {
  if (name == "version") return Affects::light;
  if (name == view_contents_name) return Affects::picture;
  const auto found = record.affected.find(name);
  return found == record.affected.end() ? Affects::ground : found->second;
}

/// Account of what affects that stage or an earlier one.
Account up_to(Affects stage, const FilmRecord& record, const Account& account) {
  return request::without(
      account, [&](const std::string& name) { return affected_by(record, name) > stage; });
}

bool is_texture(const std::filesystem::path& file) {
  return file.filename().string().starts_with("moon_");
}

/// Account of what a file depends on, by its name: a texture has no camera, and a frame no view.
Account for_file(const std::filesystem::path& file, const FilmRecord& record,
                 const Account& account) {
  if (file.extension() == ".png") return account;
  if (is_texture(file)) return up_to(Affects::sight, record, account);
  return request::without(account,
                          [](const std::string& name) { return name == view_contents_name; });
}

std::string in_words(const request::Difference& difference) {
  const auto& [name, there, asked] = difference;
  if (name == "regions") return "other contents of regions";
  const auto but_scene = [](const std::string& contents) {
    return contents.substr(0, contents.find(" scene "));
  };
  if (name == "albedo-map-contents" && but_scene(there) == but_scene(asked))
    return "other contents of scene";
  const auto of_map = [](const std::string& contents) {  // before those of a response's file
    return contents.substr(0, contents.find(' '));
  };
  if (name == "albedo-map-contents" && of_map(there) == of_map(asked))
    return "other contents of response";
  if (name.ends_with("-contents")) return "other contents of " + name.substr(0, name.rfind('-'));
  return fmt::format("{} = {}, asked {}", name, there, asked);
}

}  // namespace

texture::Attributes FilmRecord::frame_header() const {
  return {{recipe_attribute, work ? with_work(recipe, *work) : recipe},
          {version_attribute, std::string(version())},
          {map_attribute, map_contents},
          {view_attribute, view_contents}};
}

texture::Attributes FilmRecord::film_header() const {
  return {{recipe_attribute, work ? with_work(recipe, *work) : recipe}};
}

std::string FilmRecord::light_key() const {
  return up_to(Affects::light, *this, account_of(recipe, version(), map_contents, view_contents));
}

std::string FilmRecord::film_key() const {
  return without_work(account_of(recipe, version(), map_contents, view_contents));
}

bool FilmRecord::made_alike(const std::filesystem::path& file) const {
  return !recipe.empty() &&
         for_file(file, *this, account_in(file)) == for_file(file, *this, planned_account(*this));
}

bool FilmRecord::shows_the_same(const std::filesystem::path& frame) const {
  return !recipe.empty() && up_to(Affects::frame, *this, account_in(frame)) ==
                                up_to(Affects::frame, *this, planned_account(*this));
}

std::string FilmRecord::foreign_contents(const std::filesystem::path& file) const {
  if (recipe.empty()) return "what is not known to be of this film";
  try {
    const auto there = account_in(file);
    if (there.empty()) return "what is no film of coppermoon's";
    const auto why =
        differences_in_words(without_work(for_file(file, *this, there)),
                             without_work(for_file(file, *this, planned_account(*this))));
    return why.empty() ? "" : "a film made with " + why;
  } catch (const algebra::Error&) {
    return {};
  }
}

FilmRecord film_record(const request::Parameters& parameters, std::string recipe) {
  FilmRecord record{.recipe = std::move(recipe)};
  for (const auto& parameter : parameters)
    record.affected.emplace(parameter.name, parameter.affects);
  return record;
}

std::string differences_in_words(const std::string& there, const std::string& asked) {
  constexpr std::size_t most = 3;
  auto all = request::differences(there, asked);
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
