// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "uses/fit/reading.h"

namespace coppermoon::uses {

/// A photograph registered in the scene at its moment.
struct Placed {
  std::string left_out{};  ///< why it is not registered, in one line; empty if it is
  std::shared_ptr<const FitScene> scene{};
  colour::Registration registration{};
  double px_per_rad = 0;         ///< scale of the whole picture
  bool in_others_scale = false;  ///< whether it was registered after most others, at their scale
  bool in_its_air = false;       ///< whether it was registered in the air of the best fit
};

/// What is needed to place the photographs from one camera and eclipse.
struct Stage {
  const FitRequest& request;
  const FitGroundwork& groundwork;
  algebra::Progress alive{};  ///< called before each photograph; may throw to cancel
};

/// Registers photographs at their instants plus a clock correction. Pictures of one size share a scale: a photograph
/// that fails to register, or has a different scale from most, is registered at the scale of most. It is left out if it
/// then looks less like the Moon.
///
/// Given     readings  of the request's photographs
///           which     photographs to register; the others are left out without a reason
///           how       rough: each photograph keeps its own scale; of_clipped: scenes get their glow
/// Returned  [photograph]
std::vector<Placed> placed(const Stage& stage, std::span<const Reading> readings, double clock_s,
                           std::span<const std::size_t> which, Registering how);

/// Registers photographs once more, starting where they were, in a different air. A photograph that then looks less
/// like the Moon stays as it was.
///
/// Given  stage  in the new air
std::vector<Placed> placed_again(const Stage& stage, std::span<const Reading> readings,
                                 std::vector<Placed> all);

/// Leaves out photographs whose limb and markings are more than 50 km apart, as long as three others remain.
void leave_out_far(std::span<const Reading> readings, std::span<Placed> placed);

/// Bins the light of the placed photographs; those registered at the others' scale come last.
///
/// Given  curve  tone curve to undo for photographs that have their camera's own
std::vector<Binned> binned(std::span<const Reading> readings, std::span<const Placed> placed,
                           const colour::ToneCurve& curve);

/// Whether two pictures are turned by angles less than 30 degrees apart, and mirrored alike.
bool are_turned_alike(const colour::Similarity& one, const colour::Similarity& other);

}  // namespace coppermoon::uses
