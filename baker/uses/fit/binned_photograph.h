// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "colour/tone_curve.h"
#include "uses/fit/photograph.h"

namespace coppermoon::uses {

/// Derivatives of the logarithm of a bin's light by the numbers of a tone curve.
using ToneSlopes = std::array<double, colour::tone_numbers>;

/// Light of a photograph in the bins of a scene, (bin, channel), linear Rec.709, with standard errors.
struct BinnedPhotograph {
  algebra::Grid<double> values;       ///< light over sunlit light; 0: unknown
  algebra::Grid<double> errors;       ///< of the values, from differences of near pixels
  algebra::Grid<double> sky_errors;   ///< of the sky's light, common to the bins of a channel
  algebra::Grid<double> glow_errors;  ///< of the glow's light, common to bins and channels
  algebra::Grid<ToneSlopes> slopes;   ///< empty: linear light, no curve is in question
};

/// Photometric scale of a photograph, and its standard errors.
struct PhotometricErrors {
  std::optional<double> value_per_cd_m2 = {};  ///< pixel value of 1 cd/m²; without: unknown
  double exposure_error = 0.1;  ///< of the exposure's logarithm, common to a night; 10: unknown
  double shutter_error = 0.03;  ///< of the logarithm of this exposure beside the night's others
  double white_balance_error = 0.03;  ///< of the logarithms of red and blue over green
  bool white_balance_fixed = false;   ///< common to a night; else each photograph has its own
  double place_error_km = 0;          ///< of the registration, towards the shadow's axis
  /// of a part of the limb 30 degrees wide by its weather, in red; a fifth more in green, half more in blue
  double weather_error = 0;
  double mixing_error = 0;      ///< of each element of the camera's matrix off its diagonal
  double saturation_error = 0;  ///< of the saturation of its colours, as styles of JPEG have it
};

/// A photograph in the bins of its scene.
struct Binned {
  std::size_t photograph = 0;  ///< of the night
  std::shared_ptr<const FitScene> scene;
  BinnedPhotograph light;
  PhotometricErrors errors{};
};

/// Bins a photograph's light. Clipped pixels are left out; a bin is left out of which more than 0.5 % is clipped or
/// more than 2 % is black. Light of the sky and glow of the lens, measured beside the disc, are subtracted. The prior
/// of the glow is 0.03 ± 0.02 of the light, as lenses have it. The glow subtracted has an error of a quarter of it,
/// for the glow of real lenses falls by other powers of the angle.
///
/// Given   render_to_photo  registration of the scene
///         curve            tone curve to be undone, pixel by pixel; without: light is linear
BinnedPhotograph binned(const FitScene& scene, const MoonPart& moon,
                        const colour::Similarity& render_to_photo,
                        const std::optional<colour::ToneCurve>& curve = {});

}  // namespace coppermoon::uses
