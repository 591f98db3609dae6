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

/// Settings that a camera makes of the rounded ones that it shows: whole thirds or halves of a stop. 1/30 s is 1/32 s,
/// f/5.6 is f/5.657, 30 s is 32 s. A setting that no camera shows stays, and a time of more than 30 s.
///
/// Source  CIPA DC-008 (EXIF 2.32), annex C: time values of 5 and 7 are shown as 1/30 and 1/125 s; W. Fulton,
///         scantips.com/lights/fstop2.html: nominal and precise series
double real_time_s(double shown_s);
double real_f_number(double shown);
double real_iso(double shown);

}  // namespace coppermoon::colour
