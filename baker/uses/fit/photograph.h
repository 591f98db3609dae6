// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "algebra/grid.h"
#include "colour/registration.h"
#include "colour/tone_curve.h"
#include "texture/image.h"
#include "uses/fit/scene.h"

namespace coppermoon::uses {

/// How the light of a bin changes with the numbers of a tone curve: d ln(light) of each.
using ToneSlopes = std::array<double, colour::tone_numbers>;

/// A photograph's light over a scene's bins.
struct BinnedPhotograph {
  algebra::Grid<double>
      values;  ///< (bin, channel), linear Rec.709: light over sunlit; 0: not known
  algebra::Grid<double> errors;      ///< standard errors of the values, by how near pixels differ
  algebra::Grid<double> sky_errors;  ///< of the sky's light: alike in all bins of a channel
  algebra::Grid<double>
      glow_errors;  ///< of the glow's light: alike in all bins and channels, over it
  algebra::Grid<ToneSlopes> slopes;  ///< empty: light is known, no curve is in question
};

/// Where the scene lies in a photograph. One whose noise hides the limb is looked at from further away.
///
/// Throws  Error  as colour::registered
colour::Registration registration_of(const FitScene& scene, const texture::Image& photo);

/// How far a registration may be off, in any direction [km].
///
/// In pixels, the photograph's or the scene's: 0.3 of a Moon in the umbra, 0.8 where ground beyond it is lit,
/// for a bright limb leads registration astray; and 2 (1 − correlation) beside that, for noise. Measured on
/// photographs of our own making whose place is known: in the middle of the umbra 0.03, by its edge 0.2 to 0.45,
/// at a correlation below 0.8 0.8, beside a lit crescent up to 1.1.
double place_error_km(const FitScene& scene, const colour::Registration& registration);

/// Sums up a photograph's light. Clipped pixels are left out, and a bin with them where they are more than
/// half a hundredth of it; so is a bin in which noise is cut off at black. The light of the sky and of the
/// glow about the Moon, both found beside the disc, is taken off; where nothing tells them apart the glow
/// has 0.03 ± 0.02 of the light, as lenses have it. What is taken off as glow is believed to a quarter of it,
/// for that of real lenses falls with other powers of the angle.
///
/// Given   photo            linear as its file says, 1 saturates
///         render_to_photo  where the scene lies in it
///         curve            what makes its light the scene's: pixel by pixel; without: it is
BinnedPhotograph binned(const FitScene& scene, const texture::Image& photo,
                        const colour::Similarity& render_to_photo,
                        const std::optional<colour::ToneCurve>& curve = {});

}  // namespace coppermoon::uses
