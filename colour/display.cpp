// SPDX-License-Identifier: MIT
#include "colour/display.h"

#include <OpenColorIO/OpenColorIO.h>
#include <fmt/ranges.h>
#include <strings.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "algebra/error.h"
#include "colour/config_depth.h"
#include "colour/lut_files.h"
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

/// Built-in configuration, parsed once: it caches the processors made from it.
ocio::ConstConfigRcPtr built_in_config() {
  static const auto config = [] {
    std::istringstream text{knows_aces2() ? config_text_of_aces2() : std::string(config_text())};
    return ocio::Config::CreateFromStream(text);
  }();
  return config;
}

ocio::ConstConfigRcPtr config_at(const std::filesystem::path& path) try {
  if (path.empty()) return built_in_config();
  require_readable(path);
  auto config = ocio::Config::CreateFromFile(path.c_str());
  require_regular_luts(*config);
  try {
    require_end(*config);
  } catch (const Error& error) {
    throw Error(fmt::format("{}: {}", path.string(), error.what()));
  }
  return config;
} catch (const ocio::Exception& problem) {
  throw Error(fmt::format("{}: {}", path.empty() ? "config.ocio" : path.string(), problem.what()));
}

/// Active ones of a user's configuration; all of the built-in one, whatever OCIO_ACTIVE_DISPLAYS and
/// OCIO_ACTIVE_VIEWS say.
std::vector<std::string> displays_at(const std::filesystem::path& path) {
  const auto config = config_at(path);
  std::vector<std::string> names;
  if (path.empty())
    for (int i = 0; i < config->getNumDisplaysAll(); ++i)
      names.emplace_back(config->getDisplayAll(i));
  else
    for (int i = 0; i < config->getNumDisplays(); ++i) names.emplace_back(config->getDisplay(i));
  return names;
}

std::vector<std::string> views_at(const std::filesystem::path& path, const std::string& display) {
  const auto config = config_at(path);
  const char* of = display.c_str();
  std::vector<std::string> names;
  if (path.empty())
    for (const auto type : {ocio::VIEW_DISPLAY_DEFINED, ocio::VIEW_SHARED})
      for (int i = 0; i < config->getNumViews(type, of); ++i)
        names.emplace_back(config->getView(type, of, i));
  else
    for (int i = 0; i < config->getNumViews(of); ++i) names.emplace_back(config->getView(of, i));
  return names;
}

/// The one of that name: the same letters, else the same in another case.
std::string one_of(std::string_view what, const std::string& name,
                   const std::vector<std::string>& allowed) {
  if (std::ranges::find(allowed, name) != allowed.end()) return name;
  for (const auto& other : allowed)
    if (::strcasecmp(other.c_str(), name.c_str()) == 0) return other;
  throw Error(fmt::format("{} = {}, allowed {}", what, name, fmt::join(allowed, ", ")));
}

/// The first of the space's names that the configuration knows.
std::string known_name(const ocio::Config& config, WorkingSpace space) {
  for (const auto alias : aliases(space))
    if (config.getColorSpace(std::string(alias).c_str())) return std::string(alias);
  throw Error(
      fmt::format("the configuration names no colour space {}", fmt::join(aliases(space), " or ")));
}

ocio::ConstProcessorRcPtr processor(WorkingSpace space, const DisplayTransform& development) try {
  const auto config = config_at(development.config);
  const auto display = display_named(development.display, development.config);
  const auto transform = ocio::DisplayViewTransform::Create();
  transform->setSrc(known_name(*config, space).c_str());
  transform->setDisplay(display.c_str());
  transform->setView(view_named(development.view, display, development.config).c_str());
  auto processor = config->getProcessor(transform);
  require_finite_luts(*processor);
  return processor;
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

std::vector<std::string> displays(const std::filesystem::path& config) {
  return displays_at(config);
}

std::vector<std::string> views(const std::string& display, const std::filesystem::path& config) {
  return views_at(config, display_named(display, config));
}

std::string display_named(const std::string& name, const std::filesystem::path& config) {
  return one_of("display", name, displays_at(config));
}

std::string view_named(const std::string& name, const std::string& display,
                       const std::filesystem::path& config) {
  return one_of("view", name, views(display, config));
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
