// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>

#include "algebra/grid.h"
#include "colour/registration.h"
#include "texture/image.h"
#include "uses/fit/fit_scene.h"

namespace coppermoon::uses {

/// The part of a photograph that shows the Moon and its surroundings, shrunk by an integer factor. After shrinking, the
/// disc is at least 1.5 times as wide as in a FitScene, unless it was smaller before. Each pixel replaces a square of
/// pixels. It has their greatest value if any of them may be clipped, else 0 if most are black, else their mean.
struct MoonPart {
  texture::Image photo;
  algebra::Grid<float> luminance = {};  ///< luminance of `photo`
  algebra::Grid<float> clipped =
      {};                   ///< luminance, set to its greatest value where any channel is clipped
  colour::Disc disc = {};   ///< the Moon's disc in `photo`
  double shrunk = 1;        ///< factor by which `photo` was shrunk
  bool is_burnt = false;    ///< whether any pixel may be clipped
  float saturated = 0.97F;  ///< level above which a channel is no longer proportional to light
  std::array<double, 3> steps =
      {};  ///< quantisation step of each channel near black, in linear light; 0 with more than 8 bits
};

/// Finds the Moon in a photograph and cuts it out.
///
/// Given   photo  in linear light, decoded from the file's pixel values; values of 1 are saturated
/// Throws  Error  when no disc is found, not even at half or a quarter of the size, or when colour::limb_of does
MoonPart moon_part(const texture::Image& photo, float saturated = 0.97F);

/// The reason why a photograph cannot be registered. If half or more of the Moon is clipped or dark, the message also
/// states how much of it is clipped, how much is dark, and what is allowed.
std::string reason_with_shares(const MoonPart& moon, const std::string& reason);

/// How finely a photograph is registered.
enum class Registering {
  rough,       ///< coarse registration, without trying smaller sizes
  fine,        ///< fine registration; if it fails, the photograph is halved, at most twice
  of_clipped,  ///< like fine; if correlation is below 0.8, also with clipped pixels at the maximum
};

/// Finds where a scene lies in a photograph.
///
/// Given     scale  scale from scene to photograph, if it is known
///           how    of_clipped only if the moment is known, because at a wrong moment it finds false matches more often
/// Returned  the best of several attempts; one adds scene.glow, if known, for a clipped Moon partly outside the umbra
/// Throws    Error  when colour::registered does
colour::Registration registration_of(const FitScene& scene, const MoonPart& moon,
                                     const std::optional<double>& scale = {},
                                     Registering how = Registering::of_clipped);

/// Distance between the centres of the registered disc and the disc fitted to the limb [km]. The error of the limb is
/// subtracted: 0.3 pixels of the photograph or the scene, whichever pixels are larger.
double off_limb_km(const FitScene& scene, const colour::Registration& registration);

/// Standard error of a registration, in any direction [km].
///
/// The error is 0.3 pixels for a Moon in the umbra, and 0.8 pixels if part of the Moon is outside the umbra, because a
/// bright limb misleads registration. It is 0.2 pixels in both cases if the photograph was registered with the fitted
/// air, and shares its scale with another photograph or has a correlation of at least 0.998. Two errors are added in
/// quadrature: 2 (1 − correlation) pixels, for noise, and off_limb_km, because neither limb nor markings can be trusted
/// if they disagree. Pixels are those of the photograph or the scene, whichever are larger.
///
/// Given   in_its_air  whether the photograph was registered with the fitted air
/// Source  errors [pixels] on simulated photographs: 0.03 in the middle of the umbra, 0.2 to 0.45 near its edge, 0.8 at
///         a correlation below 0.8, up to 1.1 beside a lit crescent; on 18 JPEGs with the assumed air: 0.2 to 0.3 in
///         the umbra, 0.3 to 2.4 outside; on these with the fitted air: 0.1 to 0.2 in the umbra, 0.04 to 0.3 outside
double place_error_km(const FitScene& scene, const colour::Registration& registration,
                      bool in_its_air = false);

/// Mask that is 1 where any channel of a picture reaches `saturated`, else 0.
algebra::Grid<float> clipped_in(const texture::Image& photo, float saturated);

}  // namespace coppermoon::uses
