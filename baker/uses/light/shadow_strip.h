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

/// Writes the shadow as a look-up texture for shaders: ratio of light on ground of the Moon's colour that faces the
/// Sun to the same in full sunlight, in each channel of linear Rec.709, so that full sunlight is 1, 1, 1. A .json of
/// the same name describes how to find a texel.
///
/// 1024 columns, equally spaced from the axis to the end of the penumbra; rows at equally spaced position angles from
/// celestial north through east, one row where the shadow is symmetric about the axis.
///
/// Given     file      .exr; or .cube, for one row
/// Returned  contents of the .json
/// Accuracy  linear interpolation between columns errs by less than 0.5 % of the brightest channel where that
///           is more than 1e-4. A sunlit Moon times the strip is within 2.5 % of the brightest channel of a baked
///           Moon, within 0.5 % where more than 1 % of sunlight is left
/// Omits     other planes: light at another depth is read along lines from the limb (shadow::sheared); half a
///           lunar radius away it errs by 1.5 %, near the axis by 3 %
/// Throws    Error     when the file's name has another ending, a .cube would need several rows, or a file
///                     cannot be written
nlohmann::ordered_json write_shadow_strip(const std::filesystem::path& file,
                                          const StripShadow& shadow, const LightRequest& request,
                                          const std::string& recipe,
                                          const algebra::Progress& progress = {});

}  // namespace coppermoon::uses
