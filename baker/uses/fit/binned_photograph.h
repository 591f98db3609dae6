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

/// Light of a photograph in the bins of a scene, with standard errors, as grids (bin, channel) in linear Rec.709.
struct BinnedPhotograph {
  algebra::Grid<double> values;       ///< ratio of light to light without the shadow; 0 if unknown
  algebra::Grid<double> errors;       ///< standard errors, from differences between nearby pixels
  algebra::Grid<double> sky_errors;   ///< errors due to the sky, shared by all bins of a channel
  algebra::Grid<double> glow_errors;  ///< errors due to glow, shared by all bins and channels
  algebra::Grid<ToneSlopes> slopes;   ///< tone curve's derivatives; empty if light is linear
};

/// Photometric scale of a photograph, and the standard errors of its photometry.
struct PhotometricErrors {
  std::optional<double> value_per_cd_m2 = {};  ///< pixel value for 1 cd/m², if known
  double exposure_error = 0.1;  ///< standard error of a night's ln(exposure); 10 if unknown
  double shutter_error =
      0.03;  ///< standard error of ln(exposure) of one photograph relative to others of the night
  double white_balance_error = 0.03;  ///< standard errors of ln(red / green) and ln(blue / green)
  /// Whether all photographs of a night have the same white-balance error, because the balance was fixed or recorded.
  bool white_balance_shared = false;
  double white_balance_drift =
      0.003;  ///< further white-balance error of each photograph, if white_balance_shared is true
  double place_error_km = 0;  ///< standard error of the disc's place, towards the shadow's axis
  /// Relative error of red light due to weather along 30 degrees of the limb. See light_by_weather for other channels.
  double weather_error = 0;
  double mixing_error = 0;      ///< error of each off-diagonal element of the colour matrix
  double dark_error = 0;        ///< error of a channel's light, relative to the brightest channel
  double saturation_error = 0;  ///< error of the colour saturation, which JPEG styles vary
};

/// A photograph whose light has been sorted into the bins of its scene.
struct Binned {
  std::size_t photograph = 0;              ///< index of the photograph in its night
  std::optional<CameraColours> colours{};  ///< camera colours, if the camera developed the picture
  std::shared_ptr<const FitScene> scene;
  BinnedPhotograph light;
  PhotometricErrors errors{};
};

/// Averages a photograph's light over each bin of a scene. Clipped pixels are left out. A bin is left out if more than
/// 0.5 % of it is clipped or more than 2 % is black. Light from the sky and glow from the lens are measured beside the
/// disc and subtracted. The glow's prior is 0.03 ± 0.02 of the Moon's light, which is typical of lenses. The subtracted
/// glow has an error of 25 %, because real glow falls off with the angle differently from computed glow.
///
/// Given   render_to_photo  registration of the scene
///         curve            tone curve to undo, pixel by pixel; if absent, light is linear
BinnedPhotograph binned(const FitScene& scene, const MoonPart& moon,
                        const colour::Similarity& render_to_photo,
                        const std::optional<colour::ToneCurve>& curve = {});

}  // namespace coppermoon::uses
