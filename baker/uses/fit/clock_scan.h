// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "colour/similarity.h"
#include "texture/image.h"
#include "uses/fit/placing.h"

namespace coppermoon::uses {

/// A photograph in cells of its scene: how light lies on the Moon, at whatever moment that was.
struct ClockView {
  /// Ground of a cell, and its light.
  struct Cell {
    glm::dvec3 ground;  ///< unit vector, Moon-fixed
    double sunlit;      ///< light without the shadow
    double light;       ///< logarithm of the scene's light, by the mean tone curve of cameras
    enum class Seen { dark, well, clipped };
    Seen seen;  ///< dark and clipped: light is the least or the most that is seen
  };
  almanac::Instant instant;  ///< by the camera's clock
  std::vector<Cell> cells;
};

/// View of a photograph that is registered in a scene, whatever the scene's moment is.
///
/// Given  curved  whether the photograph has a camera's own tone curve
ClockView clock_view(const FitScene& scene, const texture::Image& photo,
                     const colour::Similarity& render_to_photo, bool curved,
                     const almanac::Instant& instant);

/// How far a photograph is from the Moon of another moment, in the usual air and by any exposure: the mean square of
/// the cells' differences in the logarithm of light, none counted as more than 1.
///
/// Given     clock_s  added to what the clock says
/// Returned  0 to 1; 0 where nothing is well seen
double misfit_at(const FitGroundwork& groundwork, const ClockView& view, double clock_s);

/// Correction of a clock by photographs, and how it is known.
struct ScannedClock {
  double seconds;  ///< to be added
  bool decided;    ///< by partial phases; else by what was believed
};

/// Correction of a clock at which photographs are nearest to the Moon: in steps of 5 minutes, then of 1, then of 15 s.
/// A mean misfit q of n views counts as a χ² of n · w · ln q. Where some show a partial phase when q is least, w is 10,
/// and what is believed counts as 9 at most; else w is 0.3, for in mid-totality one moment looks like another.
///
/// Given  views         one or more
///        from_s, to_s  corrections that are possible
///        believed      χ² of a correction by what is known of the clock
ScannedClock scanned_clock(const FitGroundwork& groundwork, std::span<const ClockView> views,
                           double from_s, double to_s,
                           const std::function<double(double clock_s)>& believed);

/// Clock of a camera: what is added to its instants.
struct Clock {
  double added_s = 0;     ///< correction that light is computed for
  double believed_s = 0;  ///< mean of the correction before light is compared
  double error_s = 0;     ///< standard error of that; 0: instants are exact
};

/// Whether the clock of a night's photographs is looked for, beyond what light tells within a minute or so.
bool clock_is_free(const FitRequest& request);

/// Skies over the moments of a request's photographs, or over the whole eclipse where these are uncertain.
std::vector<almanac::SkyState> skies_of(const FitRequest& request);

/// Clock of a night's photographs, at which the shadow is where it is on six of them: in steps of half an hour where
/// half hours are free, then as scanned_clock. Where the clock is not free, or no photograph is registered: as it was
/// told.
///
/// Throws  Error  when half hours are free and none makes an eclipse of the instants
Clock scanned_clock(const Stage& stage, std::span<const Reading> readings);

}  // namespace coppermoon::uses
