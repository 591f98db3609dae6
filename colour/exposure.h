// SPDX-License-Identifier: MIT
#pragma once

namespace coppermoon::colour {

/// Exposure settings of a camera.
struct Exposure {
  double time_s = 1;    ///< allowed: 1e-6 to 1e6
  double f_number = 8;  ///< allowed: 0.5 to 512
  double iso = 100;     ///< saturation-based speed, 1 to 1e7
};

/// Focal-plane exposure that saturates a sensor at ISO 1 [lx s].
///
/// Source  ISO 12232
constexpr double saturation_exposure_lx_s = 78;

/// Pixel value for a scene luminance of 1 cd/m², on a scale on which 1.0 saturates the sensor.
///
///     value = q L t S / (78 N²),    q = 0.65      L: luminance, t: time, S: ISO speed, N: f-number
///
/// q is the share of the light that a typical lens passes: (π/4)·0.9·0.98·cos⁴10°.
///
/// Returned  value per cd/m²: 0.8333 for 1 s at f/1 and ISO 100, so that 1.2 cd/m² saturates
/// Omits     the actual lens's transmission and vignetting, and reciprocity failure in film
/// Throws    Error  when a setting is outside its range
/// Source    ISO 12232
double exposure_scale(const Exposure& exposure);

/// Exact settings, in whole thirds or halves of a stop, for the rounded ones that a camera shows: 1/30 s is really 1/32
/// s, f/5.6 is f/5.657, 30 s is 32 s. Settings that no camera shows are returned unchanged, as are times above 30 s.
///
/// Source  CIPA DC-008 (EXIF 2.32), annex C: time values of 5 and 7 are shown as 1/30 and 1/125 s; W. Fulton,
///         scantips.com/lights/fstop2.html: nominal and precise series
double real_time_s(double shown_s);
double real_f_number(double shown);
double real_iso(double shown);

}  // namespace coppermoon::colour
