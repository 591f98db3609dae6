// SPDX-License-Identifier: MIT
#include "colour/config_guard.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>

#include "algebra/error.h"

namespace ocio = OCIO_NAMESPACE;

namespace coppermoon::colour {
namespace {

using algebra::Error;
namespace fs = std::filesystem;

/// Throws  Error  if the path leads to anything but a regular file
void require_regular(const fs::path& path) {
  std::error_code none;
  if (fs::exists(path, none) && !fs::is_regular_file(path, none))
    throw Error(fmt::format("{}: cannot be read: it is no regular file", path.string()));
}

/// Throws  Error  for too many YAML aliases ("*name"). Quoted text that looks like an alias may be counted, too.
void require_few_aliases(const fs::path& config) {
  constexpr std::ptrdiff_t most = 16;
  static const std::regex comment("\\s*#.*"), alias("(^|[\\s,:\\[{-])\\*[A-Za-z0-9]");
  std::ifstream file(config);
  std::ptrdiff_t aliases = 0;
  for (std::string line; std::getline(file, line);)
    if (line.find('*') != line.npos && !std::regex_match(line, comment))
      aliases += std::distance(std::sregex_iterator(line.begin(), line.end(), alias), {});
  if (aliases > most)
    throw Error(
        fmt::format("{}: {} aliases of YAML, allowed to {}", config.string(), aliases, most));
}

/// Throws  Error  for a CTF look-up table that refers to another file
void require_no_reference(const fs::path& table) {
  constexpr std::size_t head = 16384;  // OpenColorIO looks for the mark of a CTF in the first 5 kB
  std::ifstream file(table, std::ios::binary);
  std::string text(head, ' ');
  file.read(text.data(), head);
  if (text.find("<ProcessList") == text.npos) return;
  text.append(std::istreambuf_iterator<char>(file), {});
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
  if (text.find("<reference") != text.npos)
    throw Error(fmt::format("{}: a look-up table that names another file, allowed one without",
                            table.string()));
}

/// Visits every named element of a configuration and, in turn, all elements to which it refers. The size of an element
/// is its number of transforms, including those of the elements to which it refers.
class Walk {
 public:
  explicit Walk(const ocio::Config& config) : config_(config) {}

  void all() {
    constexpr auto all = ocio::SEARCH_REFERENCE_SPACE_ALL;
    for (int i = 0; i < config_.getNumColorSpaces(all, ocio::COLORSPACE_ALL); ++i)
      space(config_.getColorSpaceNameByIndex(all, ocio::COLORSPACE_ALL, i));
    for (int i = 0; i < config_.getNumNamedTransforms(ocio::NAMEDTRANSFORM_ALL); ++i)
      space(config_.getNamedTransformNameByIndex(ocio::NAMEDTRANSFORM_ALL, i));
    for (int i = 0; i < config_.getNumViewTransforms(); ++i)
      view_transform(config_.getViewTransformNameByIndex(i));
    for (int i = 0; i < config_.getNumLooks(); ++i) looks_in(config_.getLookNameByIndex(i));
    for (int d = 0; d < config_.getNumDisplaysAll(); ++d)
      for (const auto type : {ocio::VIEW_DISPLAY_DEFINED, ocio::VIEW_SHARED})
        for (int v = 0; v < config_.getNumViews(type, config_.getDisplayAll(d)); ++v)
          view(config_.getDisplayAll(d), config_.getView(type, config_.getDisplayAll(d), v));
  }

 private:
  std::string resolved(const std::string& name) const {
    return config_.getCurrentContext()->resolveStringVar(name.c_str());
  }

  double once(const std::string& kind, const std::string& name,
              const std::function<double()>& size_of) {
    constexpr int most_depth = 64;
    constexpr double most_transforms = 4096;
    const auto key = fmt::format("{} \"{}\"", kind, name);
    if (const auto known = sizes_.find(key); known != sizes_.end()) return known->second;
    if (!under_way_.insert(key).second) throw Error(key + " is made of itself");
    if (under_way_.size() > most_depth)
      throw Error(fmt::format("{} is made of more than {} others, allowed to {}", key, most_depth,
                              most_depth));
    const double size = size_of();
    if (size > most_transforms)
      throw Error(fmt::format("{} is made of {:g} transforms, allowed to {:g}", key, size,
                              most_transforms));
    under_way_.erase(key);
    return sizes_[key] = size;
  }

  /// Number of an element's transforms, summed over both directions; 0 if the element does not exist.
  template <class Named, class Direction>
  double both_ways(const char* kind, const Named& named, Direction there, Direction back) {
    if (!named) return 0;
    return once(kind, named->getName(),
                [&] { return of(named->getTransform(there)) + of(named->getTransform(back)); });
  }

  double space(const std::string& named) {
    const auto name = resolved(named);
    return both_ways("colour space", config_.getColorSpace(name.c_str()),
                     ocio::COLORSPACE_DIR_TO_REFERENCE, ocio::COLORSPACE_DIR_FROM_REFERENCE) +
           both_ways("named transform", config_.getNamedTransform(name.c_str()),
                     ocio::TRANSFORM_DIR_FORWARD, ocio::TRANSFORM_DIR_INVERSE);
  }

  double view_transform(const char* name) {
    return both_ways("view transform", config_.getViewTransform(name),
                     ocio::VIEWTRANSFORM_DIR_TO_REFERENCE, ocio::VIEWTRANSFORM_DIR_FROM_REFERENCE);
  }

  double view(const std::string& named_display, const std::string& named_view,
              const std::string& from = {}) {
    const auto display = resolved(named_display), view = resolved(named_view);
    const char *d = display.c_str(), *v = view.c_str();
    return once("view", display + ", " + view + (from.empty() ? "" : " of " + from), [&] {
      std::string shown = config_.getDisplayViewColorSpaceName(d, v);
      if (shown == ocio::OCIO_VIEW_USE_DISPLAY_NAME) shown = display;
      return view_transform(config_.getDisplayViewTransformName(d, v)) +
             between(from, shown, config_.getDisplayViewLooks(d, v));
    });
  }

  double of(const ocio::ConstTransformRcPtr& transform) {
    if (const auto group = ocio::DynamicPtrCast<const ocio::GroupTransform>(transform)) {
      double sum = 1;
      for (int i = 0; i < group->getNumTransforms(); ++i) sum += of(group->getTransform(i));
      return sum;
    }
    if (const auto change = ocio::DynamicPtrCast<const ocio::ColorSpaceTransform>(transform))
      return 1 + between(change->getSrc(), change->getDst());
    if (const auto change = ocio::DynamicPtrCast<const ocio::LookTransform>(transform))
      return 1 + between(change->getSrc(), change->getDst(), change->getLooks());
    if (const auto change = ocio::DynamicPtrCast<const ocio::DisplayViewTransform>(transform))
      return 1 + space(change->getSrc()) +
             view(change->getDisplay(), change->getView(), change->getSrc());
    if (const auto file = ocio::DynamicPtrCast<const ocio::FileTransform>(transform))
      require_table(file->getSrc());
    return transform ? 1 : 0;
  }

  void require_table(const char* name) const try {
    const fs::path path = config_.getCurrentContext()->resolveFileLocation(name);
    require_regular(path);
    require_no_reference(path);
  } catch (const ocio::Exception&) {  // a missing file is reported when it is needed
  }

  /// Number of transforms in a list of looks, such as "a, +b : -c | d". Adds the looks' process spaces to `spaces`.
  double looks_in(const std::string& looks, std::set<std::string>* spaces = nullptr) {
    static const std::regex name("[^,:|+\\-\\s](?:[^,:|]*[^,:|\\s])?");
    const auto list = resolved(looks);
    double sum = 0;
    for (std::sregex_iterator found(list.begin(), list.end(), name), end; found != end; ++found)
      if (const auto look = config_.getLook(found->str().c_str())) {
        if (spaces) spaces->insert(look->getProcessSpace());
        sum += once("look", look->getName(), [&] {
          return space(look->getProcessSpace()) + of(look->getTransform()) +
                 of(look->getInverseTransform());
        });
      }
    return sum;
  }

  /// Number of transforms in the conversion from one colour space through looks to another. The default view transform
  /// is included if some of the spaces are scene-referred and others display-referred.
  double between(const std::string& from, const std::string& to, const std::string& looks = {}) {
    std::set<std::string> spaces{from, to};
    const double sum = space(from) + space(to) + looks_in(looks, &spaces);
    std::set<ocio::ReferenceSpaceType> kinds;
    for (const auto& name : spaces)
      if (const auto space = config_.getColorSpace(resolved(name).c_str()))
        kinds.insert(space->getReferenceSpaceType());
    const auto crossing = config_.getDefaultSceneToDisplayViewTransform();
    return kinds.size() < 2 || !crossing ? sum : sum + view_transform(crossing->getName());
  }

  const ocio::Config& config_;
  std::map<std::string, double> sizes_{};
  std::set<std::string> under_way_{};
};

}  // namespace

ocio::ConstConfigRcPtr guarded_config(const fs::path& path) {
  require_regular(path);
  require_few_aliases(path);
  auto config = ocio::Config::CreateFromFile(path.string().c_str());
  try {
    Walk(*config).all();
  } catch (const Error& error) {
    throw Error(fmt::format("{}: {}", path.string(), error.what()));
  }
  return config;
}

}  // namespace coppermoon::colour
