// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>

#include "algebra/error.h"

namespace coppermoon::files {

/// A file format that a command can write, as it is described in help, error messages and the documentation. The
/// formats of a command derive from this struct and add the function that writes the file.
struct Ending {
  std::string_view ending;  ///< ending of the file's name, such as ".png"
  std::string_view help;    ///< what the file holds, such as "scene-linear"; may be empty
};

/// The formats as a list for readers, such as ".exr (scene-linear), .png (developed)".
template <class Formats>
std::string in_words(const Formats& formats) {
  std::string words;
  for (const Ending& format : formats)
    words += fmt::format("{}{}{}", words.empty() ? "" : ", ", format.ending,
                         format.help.empty() ? "" : fmt::format(" ({})", format.help));
  return words;
}

/// Finds the format of a file by the ending of its name.
///
/// Given   what   what is to be written, such as "a texture"
/// Throws  Error  if the ending is unknown; the message lists all known ones
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
