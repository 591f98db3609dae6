// SPDX-License-Identifier: MIT
#include "colour/lut_files.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "algebra/error.h"
#include "algebra/number.h"

namespace ocio = OCIO_NAMESPACE;

namespace coppermoon::colour {
namespace {

/// Files named by a look-up table in CTF, `<Reference path="…"/>`; none in any other format.
///
/// Throws  Error  for a name written in other ways than plainly, in parts or with entities
std::vector<std::string> files_named_in(const std::string& path) {
  constexpr std::streamsize head = 16384;  // OpenColorIO looks for the mark of CTF in 5 kB
  std::ifstream file(path, std::ios::binary);
  std::string text(head, ' ');
  file.read(text.data(), head);
  text.resize(static_cast<std::size_t>(file.gcount()));
  if (text.find("<ProcessList") == text.npos) return {};
  text.append(std::istreambuf_iterator<char>(file), {});
  auto small = text;  // for names of elements and attributes are heeded in either case
  std::ranges::transform(small, small.begin(), [](unsigned char c) { return std::tolower(c); });
  constexpr std::string_view element = "<reference";
  std::vector<std::string> names;
  for (auto at = small.find(element); at != small.npos; at = small.find(element, at)) {
    std::string attribute;
    for (at += element.size(); at < text.size() && text[at] != '>'; ++at) {
      const char c = small[at];
      if (c == '"' || c == '\'') {
        const auto end = std::min(text.find(c, at + 1), text.size());
        if (attribute == "basepath")
          throw algebra::Error(fmt::format("{}: a file named by a basePath, allowed a path", path));
        if (attribute == "path") names.push_back(text.substr(at + 1, end - at - 1));
        attribute.clear();
        at = end;
      } else if (c >= 'a' && c <= 'z') {
        attribute += c;
      }
    }
  }
  if (std::ranges::any_of(names, [](const auto& name) { return name.find('&') != name.npos; }))
    throw algebra::Error(fmt::format("{}: a file's name with & in it, allowed without", path));
  return names;
}

/// Given  from  length of the chain of files that name one another up to this one
void require_regular(const ocio::Config& config, const char* name, int from = 0) {
  constexpr int most = 16;
  std::string path;
  try {
    path = config.getCurrentContext()->resolveFileLocation(name);
  } catch (const ocio::Exception&) {
    return;  // there is none: said where it is needed
  }
  std::error_code failed;
  const auto kind = std::filesystem::status(path, failed).type();
  if (kind != std::filesystem::file_type::not_found && kind != std::filesystem::file_type::regular)
    throw algebra::Error(fmt::format("{}: cannot be read: it is no regular file", path));
  if (kind != std::filesystem::file_type::regular) return;
  if (from > most)
    throw algebra::Error(
        fmt::format("{}: {} files that name one another, allowed to {}", path, from, most));
  for (const auto& file : files_named_in(path)) require_regular(config, file.c_str(), from + 1);
}

void require_regular_in(const ocio::Config& config, const ocio::ConstTransformRcPtr& transform) {
  if (const auto group = ocio::DynamicPtrCast<const ocio::GroupTransform>(transform))
    for (int i = 0; i < group->getNumTransforms(); ++i)
      require_regular_in(config, group->getTransform(i));
  if (const auto file = ocio::DynamicPtrCast<const ocio::FileTransform>(transform))
    require_regular(config, file->getSrc());
}

/// First word of a line that is infinite or NaN, where all words but the first are numbers.
std::optional<std::string> word_that_is_none(std::string line) {
  if (line.starts_with('#') || line.starts_with("TITLE") || line.find_first_of("nN") == line.npos)
    return {};
  std::ranges::replace(line, ',', ' ');
  if (const auto tag = line.find('>'); tag != line.npos) line = line.substr(tag + 1);
  std::istringstream words(line.substr(0, line.find('<')));
  std::optional<std::string> none;
  std::size_t place = 0;
  for (std::string word; words >> word; ++place) {
    const auto number = algebra::number_in(word);
    if (!number && place > 0) return {};
    if (number && !std::isfinite(*number) && !none) none = word;
  }
  return none;
}

void require_finite(const std::string& path) {
  std::ifstream file(path);
  std::size_t number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    if (const auto word = word_that_is_none(line))
      throw algebra::Error(
          fmt::format("{}:{}: {} in a look-up table, allowed finite numbers", path, number, *word));
  }
}

}  // namespace

void require_regular_luts(const ocio::Config& config) {
  const auto look_at = [&](const auto& named, auto... directions) {
    if (named) (require_regular_in(config, named->getTransform(directions)), ...);
  };
  constexpr auto all = ocio::SEARCH_REFERENCE_SPACE_ALL;
  for (int i = 0; i < config.getNumColorSpaces(all, ocio::COLORSPACE_ALL); ++i)
    look_at(config.getColorSpace(config.getColorSpaceNameByIndex(all, ocio::COLORSPACE_ALL, i)),
            ocio::COLORSPACE_DIR_TO_REFERENCE, ocio::COLORSPACE_DIR_FROM_REFERENCE);
  for (int i = 0; i < config.getNumViewTransforms(); ++i)
    look_at(config.getViewTransform(config.getViewTransformNameByIndex(i)),
            ocio::VIEWTRANSFORM_DIR_TO_REFERENCE, ocio::VIEWTRANSFORM_DIR_FROM_REFERENCE);
  for (int i = 0; i < config.getNumNamedTransforms(ocio::NAMEDTRANSFORM_ALL); ++i)
    look_at(
        config.getNamedTransform(config.getNamedTransformNameByIndex(ocio::NAMEDTRANSFORM_ALL, i)),
        ocio::TRANSFORM_DIR_FORWARD, ocio::TRANSFORM_DIR_INVERSE);
  for (int i = 0; i < config.getNumLooks(); ++i)
    if (const auto look = config.getLook(config.getLookNameByIndex(i))) {
      require_regular_in(config, look->getTransform());
      require_regular_in(config, look->getInverseTransform());
    }
}

void require_finite_luts(const ocio::Processor& processor) {
  const auto known = processor.getProcessorMetadata();
  for (int i = 0; i < known->getNumFiles(); ++i) require_finite(known->getFile(i));
}

}  // namespace coppermoon::colour
