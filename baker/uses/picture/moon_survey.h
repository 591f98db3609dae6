// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "uses/light/photometer.h"
#include "uses/picture/moon.h"

namespace coppermoon::uses {

/// Whole Moon of one eclipse, measured at any of its moments: from the Earth's centre.
class MoonSurvey {
 public:
  /// Given  albedo  normal, of as many rows as its textures get
  ///        light   on the Moon's way, for as long as the survey
  ///        meter   its channels
  MoonSurvey(const MoonRequest& moon, const algebra::Grid<float>& albedo, const Moonlight& light,
             Photometer meter = photometer());

  /// Texture in the meter's channels.
  texture::Image texture(const almanac::SkyState& sky) const;

  /// Of a survey in the photometer's channels.
  DiscBrightness brightness(const almanac::SkyState& sky) const;

 private:
  surface::Photometry photometry_;
  Photometer meter_;
  algebra::Grid<float> albedo_;
  std::shared_ptr<const surface::Ground> ground_;
  const Moonlight& light_;
  shadow::ChannelWeights weights_;
  shadow::Lookup shadowed_, sunlit_;
};

}  // namespace coppermoon::uses
