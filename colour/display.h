// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "algebra/grid.h"
#include "colour/working_space.h"

namespace coppermoon::colour {

using Rgb = std::array<float, 3>;
using Image = algebra::Grid<Rgb>;  ///< [row][column], the top row first

/// How a frame becomes a picture.
struct DisplayTransform {
  double scale = 1;  ///< exposure: of every channel, before the view; above 0
  std::string view = "Un-tone-mapped";
  std::string display = "sRGB";
  std::filesystem::path config = {};  ///< an OpenColorIO configuration; empty: the built-in one
};

/// A scene-linear image as a display shows it.
///
/// Returned  display-referred, nominally 0 to 1 and coded for the display. Not clamped: a view may
///           leave values below 0 or above 1, for whoever writes 8 or 16 bits to clip
/// Accuracy  sRGB without tone mapping: 2e-5 of the coded value from IEC 61966-2-1
/// Throws    Error  when a scaled channel is not finite (names the pixel), the scale is not above
///                  0, the configuration cannot be read, has no such view or display (names those it
///                  has) or does not know the working space, or a look-up table of it has an entry
///                  that is not finite (names file and line) or is no regular file, or names such a
///                  file; when what it describes is made of itself, or has no reasonable end
Image developed(Image scene_linear, WorkingSpace space, const DisplayTransform& development = {});

/// A text that tells apart what two developments do to colours, whatever their files are called; it
/// leaves out the scale.
///
/// Throws  Error   as developed
/// Source  OpenColorIO's cache identifier of the processor, which holds the numbers of its tables
std::string fingerprint(WorkingSpace space, const DisplayTransform& development);

/// The displays of a configuration (empty: the built-in one), the default first.
///
/// Throws  Error  when the configuration cannot be read
std::vector<std::string> displays(const std::filesystem::path& config = {});

/// The views that a display has, the default first.
///
/// Throws  Error  when the configuration cannot be read or has no such display
std::vector<std::string> views(const std::string& display = "sRGB",
                               const std::filesystem::path& config = {});

/// A display or view as the configuration spells it, by its name in any case of letters.
///
/// Throws  Error  when the configuration cannot be read or has none of that name: names those it has
std::string display_named(const std::string& name, const std::filesystem::path& config = {});
std::string view_named(const std::string& name, const std::string& display,
                       const std::filesystem::path& config = {});

/// The built-in configuration, as installed in share/coppermoon/config.ocio.
std::string_view config_text();

}  // namespace coppermoon::colour
