// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "almanac/instant.h"
#include "almanac/observer.h"
#include "texture/image.h"

namespace coppermoon::texture {

/// Where the picture stands in Stellarium's folder: a PNG, recipe and all. Stellarium looks for that name
/// and goes by what the file holds.
inline constexpr const char* stellarium_picture = "textures/moon_4k.jpg";

/// Moment and place at which Stellarium starts.
struct StellariumSight {
  almanac::Instant when;
  almanac::Observer observer;
};

/// Refuses a folder in which a file of somebody's own would be overwritten, one that was changed, or a link;
/// or one where a link stands in the place of a folder in it. The folder need not be there.
///
/// Throws  Error
void require_stellarium_place(const std::filesystem::path& folder);

/// Writes a folder that Stellarium takes for its user's own (`stellarium --user-dir FOLDER`, of its whole path). Its
/// Moon is the picture as it is: no light, phase, shadow, extinction or halo of Stellarium's. It starts with the
/// Moon in the middle, the zenith up, the time standing still, ground and air left out.
///
///     textures/moon_4k.jpg      the picture, of 8 bits
///     data/shaders/planet.frag  draws the Moon as its texture is, and other bodies lit by the Sun
///     scripts/startup.ssc       instant, place and view
///
/// Each file appears whole or not at all; others in the folder stay, Stellarium's own among them. A folder
/// that was not there is not there either when it cannot be written.
///
/// Given     developed   display-referred: sRGB-coded, 0 to 1, grey or RGB; plate carrée, longitude 0 in
///                       the middle, north up, 2:1
///           attributes  written into the picture as text, "coppermoon:recipe" among them
/// Accuracy  the instant to half a second
/// Omits     rings' and satellites' shadows on other planets, their polar caps
/// Throws    Error       as write_png, require_stellarium_place; a folder that cannot be made
/// Source    Stellarium 0.22.2 (Debian 12): data/shaders/planet.vert, data/ssystem_major.ini, its
///           scripting engine
void write_stellarium(const std::filesystem::path& folder, const Layout& layout,
                      const Rows& developed, const StellariumSight& sight,
                      const Attributes& attributes);

}  // namespace coppermoon::texture
