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
/// A user's configuration may not know the image's colour space. A matrix then converts the image to the first of these
/// that the configuration has: the role aces_interchange; the role cie_xyz_d65_interchange, if it is scene-referred;
/// the role scene_linear, if its name or an alias says which space it is; a space with one of our `aliases`; one with a
/// common name, such as "ACES - ACEScg"; "Linear", which is Rec.709 in Blender.
///
/// Returned  display-referred image, nominally 0 to 1 and coded for the display. It is not clamped: a view may leave
///           values below 0 or above 1, to be clipped when 8 or 16 bits are written
/// Accuracy  for sRGB without tone mapping: within 2e-5 of the coded value according to IEC 61966-2-1
/// Throws    Error  when a scaled channel is not finite (the message names the pixel); when the scale is not above 0;
///                  when the configuration cannot be read, lacks the view or the display (the message lists those it
///                  has), knows none of these spaces, or lacks config_space; when it would keep OpenColorIO busy for
///                  ever because it refers to itself, or because a look-up table is not a regular file or names another
Image developed(Image scene_linear, WorkingSpace space, const DisplayTransform& development = {});

/// Identifier of a colour transform. It depends on the contents of look-up tables, but neither on their file names nor
/// on the scale.
///
/// Throws  Error   as for developed
/// Source  OpenColorIO's cache identifier of the processor, which includes the numbers in its tables
std::string fingerprint(WorkingSpace space, const DisplayTransform& development);

/// Returns `config`, or $OCIO if `config` is empty and the built-in configuration lacks the view or the display.
std::filesystem::path config_for(const std::string& view, const std::string& display,
                                 const std::filesystem::path& config);

/// Active displays of a configuration, the default first. An empty `config` means the built-in configuration, with all
/// its displays. A path ocio://… means a configuration that comes with OpenColorIO 2.2 or later.
///
/// Throws  Error  when the configuration cannot be read
std::vector<std::string> displays(const std::filesystem::path& config = {});

/// Views of a display, the default first. In a user's configuration, only active views count.
///
/// Throws  Error  when the configuration cannot be read or has no such display
std::vector<std::string> views(const std::string& display = "sRGB",
                               const std::filesystem::path& config = {});

/// A display's or view's name as the configuration spells it, found without regard to case. If the configuration lacks
/// the view Hue-preserving but has the view Un-tone-mapped, the former name stands for the latter.
///
/// Throws  Error  when the configuration cannot be read or has no display or view of that name; the message lists all
std::string display_named(const std::string& name, const std::filesystem::path& config = {});
std::string view_named(const std::string& name, const std::string& display,
                       const std::filesystem::path& config = {});

/// Text of the built-in configuration, the one installed as share/coppermoon/config.ocio.
std::string_view config_text();

/// Text of the built-in configuration for OpenColorIO 2.4 and later. It has the views of ACES 2, which these versions
/// know, in addition to all others.
std::string config_text_of_aces2();

}  // namespace coppermoon::colour
