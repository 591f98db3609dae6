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

/// Exposure, view and display that turn a scene-linear frame into a picture.
struct DisplayTransform {
  double scale = 1;  ///< exposure: factor applied to every channel before the view; above 0
  std::string view = "Hue-preserving";
  std::string display = "sRGB";
  std::filesystem::path config = {};  ///< OpenColorIO configuration; if empty, the built-in one
  std::string config_space =
      {};  ///< the image's colour space in the configuration; if empty, found by roles and names
};

/// Transforms a scene-linear image for a display.
///
/// A user's configuration may not know the image's colour space. A matrix then leads to the first of these that the
/// configuration has: the role aces_interchange; cie_xyz_d65_interchange, if that is scene-referred; scene_linear,
/// if its name or an alias says which space it is; a space with one of `aliases`; one with a common name such as
/// "ACES - ACEScg"; "Linear", which is Rec.709 in Blender.
///
/// Returned  display-referred, nominally 0 to 1 and coded for the display. Not clamped: a view may
///           leave values below 0 or above 1, to be clipped when 8 or 16 bits are written
/// Accuracy  sRGB without tone mapping: within 2e-5 of the coded value by IEC 61966-2-1
/// Throws    Error  when a scaled channel is not finite (names the pixel), the scale is not above
///                  0, the configuration cannot be read, has no such view or display (names those it
///                  has), knows none of these spaces, or has no config_space; when it would keep
///                  OpenColorIO busy for ever: it refers to itself, or a look-up table is not a
///                  regular file or names another
Image developed(Image scene_linear, WorkingSpace space, const DisplayTransform& development = {});

/// Identifier of a colour transform. Equal tables give equal identifiers, whatever their files are called; the scale
/// does not matter.
///
/// Throws  Error   as developed
/// Source  OpenColorIO's cache identifier of the processor, which holds the numbers of its tables
std::string fingerprint(WorkingSpace space, const DisplayTransform& development);

/// Configuration for a view and a display: `config`, or $OCIO if that is empty and the built-in one lacks either.
std::filesystem::path config_for(const std::string& view, const std::string& display,
                                 const std::filesystem::path& config);

/// Active displays of a configuration, the default first. If empty, `config` means the built-in configuration, with all
/// its displays; ocio://… is one of OpenColorIO's own, available from 2.2 on.
///
/// Throws  Error  when the configuration cannot be read
std::vector<std::string> displays(const std::filesystem::path& config = {});

/// Views of a display, the default first; only the active ones of a user's configuration.
///
/// Throws  Error  when the configuration cannot be read or has no such display
std::vector<std::string> views(const std::string& display = "sRGB",
                               const std::filesystem::path& config = {});

/// Display or view as the configuration spells it, matched without regard to case. In a configuration without
/// Hue-preserving, that name stands for Un-tone-mapped if present.
///
/// Throws  Error  when the configuration cannot be read, or has nothing of that name; lists those it has
std::string display_named(const std::string& name, const std::filesystem::path& config = {});
std::string view_named(const std::string& name, const std::string& display,
                       const std::filesystem::path& config = {});

/// Text of the built-in configuration, the one installed as share/coppermoon/config.ocio.
std::string_view config_text();

/// Text of the built-in configuration for an OpenColorIO that knows ACES 2 (2.4 and later). It adds the views of ACES 2
/// to all others.
std::string config_text_of_aces2();

}  // namespace coppermoon::colour
