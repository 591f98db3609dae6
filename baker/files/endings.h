// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>

#include "algebra/error.h"

namespace coppermoon::files {

/// Format of a file that a command writes. A table of formats adds the function that writes it; help, errors and the
/// docs say of it what stands here.
struct Ending {
  std::string_view ending;  ///< of the file's name: ".png"
  std::string_view help;    ///< what the file holds: "developed"; empty: as its ending says
};

/// ".exr (scene-linear), .png (developed)".
template <class Formats>
std::string in_words(const Formats& formats) {
  std::string words;
  for (const Ending& format : formats)
    words += fmt::format("{}{}{}", words.empty() ? "" : ", ", format.ending,
                         format.help.empty() ? "" : fmt::format(" ({})", format.help));
  return words;
}

/// Format of a file by its name's ending.
///
/// Given   what   is to be written, as "a texture"
/// Throws  Error  for another ending: names all
template <class Formats>
const auto& format_of(const std::filesystem::path& file, const Formats& formats,
                      std::string_view what) {
  const auto found = std::ranges::find_if(
      formats, [&](const Ending& format) { return file.extension() == format.ending; });
  if (found == std::end(formats))
    throw algebra::Error(fmt::format("{}: {} ends in {}", file.string(), what, in_words(formats)));
  return *found;
}

}  // namespace coppermoon::files
