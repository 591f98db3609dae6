// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "almanac/sky.h"
#include "uses/light/shadow_profile.h"

namespace coppermoon::uses {

/// Shadow of a strip.
struct StripShadow : ShadowCut {
  std::optional<almanac::SkyState> sky;   ///< where the Moon stands in it
  std::optional<std::string> response{};  ///< as in colour::channel_weights
};

/// Writes the shadow as a look-up for shaders: light on ground that faces the Sun, as reddish as
/// the Moon, over full sunlight, channel by channel of linear Rec.709, so that full sunlight is
/// 1, 1, 1. And a .json of the same name beside it, that says how to find a texel.
///
/// 1024 columns, the first on the axis, the last where the penumbra ends, evenly; rows at even
/// position angles from celestial north through east, one row where the shadow is alike all around.
///
/// Given     file      .exr; or .cube, for one row
/// Returned  contents of the .json
/// Accuracy  straight lines between columns err by less than 0.5 % of the brightest channel where that
///           is more than 1e-4. Times a sunlit Moon: within 2.5 % of the brightest channel of a baked
///           one, within 0.5 % where more than 1 % of sunlight is left
/// Omits     all planes but one: light at another depth is found along lines from the limb
///           (shadow::sheared), half a lunar radius away within 1.5 %, near the axis 3 %
/// Throws    Error     when the file's name ends otherwise, a .cube would need rows, or a file cannot
///                     be written
nlohmann::ordered_json write_shadow_strip(const std::filesystem::path& file,
                                          const StripShadow& shadow, const LightRequest& request,
                                          const std::string& recipe,
                                          const algebra::Progress& progress = {});

}  // namespace coppermoon::uses
