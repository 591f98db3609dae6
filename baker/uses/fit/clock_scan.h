// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "colour/similarity.h"
#include "texture/image.h"
#include "uses/fit/placing.h"

namespace coppermoon::uses {

/// A photograph averaged over square cells of the Moon's disc. It can be compared with the Moon at any moment.
struct ClockView {
  /// The ground in a cell, and its light.
  struct Cell {
    glm::dvec3 ground;  ///< unit vector, Moon-fixed
    double sunlit;      ///< light without the shadow
    double light;       ///< logarithm of photographed light, decoded by the mean curve
    enum class Seen { dark, well, clipped };
    Seen seen;  ///< dark: light is an upper limit; clipped: a lower limit
  };
  almanac::Instant instant;  ///< time of the photograph by the camera's clock
  std::vector<Cell> cells;
};

/// Averages a photograph over the cells of the scene in which it is registered.
///
/// Given  curved  whether the photograph has a camera's own tone curve
ClockView clock_view(const FitScene& scene, const texture::Image& photo,
                     const colour::Similarity& render_to_photo, bool curved,
                     const almanac::Instant& instant);

/// How much a photograph differs from the Moon computed for a corrected time, in usual air and at the best exposure. It
/// is the mean over cells of the squared difference in the logarithm of light, each square limited to 1.
///
/// Given     clock_s  correction added to the camera's time
/// Returned  0 to 1; 0 if nothing is seen well
double misfit_at(const FitGroundwork& groundwork, const ClockView& view, double clock_s);

/// Clock correction found from photographs, and how well it is known.
struct ScannedClock {
  double seconds;  ///< to be added to the camera's times
  bool decided;    ///< whether partial phases determined it, not the prior
};

/// Clock correction at which photographs match the Moon best, searched in steps of 5 minutes, then 1 minute, then 15 s.
/// A mean misfit q of n views counts as a χ² of n · w · ln q. If views show a partial phase at the correction with the
/// least q, w is 10 and the prior's χ² is limited to 9. Otherwise w is 0.3, because moments in mid-totality look alike.
///
/// Given  views         one or more
///        from_s, to_s  least and greatest possible correction
///        believed      prior χ² of a correction, from what is known about the clock
ScannedClock scanned_clock(const FitGroundwork& groundwork, std::span<const ClockView> views,
                           double from_s, double to_s,
                           const std::function<double(double clock_s)>& believed);

/// Correction to be added to the times of a camera's clock, and its prior.
struct Clock {
  double added_s = 0;     ///< correction that light is computed for
  double believed_s = 0;  ///< prior mean of the correction, before light is compared
  double error_s = 0;     ///< standard error of believed_s; 0 if times are exact
};

/// Whether the clock's correction must be searched for, because it may exceed what the fit itself can find.
bool clock_is_free(const FitRequest& request);

/// Skies covering the moments of a request's photographs, or the whole eclipse if those moments are uncertain.
std::vector<almanac::SkyState> skies_of(const FitRequest& request);

/// Clock correction that puts the computed shadow where up to six of a night's photographs show it. If half hours are
/// free, the search starts in steps of half an hour; it then continues as in the other scanned_clock. If the clock is
/// not free, or no photograph can be registered, the correction is 0, with the error that the request states.
///
/// Throws  Error  when half hours are free but no correction puts the photographs within an eclipse
Clock scanned_clock(const Stage& stage, std::span<const Reading> readings);

}  // namespace coppermoon::uses
