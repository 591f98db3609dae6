// SPDX-License-Identifier: MIT
#include "verbs/film_account.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "texture/read_image.h"
#include "verbs/film.h"
#include "verbs/known_words.h"
#include "verbs/recipe.h"

namespace coppermoon::verbs {
namespace {

using Names = std::vector<std::string>;

constexpr const char *recipe_attribute = "coppermoon:recipe",
                     *version_attribute = "coppermoon:version",
                     *map_attribute = "coppermoon:albedo_map_contents",
                     *view_attribute = "coppermoon:view_contents";

Account account(const std::string& recipe, const std::string& version, const std::string& map,
                const std::string& view) {
  return fmt::format("version = {}\nalbedo-map-contents = {}\nview-contents = {}\n{}", version, map,
                     view, recipe);
}

Names operator+(Names names, const Names& more) {
  names.insert(names.end(), more.begin(), more.end());
  return names;
}

/// Flags of exposure and picture; a camera by its name has a focal length and a sensor too.
const Names& picture_flags() {
  static const Names flags = [] {
    auto all = flags_added_by([](CLI::App& verb) {
      DevelopOptions develop;
      add_develop_options(verb, develop);
      add_camera_options(verb, develop.camera);
    });
    std::erase(all, "camera");
    return all + Names{"bracket", "view-contents"};
  }();
  return flags;
}

/// Flags of who looks and where to.
const Names& frame_flags() {
  static const Names flags = flags_added_by([](CLI::App& verb) {
                               ViewOptions view;
                               add_view_options(verb, view);
                             }) +
                             Names{"camera", "mount", "aim"};
  return flags;
}

/// Of those the ones that redden what is seen.
const Names sightline_flags{"at", "reddening", "observer-ozone-du", "observer-aerosol"};

/// Flags of the map, of a texture's file and of time.
const Names other_flags{"albedo-map",    "albedo-map-contents",
                        "photometry",    "albedo-exponent",
                        "texture-width", "space",
                        "type",          "spectral",
                        "passes",        "eclipse",
                        "from",          "to",
                        "frames",        "fps",
                        "time-scale"};

bool is_texture(const std::filesystem::path& file) {
  return file.filename().string().starts_with("moon_");
}

/// One of them, for whoever asked for the second.
std::string told(const RecipeDifference& difference) {
  const auto& [flag, there, asked] = difference;
  if (flag == "regions") return "other contents of regions";
  if (flag.ends_with("-contents")) return "other contents of " + flag.substr(0, flag.rfind('-'));
  return fmt::format("{} = {}, asked {}", flag, there, asked);
}

}  // namespace

Account account_of(const Film& film) {
  return account(film.recipe, COPPERMOON_VERSION, film.map_contents, film.view_contents);
}

texture::Attributes account_attributes(const Film& film) {
  return {{recipe_attribute, film.recipe},
          {version_attribute, std::string(COPPERMOON_VERSION)},
          {map_attribute, film.map_contents},
          {view_attribute, film.view_contents}};
}

Account account_in(const std::filesystem::path& file) {
  constexpr std::array<std::string_view, 4> names{recipe_attribute, version_attribute,
                                                  map_attribute, view_attribute};
  const auto told = texture::read_attributes(file, names);
  if (!told[0]) return {};
  return account(*told[0], told[1].value_or("none"), told[2].value_or("none"),
                 told[3].value_or("none"));
}

Account of_light(const Account& account) {
  const auto dropped = picture_flags() + frame_flags() + other_flags;
  return without(account, [&](const std::string& flag) { return holds(dropped, flag); });
}

Account of_scene(const Account& account) {
  return without(account, [&](const std::string& flag) { return holds(picture_flags(), flag); });
}

Account of_file(const std::filesystem::path& file, const Account& account) {
  if (file.extension() == ".png") return account;
  if (!is_texture(file))
    return without(account, [](const std::string& flag) { return flag == "view-contents"; });
  const auto dropped = picture_flags() + frame_flags();
  return without(account, [&](const std::string& flag) {
    return holds(dropped, flag) && !holds(sightline_flags, flag);
  });
}

std::string differences(const Account& there, const Account& asked) {
  constexpr std::size_t most = 3;
  auto all = recipe_differences(there, asked);
  std::ranges::sort(all, {}, [](const RecipeDifference& difference) {
    return std::pair(difference.first == "none", difference.flag);
  });
  Names some;
  for (const auto& difference : all)
    if (some.size() < most) some.push_back(told(difference));
  const auto more = all.size() > most ? fmt::format("; {} more", all.size() - most) : "";
  return fmt::format("{}{}", fmt::join(some, "; "), more);
}

}  // namespace coppermoon::verbs
