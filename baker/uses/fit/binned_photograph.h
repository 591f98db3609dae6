// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "colour/tone_curve.h"
#include "uses/fit/moon_in_photograph.h"
#include "uses/picture/camera_colours.h"

namespace coppermoon::uses {

/// Derivatives of the logarithm of a bin's light with respect to the parameters of a tone curve.
using ToneSlopes = std::array<double, colour::tone_numbers>;

/// A photograph's light in the bins of a scene, with standard errors: grids (bin, channel) in linear Rec.709.
struct BinnedPhotograph {
  algebra::Grid<double> values;       ///< ratio of light to sunlit light; 0 if unknown
  algebra::Grid<double> errors;       ///< of the values, from differences between nearby pixels
  algebra::Grid<double> sky_errors;   ///< due to the sky, shared by all bins of a channel
  algebra::Grid<double> glow_errors;  ///< due to glow, shared by all bins and channels
  algebra::Grid<ToneSlopes> slopes;   ///< empty if light is linear and needs no curve
};

/// Photometric scale of a photograph, and its standard errors.
struct PhotometricErrors {
  std::optional<double> value_per_cd_m2 = {};  ///< pixel value of 1 cd/m², if known
  double exposure_error = 0.1;  ///< of the logarithm of a night's exposure; 10 if unknown
  double shutter_error =
      0.03;  ///< of the logarithm of the photograph's exposure relative to others
  double white_balance_error = 0.03;  ///< of the logarithms of red / green and blue / green
  /// Whether photographs of a night share the error of their white balance, because it was fixed or is known as shot.
  bool white_balance_shared = false;
  double white_balance_drift =
      0.003;  ///< of the same logarithms in each photograph, if they share that error
  double place_error_km = 0;  ///< of the disc's place, towards the shadow's axis
  /// relative error of red light due to the weather along 30 degrees of the limb; see light_by_weather for others
  double weather_error = 0;
  double mixing_error = 0;      ///< of each off-diagonal element of the camera's matrix
  double dark_error = 0;        ///< of each channel's light, relative to the brightest channel's
  double saturation_error = 0;  ///< of the saturation of its colours, which JPEG styles vary
};

/// A photograph in the bins of its scene.
struct Binned {
  std::size_t photograph = 0;              ///< index in the night
  std::optional<CameraColours> colours{};  ///< of the camera, if it developed the photograph itself
  std::shared_ptr<const FitScene> scene;
  BinnedPhotograph light;
  PhotometricErrors errors{};
};

/// Bins a photograph's light. Clipped pixels are left out, and so is a bin if more than 0.5 % of it is clipped or more
/// than 2 % is black. Light from the sky and glow from the lens, measured beside the disc, are subtracted. The glow's
/// prior is 0.03 ± 0.02 of the Moon's light, which is typical of lenses. The subtracted glow has an error of 25 %,
/// because the glow of real lenses falls off with the angle differently from the computed glow.
///
/// Given   render_to_photo  registration of the scene
///         curve            tone curve to undo, pixel by pixel; if absent, light is linear
BinnedPhotograph binned(const FitScene& scene, const MoonPart& moon,
                        const colour::Similarity& render_to_photo,
                        const std::optional<colour::ToneCurve>& curve = {});

}  // namespace coppermoon::uses
