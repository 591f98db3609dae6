// SPDX-License-Identifier: MIT
#include "uses/picture/moon_survey.h"

#include <utility>

#include "texture/bake.h"
#include "uses/light/spectral_bands.h"

namespace coppermoon::uses {

MoonSurvey::MoonSurvey(const MoonRequest& moon, const algebra::Grid<float>& albedo,
                       const Moonlight& light, Photometer meter)
    : photometry_(moon.photometry),
      meter_(std::move(meter)),
      albedo_(albedo),
      ground_(ground_of(moon, albedo)),
      light_(light),
      weights_(ground_ ? reddest_and_bluest(meter_.weights, band_centres_nm()) : meter_.weights),
      shadowed_(light.in_channels(weights_)),
      sunlit_(weights_) {}

texture::Image MoonSurvey::texture(const almanac::SkyState& sky) const {
  return texture::bake({albedo_, sky, range_at(light_, sky) ? shadowed_ : sunlit_, ground_.get()},
                       meter_.channels, albedo_.rows(), photometry_);
}

DiscBrightness MoonSurvey::brightness(const almanac::SkyState& sky) const {
  return measured(meter_, texture(sky), sky);
}

}  // namespace coppermoon::uses
