// SPDX-License-Identifier: MIT
#include "colour/display.h"

#include <OpenColorIO/OpenColorIO.h>
#include <fmt/ranges.h>
#include <strings.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <utility>

#include "algebra/error.h"
#include "colour/config_guard.h"
#include "colour/tables.h"

namespace ocio = OCIO_NAMESPACE;

namespace coppermoon::colour {
namespace {

using algebra::Error;

bool knows_aces2() {
  const auto builtins = ocio::BuiltinTransformRegistry::Get();
  for (std::size_t i = 0; i < builtins->getNumBuiltins(); ++i)
    if (std::string_view(builtins->getBuiltinStyle(i)).ends_with("SDR-100nit-REC709_2.0"))
      return true;
  return false;
}

/// The built-in configuration, parsed only once because it caches the processors made from it.
ocio::ConstConfigRcPtr built_in_config() {
  static const auto config = [] {
    std::istringstream text{knows_aces2() ? config_text_of_aces2() : std::string(config_text())};
    return ocio::Config::CreateFromStream(text);
  }();
  return config;
}

ocio::ConstConfigRcPtr config_at(const std::filesystem::path& path) try {
  if (path.empty()) return built_in_config();
  if (path.string().starts_with("ocio://") && ocio::GetVersionHex() < 0x02020000)
    throw Error(fmt::format("{}: OpenColorIO {} has no configurations of its own, allowed a file",
                            path.string(), ocio::GetVersion()));
  return guarded_config(path);
} catch (const ocio::Exception& problem) {
  throw Error(fmt::format("{}: {}", path.empty() ? "config.ocio" : path.string(), problem.what()));
}

constexpr const char *usual_view = "Hue-preserving", *view_of_others = "Un-tone-mapped";

/// The allowed name that equals `name`, or else one that differs only in case.
std::string one_of(std::string_view what, const std::string& name,
                   const std::vector<std::string>& allowed) {
  if (std::ranges::find(allowed, name) != allowed.end()) return name;
  for (const auto& other : allowed)
    if (::strcasecmp(other.c_str(), name.c_str()) == 0) return other;
  throw Error(fmt::format("{} = {}, allowed {}", what, name, fmt::join(allowed, ", ")));
}

std::vector<std::string> spaces_of(const ocio::Config& config) {
  std::vector<std::string> names;
  for (int i = 0; i < config.getNumColorSpaces(); ++i)
    names.emplace_back(config.getColorSpaceNameByIndex(i));
  return names;
}

/// The names of one colour space in the built-in configuration and in another.
struct Bridge {
  std::string ours, theirs;
};

/// Common names of colour spaces, in addition to those in the built-in configuration.
const std::pair<std::string, std::vector<std::string>> common_names[] = {
    {"lin_rec709",
     {"Linear Rec.709", "Linear BT.709", "Linear sRGB", "Utility - Linear - sRGB",
      "Utility - Linear - Rec.709", "scene-linear Rec.709-sRGB", "scene-linear Rec 709/sRGB"}},
    {"acescg", {"ACES - ACEScg", "Linear ACEScg"}},
    {"ACES2065-1", {"ACES - ACES2065-1"}},
    {"lin_ciexyzd65_scene", {}}};

/// Names by which other configurations may know our spaces: aliases, then common names, with those of `space` first.
std::vector<Bridge> known_names(std::string_view space) {
  std::vector<Bridge> all, common;
  for (const bool own : {true, false})
    for (const auto& [ours, names] : common_names) {
      if ((ours == space) != own) continue;
      const auto built_in = built_in_config()->getColorSpace(ours.c_str());
      all.push_back({ours, built_in->getName()});
      for (std::size_t i = 0; i < built_in->getNumAliases(); ++i)
        all.push_back({ours, built_in->getAlias(i)});
      for (const auto& name : names) common.push_back({ours, name});
    }
  all.insert(all.end(), common.begin(), common.end());
  return all;
}

/// The colour space through which `space` is converted to another configuration, found as described for `developed`.
/// "Linear" is tried last, because a configuration may use that name for ACEScg.
Bridge bridge_to(const ocio::Config& config, const std::string& space) {
  const auto of_scene = [&](const std::string& name) {
    const auto found = config.getColorSpace(name.c_str());
    const bool of_it = found && found->getReferenceSpaceType() == ocio::REFERENCE_SPACE_SCENE;
    return of_it ? found : nullptr;
  };
  for (const auto& role : {Bridge{"ACES2065-1", "aces_interchange"},
                           Bridge{"lin_ciexyzd65_scene", "cie_xyz_d65_interchange"}})
    if (of_scene(role.theirs)) return role;
  auto known = known_names(space);
  if (const auto linear = of_scene("scene_linear"))
    for (const auto& each : known)
      if (of_scene(each.theirs) == linear) return each;
  known.push_back({"lin_rec709", "Linear"});
  for (const auto& each : known)
    if (of_scene(each.theirs)) return each;
  throw Error(fmt::format(
      "neither roles nor names say which colour space is {}, allowed as config-space {}", space,
      fmt::join(spaces_of(config), ", ")));
}

ocio::ConstProcessorRcPtr processor(WorkingSpace space, const DisplayTransform& development) try {
  const auto config = config_at(development.config);
  const auto display = display_named(development.display, development.config);
  const std::string ours(name(space)), &theirs = development.config_space;
  if (!theirs.empty() && !config->getColorSpace(theirs.c_str()))
    one_of("config-space", theirs, spaces_of(*config));
  const auto bridge = !theirs.empty()              ? Bridge{ours, theirs}
                      : development.config.empty() ? Bridge{ours, ours}
                                                   : bridge_to(*config, ours);
  const auto transform = ocio::DisplayViewTransform::Create();
  transform->setSrc(bridge.theirs.c_str());
  transform->setDisplay(display.c_str());
  transform->setView(view_named(development.view, display, development.config).c_str());
  const auto all =
      built_in_config()->getProcessor(ours.c_str(), bridge.ours.c_str())->createGroupTransform();
  all->appendTransform(transform);
  return config->getProcessor(all);
} catch (const ocio::Exception& problem) {
  throw Error(fmt::format("view \"{}\": {}", development.view, problem.what()));
}

void expose_row(Image& image, std::size_t row, double scale) {
  for (std::size_t column = 0; column < image.columns(); ++column)
    for (float& channel : image(row, column)) {
      const float exposed = static_cast<float>(channel * scale);
      if (!std::isfinite(exposed))
        throw Error(fmt::format("row {}, column {}: {:g} exposed by {:g} is not finite", row,
                                column, channel, scale));
      channel = exposed;
    }
}

}  // namespace

std::string_view config_text() { return tables::config(); }

std::string config_text_of_aces2() {
  constexpr std::string_view mark = "\n#2.4", version = "ocio_profile_version: 2";
  std::string text(config_text());
  for (auto at = text.find(mark); at != text.npos; at = text.find(mark, at))
    text.erase(at + 1, mark.size() - 1);
  return text.insert(text.find(version) + version.size(), ".4");
}

std::filesystem::path config_for(const std::string& view, const std::string& display,
                                 const std::filesystem::path& config) {
  const char* const told = std::getenv("OCIO");
  if (!config.empty() || !told) return config;
  try {
    view_named(view, display);
    return {};
  } catch (const Error&) {
    return told;
  }
}

std::vector<std::string> displays(const std::filesystem::path& path) {
  const auto config = config_at(path);
  const bool all = path.empty();  // includes those not in OCIO_ACTIVE_DISPLAYS
  std::vector<std::string> names;
  for (int i = 0; i < (all ? config->getNumDisplaysAll() : config->getNumDisplays()); ++i)
    names.emplace_back(all ? config->getDisplayAll(i) : config->getDisplay(i));
  return names;
}

std::vector<std::string> views(const std::string& display, const std::filesystem::path& path) {
  const auto config = config_at(path);
  const auto named = display_named(display, path);
  const char* of = named.c_str();
  std::vector<std::string> names;
  if (path.empty())  // all views, even those not in OCIO_ACTIVE_VIEWS
    for (const auto type : {ocio::VIEW_DISPLAY_DEFINED, ocio::VIEW_SHARED})
      for (int i = 0; i < config->getNumViews(type, of); ++i)
        names.emplace_back(config->getView(type, of, i));
  else
    for (int i = 0; i < config->getNumViews(of); ++i) names.emplace_back(config->getView(of, i));
  return names;
}

std::string display_named(const std::string& name, const std::filesystem::path& config) {
  return one_of("display", name, displays(config));
}

std::string view_named(const std::string& name, const std::string& display,
                       const std::filesystem::path& config) {
  const auto all = views(display, config);
  if (name == usual_view && std::ranges::find(all, name) == all.end() &&
      std::ranges::find(all, view_of_others) != all.end())
    return view_of_others;
  return one_of("view", name, all);
}

std::string fingerprint(WorkingSpace space, const DisplayTransform& development) {
  return processor(space, development)->getCacheID();
}

Image developed(Image picture, WorkingSpace space, const DisplayTransform& development) {
  if (!(development.scale > 0 && std::isfinite(development.scale)))
    throw Error(fmt::format("exposure scale = {:g}, allowed above 0", development.scale));
  const auto view = processor(space, development)->getDefaultCPUProcessor();
  const auto develop_rows = [&](const tbb::blocked_range<std::size_t>& rows) {
    for (auto row = rows.begin(); row != rows.end(); ++row) {
      expose_row(picture, row, development.scale);
      ocio::PackedImageDesc pixels(picture.row(row).data(), static_cast<long>(picture.columns()), 1,
                                   3);
      view->apply(pixels);
    }
  };
  if (!picture.empty())
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, picture.rows(), 8), develop_rows);
  return picture;
}

}  // namespace coppermoon::colour
