// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "almanac/instant.h"
#include "almanac/observer.h"
#include "texture/image.h"

namespace coppermoon::texture {

/// Path of the Moon's picture in Stellarium's folder. The file is a PNG that includes the settings used. Stellarium
/// expects this name, but recognises the format from the contents.
inline constexpr const char* stellarium_picture = "textures/moon_4k.jpg";

/// Moment and place with which Stellarium starts.
struct StellariumSight {
  almanac::Instant when;
  almanac::Observer observer;
};

/// Refuses a folder if writing there would overwrite a link, a file that coppermoon did not write, or a file that was
/// changed since, or if a link stands in place of a subfolder. The folder need not exist.
///
/// Throws  Error
void require_stellarium_place(const std::filesystem::path& folder);

/// Writes a folder that Stellarium can use as its user folder (`stellarium --user-dir FOLDER`, with the full path). The
/// Moon there shows the picture as it is, without Stellarium's own light, phase, shadow, extinction or halo. Stellarium
/// starts with the Moon in the middle, the zenith up, time stopped, and without ground and air.
///
///     textures/moon_4k.jpg      the picture, with 8 bits
///     data/shaders/planet.frag  draws the Moon with the light in its texture, and other bodies lit by the Sun
///     scripts/startup.ssc       sets the instant, place and view
///
/// Each file is written whole or not at all. Other files in the folder stay, including Stellarium's own. If writing
/// fails, the folder is removed, unless it existed before.
///
/// Given     developed   display-referred: sRGB-coded, 0 to 1, grey or RGB; plate carrée, longitude 0 in the middle,
///                       north up, 2:1
///           attributes  written into the picture as text, including "coppermoon:recipe"
/// Accuracy  half a second in the instant
/// Omits     other planets' polar caps, and shadows of rings and satellites on them
/// Throws    Error       as for write_png and require_stellarium_place; when a folder cannot be made
/// Source    Stellarium 0.22.2 (Debian 12): data/shaders/planet.vert, data/ssystem_major.ini, its scripting engine
void write_stellarium(const std::filesystem::path& folder, const Layout& layout,
                      const Rows& developed, const StellariumSight& sight,
                      const Attributes& attributes);

}  // namespace coppermoon::texture
