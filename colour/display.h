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

/// Exposure, view and display that make a picture of a scene-linear frame.
struct DisplayTransform {
  double scale = 1;  ///< exposure: factor of every channel before the view; above 0
  std::string view = "Hue-preserving";
  std::string display = "sRGB";
  std::filesystem::path config = {};  ///< an OpenColorIO configuration; empty: the built-in one
  std::string config_space =
      {};  ///< its colour space that the image is in; empty: found by roles and names
};

/// Scene-linear image transformed for a display.
///
/// A configuration of the user's need not know the image's colour space. The first of these that it has is taken, and
/// a matrix leads there: the role aces_interchange; cie_xyz_d65_interchange, where that is scene-referred; scene_linear,
/// where its name or an alias says which space it is; a space with one of `aliases`; one with a common name, as
/// "ACES - ACEScg"; "Linear", which is Rec.709 in Blender.
///
/// Returned  display-referred, nominally 0 to 1 and coded for the display. Not clamped: a view may
///           leave values below 0 or above 1, for whoever writes 8 or 16 bits to clip
/// Accuracy  sRGB without tone mapping: 2e-5 of the coded value from IEC 61966-2-1
/// Throws    Error  when a scaled channel is not finite (names the pixel), the scale is not above
///                  0, the configuration cannot be read, has no such view or display (names those it
///                  has), knows none of these spaces, or has no config_space; when it would keep
///                  OpenColorIO busy for ever: it is made of itself, or a look-up table is no
///                  regular file or names another
Image developed(Image scene_linear, WorkingSpace space, const DisplayTransform& development = {});

/// Identifier of a colour transform, equal for equal tables whatever their files are called; the scale is left
/// out.
///
/// Throws  Error   as developed
/// Source  OpenColorIO's cache identifier of the processor, which holds the numbers of its tables
std::string fingerprint(WorkingSpace space, const DisplayTransform& development);

/// Configuration for a view and a display: `config`; where that is empty and the built-in one lacks either, $OCIO.
std::filesystem::path config_for(const std::string& view, const std::string& display,
                                 const std::filesystem::path& config);

/// Displays of a configuration (empty: the built-in one, all; ocio://…: one of OpenColorIO's own, from 2.2 on), the
/// active ones, the default first.
///
/// Throws  Error  when the configuration cannot be read
std::vector<std::string> displays(const std::filesystem::path& config = {});

/// Views of a display, of a user's configuration the active ones, the default first.
///
/// Throws  Error  when the configuration cannot be read or has no such display
std::vector<std::string> views(const std::string& display = "sRGB",
                               const std::filesystem::path& config = {});

/// Display or view as the configuration spells it, found in any case of letters. A configuration that has no
/// Hue-preserving shows its Un-tone-mapped instead, if it has that.
///
/// Throws  Error  when the configuration cannot be read or has none of that name: names those it has
std::string display_named(const std::string& name, const std::filesystem::path& config = {});
std::string view_named(const std::string& name, const std::string& display,
                       const std::filesystem::path& config = {});

/// Text of the built-in configuration, as installed in share/coppermoon/config.ocio.
std::string_view config_text();

/// Text of the built-in configuration where OpenColorIO knows ACES 2 (2.4 and later): the views of ACES 2 stand beside
/// all others.
std::string config_text_of_aces2();

}  // namespace coppermoon::colour
