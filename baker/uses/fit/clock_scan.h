// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "colour/similarity.h"
#include "texture/image.h"
#include "uses/fit/placing.h"

namespace coppermoon::uses {

/// A photograph in cells of its scene: how light is distributed on the Moon, whatever the moment.
struct ClockView {
  /// The ground in a cell, and its light.
  struct Cell {
    glm::dvec3 ground;  ///< unit vector, Moon-fixed
    double sunlit;      ///< light without the shadow
    double light;       ///< logarithm of the photographed light, by the cameras' mean tone curve
    enum class Seen { dark, well, clipped };
    Seen seen;  ///< if dark or clipped, light is only an upper or a lower limit
  };
  almanac::Instant instant;  ///< by the camera's clock
  std::vector<Cell> cells;
};

/// The cells of a photograph that is registered in a scene, whatever the scene's moment.
///
/// Given  curved  whether the photograph has a camera's own tone curve
ClockView clock_view(const FitScene& scene, const texture::Image& photo,
                     const colour::Similarity& render_to_photo, bool curved,
                     const almanac::Instant& instant);

/// How much a photograph differs from the Moon at another moment, in the usual air and at the best exposure: the mean
/// square of the cells' differences in the logarithm of light, none counted as more than 1.
///
/// Given     clock_s  correction added to what the clock says
/// Returned  0 to 1; 0 if nothing is seen well
double misfit_at(const FitGroundwork& groundwork, const ClockView& view, double clock_s);

/// Clock correction found from photographs, and how well it is known.
struct ScannedClock {
  double seconds;  ///< to be added
  bool decided;    ///< whether partial phases determined the error; else the prior did
};

/// Clock correction at which photographs match the Moon best, searched in steps of 5 minutes, then 1 minute, then 15 s.
/// A mean misfit q of n views counts as a χ² of n · w · ln q. If some views show a partial phase where q is least, w is
/// 10 and the prior counts as 9 at most. Otherwise w is 0.3, because in mid-totality one moment looks like another.
///
/// Given  views         one or more
///        from_s, to_s  least and greatest possible correction
///        believed      prior χ² of a correction, from what is known about the clock
ScannedClock scanned_clock(const FitGroundwork& groundwork, std::span<const ClockView> views,
                           double from_s, double to_s,
                           const std::function<double(double clock_s)>& believed);

/// A camera's clock: the correction added to its instants.
struct Clock {
  double added_s = 0;     ///< correction that light is computed for
  double believed_s = 0;  ///< prior mean of the correction, before light is compared
  double error_s = 0;     ///< standard error of believed_s; 0: instants are exact
};

/// Whether to search for the clock's correction, beyond the minute or so within which the fit itself finds it.
bool clock_is_free(const FitRequest& request);

/// Skies covering the moments of a request's photographs, or the whole eclipse if those moments are uncertain.
std::vector<almanac::SkyState> skies_of(const FitRequest& request);

/// Clock that puts the shadow where six of a night's photographs show it. If half hours are free, the search starts in
/// steps of half an hour; it then continues as in the other scanned_clock. If the clock is not free, or no photograph
/// can be registered, the request's clock is returned.
///
/// Throws  Error  when half hours are free but none puts the instants within an eclipse
Clock scanned_clock(const Stage& stage, std::span<const Reading> readings);

}  // namespace coppermoon::uses
