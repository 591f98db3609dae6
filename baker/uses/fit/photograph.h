// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>

#include "algebra/grid.h"
#include "colour/registration.h"
#include "texture/image.h"
#include "uses/fit/scene.h"

namespace coppermoon::uses {

/// A photograph's Moon and what is around it, shrunk by a whole factor while its disc stays half as wide again as a
/// scene's. Where any pixel of those that become one is clipped the brightest stands for them, where most are black 0.
struct MoonPart {
  texture::Image photo;
  algebra::Grid<float> luminance = {};  ///< of the photo
  algebra::Grid<float> clipped = {};    ///< the same, but the greatest where any channel is clipped
  colour::Disc disc = {};               ///< in the photo
  double shrunk = 1;                    ///< the factor
  std::array<double, 3> steps =
      {};  ///< of the photograph's numbers near black, in linear light; 0: fine ones
};

/// Given   photo  linear by its coding, 1 saturates
/// Throws  Error  when there is no disc, also in the photograph halved in size once or twice; as colour::limb_of
MoonPart moon_part(const texture::Image& photo);

/// Reason why a photograph is not registered. Where half of its Moon or more is clipped or dark, the shares are added,
/// and what is needed.
std::string reason_with_shares(const MoonPart& moon, const std::string& reason);

/// How finely a photograph is registered.
enum class Registering {
  rough,  ///< as colour::KnownBefore::roughly
  fine,   ///< where noise hides the limb, the photograph is halved in size, twice at most
  of_clipped,  ///< finely; where little is recognised, again with what any channel clips taken for clipped
};

/// Registers a scene in a photograph.
///
/// Given   scale   of the similarity, where it is known
///         how     of_clipped only at a moment that is known: at another, more is recognised that lies elsewhere
/// Throws  Error   as colour::registered
colour::Registration registration_of(const FitScene& scene, const MoonPart& moon,
                                     const std::optional<double>& scale = {},
                                     Registering how = Registering::of_clipped);

/// Distance of the registered disc from that of the limb, as far as it is beyond the 0.3 by which a limb errs, in the
/// larger pixels of photograph and scene [km].
double off_limb_km(const FitScene& scene, const colour::Registration& registration);

/// Standard error of a registration, in any direction [km].
///
/// In the larger pixels of photograph and scene: 0.3 for a Moon in the umbra, 0.8 where ground beyond the umbra is lit,
/// for a bright limb misleads registration; against the Moon in the air that was found, in the scale of all of the
/// night's photographs, 0.2 for both; in quadrature 2 (1 − correlation), for noise, and off_limb_km: where limb and
/// markings disagree neither is believed.
///
/// Given   in_its_air  whether it was registered so
/// Source  errors measured on simulated photographs: in the middle of the umbra 0.03, by its edge 0.2 to 0.45, at a
///         correlation below 0.8 0.8, beside a lit crescent up to 1.1; of a night of 18 JPEGs 0.2 to 0.3 in the umbra
///         and 0.3 to 2.4 outside, in the air found 0.1 to 0.2 and 0.04 to 0.3
double place_error_km(const FitScene& scene, const colour::Registration& registration,
                      bool in_its_air = false);

/// 1 where any channel of a picture is clipped: at least so bright.
algebra::Grid<float> clipped_in(const texture::Image& photo, float saturated);

}  // namespace coppermoon::uses
