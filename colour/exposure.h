// SPDX-License-Identifier: MIT
#pragma once

namespace coppermoon::colour {

/// How a camera is set.
struct Exposure {
  double time_s = 1;    ///< 1e-6 to 1e6
  double f_number = 8;  ///< 0.5 to 512
  double iso = 100;     ///< 1 to 1e7; the saturation-based speed
};

/// Light in the focus at which a sensor of ISO 1 is saturated [lx s].
///
/// Source  ISO 12232
constexpr double saturation_exposure_lx_s = 78;

/// Value that a scene luminance of 1 cd/m² becomes, where 1.0 saturates the sensor.
///
///     value = q L t S / (78 N²),    q = 0.65
///
/// q is the share of the light that a usual lens passes: (π/4)·0.9·0.98·cos⁴10°.
///
/// Returned  per cd/m²; 0.8333 for 1 s at f/1 and ISO 100, so that 1.2 cd/m² saturate
/// Omits     the lens's own transmission and vignetting, the failure of reciprocity of film
/// Throws    Error  when a setting is outside its range
/// Source    ISO 12232
double exposure_scale(const Exposure& exposure);

}  // namespace coppermoon::colour
