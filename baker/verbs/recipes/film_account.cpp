// SPDX-License-Identifier: MIT
#include "verbs/recipes/film_account.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "algebra/error.h"
#include "texture/read_image.h"
#include "uses/light/header.h"
#include "verbs/flags/camera_options.h"
#include "verbs/flags/develop_options.h"
#include "verbs/flags/known_words.h"
#include "verbs/flags/plan_options.h"
#include "verbs/flags/view_options.h"
#include "verbs/recipes/recipe.h"

namespace coppermoon::verbs {
namespace {

using Names = std::vector<std::string>;

/// What a file was made from, in lines as a recipe's: the program's version, fingerprints of the albedo
/// map and of the view, and the recipe.
using Account = std::string;

constexpr const char *recipe_attribute = "coppermoon:recipe",
                     *version_attribute = "coppermoon:version",
                     *map_attribute = "coppermoon:albedo_map_contents",
                     *view_attribute = "coppermoon:view_contents";

/// What a header says, or is to say.
struct Said {
  std::string recipe, version, map, view;
};

Account account_of(const Said& said) {
  return fmt::format("version = {}\nalbedo-map-contents = {}\nview-contents = {}\n{}", said.version,
                     said.map, said.view, said.recipe);
}

Names operator+(Names names, const Names& more) {
  names.insert(names.end(), more.begin(), more.end());
  return names;
}

/// Flags of exposure and picture; a camera by its name has a focal length and a sensor too.
const Names& picture_flags() {
  static const Names flags = [] {
    auto all = flags_added_by([](CLI::App& verb) {
      uses::Development development;
      add_develop_options(verb, development);
      add_camera_options(verb, development.camera);
    });
    std::erase(all, "camera");
    return all + Names{"bracket", "view-contents"};
  }();
  return flags;
}

/// Flags of who looks and where to.
const Names& frame_flags() {
  static const Names flags = flags_added_by([](CLI::App& verb) {
                               uses::ViewRequest view;
                               add_view_options(verb, view);
                             }) +
                             Names{"camera", "mount", "aim"};
  return flags;
}

/// Those flags of them that redden what is seen.
const Names sightline_flags{"at", "reddening", "observer-ozone-du", "observer-aerosol"};

/// Flags of the map, of a texture's file and of time.
const Names other_flags{"albedo-map",
                        "albedo-map-centre",
                        "albedo-map-contents",
                        "photometry",
                        "albedo-exponent",
                        "albedo-encoding",
                        "ground",
                        "texture-width",
                        "space",
                        "type",
                        "spectral",
                        "passes",
                        "eclipse",
                        "from",
                        "to",
                        "frames",
                        "fps",
                        "time-scale"};

bool is_texture(const std::filesystem::path& file) {
  return file.filename().string().starts_with("moon_");
}

/// A difference in words, for whoever asked for the second.
std::string in_words(const RecipeDifference& difference) {
  const auto& [flag, there, asked] = difference;
  if (flag == "regions") return "other contents of regions";
  if (flag.ends_with("-contents")) return "other contents of " + flag.substr(0, flag.rfind('-'));
  return fmt::format("{} = {}, asked {}", flag, there, asked);
}

/// The account that a file's header keeps; empty without a recipe.
///
/// Throws  Error  when it is no image
Account account_in(const std::filesystem::path& file) {
  constexpr std::array<std::string_view, 4> names{recipe_attribute, version_attribute,
                                                  map_attribute, view_attribute};
  const auto told = texture::read_attributes(file, names);
  if (!told[0]) return {};
  return account_of(
      {*told[0], told[1].value_or("none"), told[2].value_or("none"), told[3].value_or("none")});
}

/// Those of all lines that the light of a film depends on.
Account of_light(const Account& account) {
  const auto dropped = picture_flags() + frame_flags() + other_flags;
  return without(account, [&](const std::string& flag) { return holds(dropped, flag); });
}

/// Those that a linear frame's pixels depend on: all but its exposure and its picture.
Account of_scene(const Account& account) {
  return without(account, [&](const std::string& flag) { return holds(picture_flags(), flag); });
}

/// Those that a file depends on, by its name: a texture has no camera.
Account of_file(const std::filesystem::path& file, const Account& account) {
  if (file.extension() == ".png") return account;
  if (!is_texture(file))
    return without(account, [](const std::string& flag) { return flag == "view-contents"; });
  const auto dropped = picture_flags() + frame_flags();
  return without(account, [&](const std::string& flag) {
    return holds(dropped, flag) && !holds(sightline_flags, flag);
  });
}

/// What two accounts differ in, for whoever asked for the second: "iso = 800, asked 100; …". Empty: in
/// nothing.
std::string differences(const Account& there, const Account& asked) {
  constexpr std::size_t most = 3;
  auto all = recipe_differences(there, asked);
  std::ranges::sort(all, {}, [](const RecipeDifference& difference) {
    return std::pair(difference.first == "none", difference.flag);
  });
  Names some;
  for (const auto& difference : all)
    if (some.size() < most) some.push_back(in_words(difference));
  const auto more = all.size() > most ? fmt::format("; {} more", all.size() - most) : "";
  return fmt::format("{}{}", fmt::join(some, "; "), more);
}

/// What a file holds that is not made from what was asked for, in words; work is planned later, or was:
/// what is planned from is compared.
std::string foreign_contents(const std::filesystem::path& file, const Account& asked) {
  try {
    const auto there = account_in(file);
    if (there.empty()) return "what is no film of coppermoon's";
    const auto why = differences(without_work(of_file(file, there)), of_file(file, asked));
    return why.empty() ? "" : "a film made with " + why;
  } catch (const algebra::Error&) {
    return {};
  }
}

}  // namespace

uses::FilmRecord record_of(const FilmAccount& account) {
  Said said{account.recipe, std::string(uses::version()), account.map_contents,
            account.view_contents};
  uses::FilmRecord record;
  record.light_key = of_light(account_of(said));
  record.film_key = without_work(account_of(said));
  if (account.work) said.recipe = with_work(account.recipe, *account.work);
  record.frame_header = {{recipe_attribute, said.recipe},
                         {version_attribute, said.version},
                         {map_attribute, said.map},
                         {view_attribute, said.view}};
  record.film_header = {{recipe_attribute, said.recipe}};
  const auto mine = account_of(said);
  record.made_alike = [mine](const std::filesystem::path& file) {
    return of_file(file, account_in(file)) == of_file(file, mine);
  };
  record.shows_the_same = [scene = of_scene(mine)](const std::filesystem::path& frame) {
    return of_scene(account_in(frame)) == scene;
  };
  record.foreign_contents = [asked = without_work(mine)](const std::filesystem::path& file) {
    return foreign_contents(file, asked);
  };
  record.differences = differences;
  record.planned_key = with_work;
  record.way_out = ", or --replace";
  return record;
}

}  // namespace coppermoon::verbs
