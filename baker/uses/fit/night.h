// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "uses/fit/compared_night.h"

namespace coppermoon::uses {

struct EclipsePhotograph;
struct FitRequest;
struct ReadPhotograph;

/// Photographs of one camera and eclipse, read and registered.
class Night {
 public:
  /// Reads the photographs, finds the clock's error where there may be one, and computes the light.
  ///
  /// Given   request      outlives this
  ///         photographs  of one camera and eclipse, outlive this
  /// Throws  Error        "<file>: …" for one alone that cannot be read or used, the first of several when
  ///                      none can
  Night(const FitRequest& request, std::vector<const EclipsePhotograph*> photographs,
        const algebra::Progress& progress = {});

  /// Measurements of all photographs; refers to this.
  DataSet data() const;

  /// Reads the photographs again by the tone curve found in the best air.
  ///
  /// Returned  whether a curve is in question at all
  bool refine(const AirFit& fit);

  /// Correction of the clock that the scenes already have [s].
  double clock_s() const { return clock_s_; }
  /// Whether the camera's tone curve is in question.
  bool curved() const;
  /// Tone curve in the best air.
  colour::ToneCurve curve(const AirFit& fit) const;
  /// Light by distance from the shadow's axis, in the best air.
  std::vector<MeasuredLight> measured(const AirFit& fit) const;
  /// Photographs as read, in the order given.
  std::vector<ReadPhotograph> read() const;

 private:
  /// A photograph that was read and registered.
  struct Taken {
    std::size_t index;  ///< of the photographs given
    colour::Registration registration;
    std::array<std::size_t, 2> extent;  ///< width and height of its picture [pixels]
    double px_per_rad;                  ///< scale of its picture
  };

  /// Skies over the photographs' moments, or over the whole eclipse where these are uncertain.
  std::vector<almanac::SkyState> way() const;
  /// Reads and registers photographs. Pictures of one size have one scale: a registration of another scale than
  /// most is wrong, and its photograph is left out.
  void take(double clock_s, std::span<const std::size_t> indices);
  void take_one(double clock_s, std::size_t index);
  bool at_odds(const Taken& taken) const;
  void require_any() const;
  std::vector<almanac::Instant> instants(double clock_s) const;
  /// Least χ² over a coarse grid of air.
  GoodnessOfFit coarse_fit(double clock_s) const;
  void find_half_hour();
  void find_clock();
  void compare();

  const FitRequest& request_;
  algebra::Progress heartbeat_;  ///< called at the start of each step; may throw to cancel
  std::unique_ptr<const FitGroundwork> groundwork_;
  std::vector<const EclipsePhotograph*> photographs_;
  std::vector<std::string> left_out_;  ///< [photograph] reason; empty: it is read
  std::vector<Taken> taken_;
  std::vector<NightPhotograph> binned_;  ///< light of those taken
  double clock_s_ = 0;
  colour::ToneCurve curve_{};
  Mixing mixing_ = no_mixing;
  algebra::Grid<double>
      expected_{};  ///< light about which mixing is linear; empty: the usual air's
  std::unique_ptr<const FittedLight> light_;
  std::unique_ptr<const ComparedNight> compared_;
};

}  // namespace coppermoon::uses
