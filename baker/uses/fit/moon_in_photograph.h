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

/// The Moon in a photograph and its surroundings, shrunk by a whole factor such that its disc is still at least half as
/// wide again as a scene's. Pixels that become one give the brightest of them if any is clipped, and 0 if most are
/// black.
struct MoonPart {
  texture::Image photo;
  algebra::Grid<float> luminance = {};  ///< of `photo`
  algebra::Grid<float> clipped =
      {};                  ///< luminance, but the greatest value where any channel is clipped
  colour::Disc disc = {};  ///< in `photo`
  double shrunk = 1;       ///< factor by which `photo` was shrunk
  std::array<double, 3> steps =
      {};  ///< quantisation steps near black, in linear light; 0 if they are fine
};

/// Given   photo  linear according to its coding; 1 saturates
/// Throws  Error  when there is no disc, even with the photograph halved in size once or twice; as colour::limb_of
MoonPart moon_part(const texture::Image& photo);

/// Why a photograph cannot be registered. If half or more of its Moon is clipped or dark, the shares and what is needed
/// are added to the reason.
std::string reason_with_shares(const MoonPart& moon, const std::string& reason);

/// How finely a photograph is registered.
enum class Registering {
  rough,  ///< as colour::KnownBefore::roughly
  fine,   ///< if noise hides the limb, the photograph is halved in size, at most twice
  of_clipped,  ///< as fine; if little is recognised, again with pixels treated as clipped if any channel is
};

/// Registers a scene in a photograph.
///
/// Given   scale   of the similarity, if it is known
///         how     of_clipped only if the moment is known: at a wrong moment, it recognises more that lies elsewhere
/// Throws  Error   as colour::registered
colour::Registration registration_of(const FitScene& scene, const MoonPart& moon,
                                     const std::optional<double>& scale = {},
                                     Registering how = Registering::of_clipped);

/// Distance between the registered disc and the disc fitted to the limb [km], less the limb's own error: 0.3 pixels of
/// the photograph or the scene, whichever are larger.
double off_limb_km(const FitScene& scene, const colour::Registration& registration);

/// Standard error of a registration, in any direction [km].
///
/// In pixels of the photograph or the scene, whichever are larger, it is 0.3 for a Moon in the umbra, and 0.8 if ground
/// beyond the umbra is lit, because a bright limb misleads registration. If registered against the Moon in the air that
/// was found, at the scale of all the night's photographs, it is 0.2 in both cases. Added in quadrature are
/// 2 (1 − correlation), for noise, and off_limb_km: if limb and markings disagree, neither can be trusted.
///
/// Given   in_its_air  whether it was registered in the air that was found
/// Source  errors measured on simulated photographs: 0.03 in the middle of the umbra, 0.2 to 0.45 near its edge, 0.8 at
///         a correlation below 0.8, up to 1.1 beside a lit crescent; on a night of 18 JPEGs 0.2 to 0.3 in the umbra and
///         0.3 to 2.4 outside, or 0.1 to 0.2 and 0.04 to 0.3 in the air found
double place_error_km(const FitScene& scene, const colour::Registration& registration,
                      bool in_its_air = false);

/// 1 where any channel of a picture is clipped, that is, at least `saturated`.
algebra::Grid<float> clipped_in(const texture::Image& photo, float saturated);

}  // namespace coppermoon::uses
