// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "colour/similarity.h"
#include "texture/image.h"
#include "uses/fit/placing.h"

namespace coppermoon::uses {

/// A photograph averaged over square cells of the Moon's disc, for comparison with the Moon computed for any moment.
struct ClockView {
  /// The ground that a cell shows, and the light from it.
  struct Cell {
    glm::dvec3 ground;  ///< unit vector to the ground, Moon-fixed
    double sunlit;      ///< light that the cell would have without the shadow
    double light;       ///< logarithm of photographed light, with the mean tone curve undone
    enum class Seen { dark, well, clipped };
    Seen seen;  ///< if dark, `light` is an upper limit; if clipped, a lower limit
  };
  almanac::Instant instant;  ///< time of the photograph by the camera's clock
  std::vector<Cell> cells;
};

/// Averages a photograph over square cells of the scene that is registered in it.
///
/// Given  curved  whether the photograph has a camera's own tone curve
ClockView clock_view(const FitScene& scene, const texture::Image& photo,
                     const colour::Similarity& render_to_photo, bool curved,
                     const almanac::Instant& instant);

/// Misfit between a photograph and the Moon at its corrected time, in the assumed air and at the best exposure. It is
/// the mean over cells of the squared difference in the logarithm of light, with each square limited to 1.
///
/// Given     clock_s  correction added to the camera's time
/// Returned  0 to 1; 0 if no cell is well exposed
double misfit_at(const FitGroundwork& groundwork, const ClockView& view, double clock_s);

/// Clock correction found from photographs, and whether the photographs determined it.
struct ScannedClock {
  double seconds;       ///< correction to be added to the camera's times
  bool decided;         ///< whether partial phases, not the prior, determined the correction
  double from_s, to_s;  ///< corrections around it whose χ² exceeds the least χ² by 9 at most
};

/// Clock correction at which photographs match the Moon best, searched in steps of 5 minutes, then 1 minute, then 15 s.
/// If n views have a mean misfit q, their χ² is n · w · ln q. If views show a partial phase at the correction with the
/// least q, w is 10 and the prior's χ² is limited to 9. Otherwise w is 0.3, because all of mid-totality looks alike.
///
/// Given  views         one or more
///        from_s, to_s  least and greatest possible correction
///        believed      prior χ² of a correction, from what is known about the clock
ScannedClock scanned_clock(const FitGroundwork& groundwork, std::span<const ClockView> views,
                           double from_s, double to_s,
                           const std::function<double(double clock_s)>& believed);

/// Correction to be added to the times of a camera's clock, and its prior.
struct Clock {
  double added_s = 0;     ///< correction with which light is computed
  double believed_s = 0;  ///< prior mean of the correction, before any comparison of light
  double error_s = 0;     ///< standard error of believed_s; 0 if times are exact
  std::optional<ScannedClock> scanned{};  ///< by the shadow's place; only for edited photographs
};

/// Whether a clock's correction lies outside the range in which its scan allows it.
bool strays(const Clock& clock);

/// A scanned clock with the correction that its scan found, and the standard error that follows from its range.
Clock scanned_again(const Clock& clock);

/// Whether the clock's correction must be searched for, because it may exceed what the fit itself can find.
bool clock_is_free(const FitRequest& request);

/// Sky states from a request's first photograph to its last, or over the whole eclipse if the times are uncertain.
std::vector<almanac::SkyState> skies_of(const FitRequest& request);

/// Clock correction that puts the computed shadow where the photographs of a night (at most six are used) show it. If
/// an unknown time zone may shift times by half hours, steps of half an hour are tried before finer ones. If the clock
/// needs no search (clock_is_free) or no photograph can be registered, the correction is 0, with the request's error.
///
/// Throws  Error  when times may be wrong by half hours but no correction puts the photographs within an eclipse
Clock scanned_clock(const Stage& stage, std::span<const Reading> readings);

}  // namespace coppermoon::uses
