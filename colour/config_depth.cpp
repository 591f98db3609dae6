// SPDX-License-Identifier: MIT
#include "colour/config_depth.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <fstream>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <system_error>

#include "algebra/error.h"

namespace ocio = OCIO_NAMESPACE;

namespace coppermoon::colour {
namespace {

constexpr int most_depth = 64;
constexpr double most_transforms = 4096;

/// Count of the transforms behind a named space, view or look, with all that those name in turn.
class Unfolding {
 public:
  explicit Unfolding(const ocio::Config& config) : config_(config) {}

  double space(const std::string& named) {
    const auto name = resolved(named);
    if (const auto space = config_.getColorSpace(name.c_str()))
      return once("colour space", space->getName(), [&] {
        return of(space->getTransform(ocio::COLORSPACE_DIR_TO_REFERENCE)) +
               of(space->getTransform(ocio::COLORSPACE_DIR_FROM_REFERENCE));
      });
    if (const auto transform = config_.getNamedTransform(name.c_str()))
      return once("named transform", transform->getName(), [&] {
        return of(transform->getTransform(ocio::TRANSFORM_DIR_FORWARD)) +
               of(transform->getTransform(ocio::TRANSFORM_DIR_INVERSE));
      });
    return 0;
  }

  double view_transform(const std::string& name) {
    const auto transform = config_.getViewTransform(name.c_str());
    if (!transform) return 0;
    return once("view transform", transform->getName(), [&] {
      return of(transform->getTransform(ocio::VIEWTRANSFORM_DIR_TO_REFERENCE)) +
             of(transform->getTransform(ocio::VIEWTRANSFORM_DIR_FROM_REFERENCE));
    });
  }

  double look(const std::string& name) {
    const auto look = config_.getLook(name.c_str());
    if (!look) return 0;
    return once("look", look->getName(), [&] {
      return space(look->getProcessSpace()) + of(look->getTransform()) +
             of(look->getInverseTransform());
    });
  }

  double view(const std::string& named_display, const std::string& named_view,
              const std::string& from = {}) {
    const auto display = resolved(named_display), view = resolved(named_view);
    const char *d = display.c_str(), *v = view.c_str();
    return once("view", display + ", " + view + (from.empty() ? "" : " of " + from), [&] {
      std::string shown = config_.getDisplayViewColorSpaceName(d, v);
      if (shown == ocio::OCIO_VIEW_USE_DISPLAY_NAME) shown = display;
      const std::string looks = config_.getDisplayViewLooks(d, v);
      return space(shown) + view_transform(config_.getDisplayViewTransformName(d, v)) +
             looks_in(looks) + crossing(looks, {from, shown});
    });
  }

 private:
  std::string resolved(const std::string& name) const {
    return config_.getCurrentContext()->resolveStringVar(name.c_str());
  }

  double once(const std::string& kind, const std::string& name,
              const std::function<double()>& count) {
    const auto key = kind + " " + name;
    if (const auto known = sizes_.find(key); known != sizes_.end()) return known->second;
    if (!under_way_.insert(key).second)
      throw algebra::Error(fmt::format("{} \"{}\" is made of itself", kind, name));
    if (under_way_.size() > most_depth)
      throw algebra::Error(fmt::format("{} \"{}\" is made of more than {} others, allowed to {}",
                                       kind, name, most_depth, most_depth));
    const double size = count();
    if (size > most_transforms)
      throw algebra::Error(fmt::format("{} \"{}\" is made of {:g} transforms, allowed to {:g}",
                                       kind, name, size, most_transforms));
    under_way_.erase(key);
    return sizes_[key] = size;
  }

  double of(const ocio::ConstTransformRcPtr& transform) {
    if (const auto group = ocio::DynamicPtrCast<const ocio::GroupTransform>(transform)) {
      double sum = 1;
      for (int i = 0; i < group->getNumTransforms(); ++i) sum += of(group->getTransform(i));
      return sum;
    }
    if (const auto change = ocio::DynamicPtrCast<const ocio::ColorSpaceTransform>(transform))
      return 1 + space(change->getSrc()) + space(change->getDst()) +
             crossing("", {change->getSrc(), change->getDst()});
    if (const auto change = ocio::DynamicPtrCast<const ocio::LookTransform>(transform))
      return 1 + space(change->getSrc()) + space(change->getDst()) + looks_in(change->getLooks()) +
             crossing(change->getLooks(), {change->getSrc(), change->getDst()});
    if (const auto change = ocio::DynamicPtrCast<const ocio::DisplayViewTransform>(transform))
      return 1 + space(change->getSrc()) +
             view(change->getDisplay(), change->getView(), change->getSrc());
    return transform ? 1 : 0;
  }

  /// Names in OpenColorIO's list of looks: "a, +b : -c | d".
  static std::set<std::string> names_in(std::string_view looks) {
    std::set<std::string> names;
    while (!looks.empty()) {
      const auto end = std::min(looks.find_first_of(",:|"), looks.size());
      auto name = looks.substr(0, end);
      looks.remove_prefix(std::min(end + 1, looks.size()));
      name.remove_prefix(std::min(name.find_first_not_of(" \t\n+-"), name.size()));
      names.emplace(name.substr(0, name.find_last_not_of(" \t\n") + 1));
    }
    return names;
  }

  double looks_in(const std::string& looks) {
    double sum = 0;
    for (const auto& name : names_in(resolved(looks))) sum += look(name);
    return sum;
  }

  /// Count of the default view transform, where scene-referred and display-referred spaces meet.
  double crossing(const std::string& looks, std::set<std::string> spaces) {
    for (const auto& name : names_in(resolved(looks)))
      if (const auto look = config_.getLook(name.c_str())) spaces.insert(look->getProcessSpace());
    std::set<ocio::ReferenceSpaceType> kinds;
    for (const auto& name : spaces)
      if (const auto space = config_.getColorSpace(resolved(name).c_str()))
        kinds.insert(space->getReferenceSpaceType());
    const auto between = config_.getDefaultSceneToDisplayViewTransform();
    return kinds.size() < 2 || !between ? 0 : view_transform(between->getName());
  }

  const ocio::Config& config_;
  std::map<std::string, double> sizes_{};
  std::set<std::string> under_way_{};
};

/// Count of aliases ("*name") in a line of YAML; some within quoted text are counted too.
std::ptrdiff_t aliases_in(const std::string& line) {
  const auto begin = line.find_first_not_of(" \t");
  if (begin == std::string::npos || line[begin] == '#') return 0;
  std::ptrdiff_t count = 0;
  for (auto at = line.find('*'); at != std::string::npos; at = line.find('*', at + 1))
    count += at + 1 < line.size() && std::isalnum(static_cast<unsigned char>(line[at + 1])) != 0 &&
             (at == 0 || std::string_view(" \t,:[{-").find(line[at - 1]) != std::string_view::npos);
  return count;
}

}  // namespace

void require_readable(const std::filesystem::path& config) {
  constexpr std::ptrdiff_t most = 16;
  std::error_code none;
  if (std::filesystem::exists(config, none) && !std::filesystem::is_regular_file(config, none))
    throw algebra::Error(fmt::format("{}: cannot be read: it is no regular file", config.string()));
  std::ifstream file(config);
  std::ptrdiff_t aliases = 0;
  for (std::string line; std::getline(file, line);) aliases += aliases_in(line);
  if (aliases > most)
    throw algebra::Error(
        fmt::format("{}: {} aliases of YAML, allowed to {}", config.string(), aliases, most));
}

void require_end(const ocio::Config& config) {
  Unfolding unfolding(config);
  constexpr auto all = ocio::SEARCH_REFERENCE_SPACE_ALL;
  for (int i = 0; i < config.getNumColorSpaces(all, ocio::COLORSPACE_ALL); ++i)
    unfolding.space(config.getColorSpaceNameByIndex(all, ocio::COLORSPACE_ALL, i));
  for (int i = 0; i < config.getNumNamedTransforms(ocio::NAMEDTRANSFORM_ALL); ++i)
    unfolding.space(config.getNamedTransformNameByIndex(ocio::NAMEDTRANSFORM_ALL, i));
  for (int i = 0; i < config.getNumViewTransforms(); ++i)
    unfolding.view_transform(config.getViewTransformNameByIndex(i));
  for (int i = 0; i < config.getNumLooks(); ++i) unfolding.look(config.getLookNameByIndex(i));
  for (int d = 0; d < config.getNumDisplaysAll(); ++d)
    for (const auto type : {ocio::VIEW_DISPLAY_DEFINED, ocio::VIEW_SHARED})
      for (int v = 0; v < config.getNumViews(type, config.getDisplayAll(d)); ++v)
        unfolding.view(config.getDisplayAll(d), config.getView(type, config.getDisplayAll(d), v));
}

}  // namespace coppermoon::colour
