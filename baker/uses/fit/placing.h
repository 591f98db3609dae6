// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "uses/fit/reading.h"

namespace coppermoon::uses {

/// A photograph registered in the scene of a moment.
struct Placed {
  std::string left_out{};  ///< reason in one line why it is not; empty: it is
  std::shared_ptr<const FitScene> scene{};
  colour::Registration registration{};
  double px_per_rad = 0;  ///< scale of the whole picture
  bool in_others_scale =
      false;                ///< whether it was registered in the scale of most others, after them
  bool in_its_air = false;  ///< whether it was registered in the air of the best fit
};

/// What photographs of one camera and eclipse are placed in.
struct Stage {
  const FitRequest& request;
  const FitGroundwork& groundwork;
  algebra::Progress alive{};  ///< called before each photograph; may throw to cancel
};

/// Registers photographs at their instants and a correction of the clock. Pictures of one size have one scale: a
/// photograph that is not registered, or in another scale than most, is registered in theirs, and left out where it is
/// less like the Moon then.
///
/// Given     readings  of the request's photographs
///           which     of them; the others are left out without a reason
///           how       roughly: each photograph keeps its own scale; of_clipped: scenes get their glow
/// Returned  [photograph]
std::vector<Placed> placed(const Stage& stage, std::span<const Reading> readings, double clock_s,
                           std::span<const std::size_t> which, Registering how);

/// Registers photographs once more, where they were, in other air. A photograph that is less like the Moon then stays
/// as it was.
///
/// Given  stage  in that air
std::vector<Placed> placed_again(const Stage& stage, std::span<const Reading> readings,
                                 std::vector<Placed> all);

/// Leaves out photographs whose limb and markings are more than 50 km apart, where three others remain.
void leave_out_far(std::span<const Reading> readings, std::span<Placed> placed);

/// Bins the light of what is placed, those in the others' scale last.
///
/// Given  curve  tone curve that is undone where a photograph has its camera's own
std::vector<Binned> binned(std::span<const Reading> readings, std::span<const Placed> placed,
                           const colour::ToneCurve& curve);

/// Whether two pictures are turned by angles less than 30 degrees apart, and mirrored alike.
bool are_turned_alike(const colour::Similarity& one, const colour::Similarity& other);

}  // namespace coppermoon::uses
