// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "uses/fit/clock_scan.h"
#include "uses/fit/compared_night.h"
#include "uses/picture/photo_file.h"

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

  /// Reads the photographs again by what was found: once more registered, in the best air; by the tone curve. Computes
  /// light again in range_about(fit), until the fit is well within that; not for photographs by a tone curve, which errs
  /// by more than light between nodes of the whole range.
  ///
  /// Returned  whether anything is read or computed anew
  bool refine(const AirFit& fit);

  /// Correction of the clock that the scenes already have [s].
  double clock_s() const { return clock_s_; }
  /// Whether the camera's tone curve is in question.
  bool curved() const;
  /// Tone curve in the best air.
  colour::ToneCurve curve(const AirFit& fit) const;
  /// Light by distance from the shadow's axis, in the best air.
  std::vector<MeasuredLight> measured(const AirFit& fit) const;
  /// Misfits in the best air, by the order of the photographs given.
  std::vector<Misfit> misfits(const AirFit& fit) const;
  /// Photographs as read, in the order given.
  std::vector<ReadPhotograph> read() const;

 private:
  /// A photograph that was read and registered.
  struct Taken {
    std::size_t index;  ///< of the photographs given
    colour::Registration registration;
    double px_per_rad;  ///< scale of its picture
  };
  /// A photograph's Moon, kept for further readings.
  struct Kept {
    MoonPart moon;
    std::array<std::size_t, 2> extent;      ///< width and height of the whole picture [pixels]
    std::string unusable{};                 ///< reason; empty: it has a Moon
    std::optional<ClippedAt> clipped_at{};  ///< which became 1; without: it was 1
  };

  /// Skies over the photographs' moments, or over the whole eclipse where these are uncertain.
  std::vector<almanac::SkyState> way() const;
  /// Largest correction of the clock besides half hours, if light is not linear over it [s]; else 0.
  double farthest_clock_s() const;
  bool clock_is_free() const;
  const Kept& kept(std::size_t index);
  /// Registers photographs. Pictures of one size have one scale: a photograph that is not registered, or in
  /// another scale than most, is registered in theirs, and left out where it is less like the Moon then.
  ///
  /// Given  roughly  as colour::KnownBefore has it; each photograph then keeps its own scale
  void take(double clock_s, std::span<const std::size_t> indices, bool roughly = false);
  void take_one(double clock_s, std::size_t index, std::optional<double> px_per_rad, bool roughly);
  void take_in_scale(double clock_s, std::size_t index, double px_per_rad);
  /// Computes the light of what is taken, in a range of air; without: in all.
  void compute_light(const algebra::Progress& progress, const std::optional<AirRange>& range = {});
  /// Bins the light of what is taken.
  void read_light();
  /// Scale with the most agreement among pictures of that photograph's size, by the sum of correlations; 0: none.
  double agreed_px_per_rad(std::size_t index);
  void require_any() const;
  std::vector<almanac::Instant> instants(double clock_s) const;
  /// Air of the least χ² on a coarse grid.
  struct CoarseFit {
    FittedLight light;
    ComparedNight compared;
    AirNumbers best{};
    GoodnessOfFit goodness{std::numeric_limits<double>::infinity()};
  };
  CoarseFit coarse_fit(double clock_s) const;
  /// Leaves out photographs whose limb and markings are more than 50 km apart, where three others remain; then, one by one,
  /// those whose light no air explains beside the others': three stops off in all channels, or one where the Moon is poorly
  /// recognised or turned unlike most others. One of them misleads a whole night.
  void leave_out_misplaced();
  void leave_out_far();
  /// Whether a photograph was left out so.
  bool leave_out_worst();
  std::vector<std::size_t> some(std::size_t most) const;
  std::vector<ClockView> views();
  /// First and last correction of the clock that is possible.
  std::array<double, 2> possible_s() const;
  /// Takes photographs at the correction at which the shadow is where it is on them, in steps of half an hour.
  ///
  /// Returned  that correction
  double take_anywhere(std::span<const std::size_t> indices, const std::array<double, 2>& range_s);
  void scan_clock();
  void find_clock();
  NightErrors errors() const;
  void compare();
  void register_again(const AirFit& fit);

  const FitRequest& request_;
  algebra::Progress heartbeat_;  ///< called at the start of each step; may throw to cancel
  std::unique_ptr<const FitGroundwork> groundwork_;
  std::vector<const EclipsePhotograph*> photographs_;
  std::vector<std::optional<Kept>> kept_;  ///< by photograph
  std::vector<std::string> left_out_;      ///< [photograph] reason; empty: it is read
  std::vector<Taken> taken_;
  std::vector<NightPhotograph> binned_;  ///< light of those taken
  double clock_s_ = 0;                   ///< correction that the scenes have
  double believed_s_ = 0;                ///< mean of the correction, as it is believed
  double clock_error_s_;                 ///< standard error of that
  bool clock_scanned_ = false;           ///< the scenes' moments are right to a minute or so
  bool registered_in_best_air_ = false;
  int curves_read_ = 0;  ///< readings by the tone curve found
  colour::ToneCurve curve_{};
  Mixing mixing_ = no_mixing;
  /// light of the best air, and under more cloud, about which errors are linear; empty: the usual air's
  algebra::Grid<double> expected_{}, clouded_{};
  double clouded_by_ = 0;
  std::unique_ptr<const FittedLight> light_;
  std::unique_ptr<const ComparedNight> compared_;
};

}  // namespace coppermoon::uses
