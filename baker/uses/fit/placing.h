// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "uses/fit/reading.h"

namespace coppermoon::uses {

/// A photograph, the scene at its moment, and how the scene is registered in it.
struct Placed {
  std::string left_out{};  ///< why it was not registered, in one line; empty if it was
  std::shared_ptr<const FitScene> scene{};
  colour::Registration registration{};
  double px_per_rad = 0;         ///< scale of the whole picture
  bool in_others_scale = false;  ///< whether it was registered at the scale of others
  bool in_its_air = false;       ///< whether it was registered with the best air
};

/// What is needed to place the photographs from one camera and eclipse.
struct Stage {
  const FitRequest& request;
  const FitGroundwork& groundwork;
  algebra::Progress alive{};  ///< called before each photograph; may throw to cancel
};

/// Registers photographs in scenes at their times plus a clock correction. Photographs of the same size in pixels
/// should have the same scale. One that fails to register, or whose scale differs from that of most, is registered
/// again at the scale of most. It is left out if it then looks less like the Moon.
///
/// Given     readings  one for each photograph of the request
///           which     indices of the photographs to register; all others are left out
///           how       if rough, each photograph keeps its own scale; if of_clipped, the glow of scenes is computed
/// Returned  one for each photograph of the request
std::vector<Placed> placed(const Stage& stage, std::span<const Reading> readings, double clock_s,
                           std::span<const std::size_t> which, Registering how);

/// Registers photographs again, with the Moon computed for a different air. A photograph that then looks less like the
/// Moon keeps its earlier registration.
///
/// Given  stage  with the new air
std::vector<Placed> placed_again(const Stage& stage, std::span<const Reading> readings,
                                 std::vector<Placed> all);

/// Leaves out photographs whose limb and markings are more than 50 km apart, as long as three others remain.
void leave_out_far(std::span<const Reading> readings, std::span<Placed> placed);

/// Bins the light of the placed photographs. Those registered at the scale of the others come last.
///
/// Given  curve  tone curve to undo for photographs whose tone curve is their camera's own
std::vector<Binned> binned(std::span<const Reading> readings, std::span<const Placed> placed,
                           const colour::ToneCurve& curve);

/// Whether two pictures are mirrored alike, and turned by angles that differ by less than 30 degrees or another limit.
bool are_turned_alike(const colour::Similarity& one, const colour::Similarity& other,
                      double within_degrees = 30);

}  // namespace coppermoon::uses
