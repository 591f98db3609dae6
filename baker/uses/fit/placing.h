// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "uses/fit/reading.h"

namespace coppermoon::uses {

/// The scene at a photograph's moment, and how the scene is registered in the photograph.
struct Placed {
  std::string left_out{};  ///< one-line reason why the photograph is not registered, or empty
  std::shared_ptr<const FitScene> scene{};
  colour::Registration registration{};
  double px_per_rad = 0;         ///< scale of the whole picture
  bool in_others_scale = false;  ///< whether registered at the scale of other photographs
  bool in_its_air = false;  ///< whether registered with the best-fitting air at a reliable scale
};

/// What is needed to register the photographs from one camera and eclipse.
struct Stage {
  const FitRequest& request;
  const FitGroundwork& groundwork;
  algebra::Progress alive{};  ///< called before each photograph; may throw to cancel
};

/// Registers each photograph with the scene at its time plus a clock correction. Photographs of the same size in pixels
/// should have the same scale. If a photograph fails to register, or its scale differs from that of most others, it is
/// registered again at their scale. It is left out if its correlation with the scene is then too low.
///
/// Given     readings  one for each photograph of the request
///           which     indices of the photographs to register; all others are left out
///           how       if rough, each photograph keeps its own scale; if of_clipped, the glow of scenes is computed
/// Returned  one for each photograph of the request
std::vector<Placed> placed(const Stage& stage, std::span<const Reading> readings, double clock_s,
                           std::span<const std::size_t> which, Registering how);

/// Registers photographs again, with the Moon computed for a different air. A photograph whose correlation falls by
/// more than 0.1, or whose rotation changes, keeps its earlier registration.
///
/// Given  stage  request and groundwork for the new air
std::vector<Placed> placed_again(const Stage& stage, std::span<const Reading> readings,
                                 std::vector<Placed> all);

/// Leaves out photographs whose limb and markings place the Moon's centre over 50 km apart, if three others remain.
void leave_out_far(std::span<const Reading> readings, std::span<Placed> placed);

/// Bins the light of the registered photographs. Those registered at the scale of other photographs come last.
///
/// Given  curve  tone curve to undo in photographs that have a camera's own tone curve
std::vector<Binned> binned(std::span<const Reading> readings, std::span<const Placed> placed,
                           const colour::ToneCurve& curve);

/// Whether two pictures are both mirrored or both not, and their rotations differ by less than `within_degrees`.
bool are_turned_alike(const colour::Similarity& one, const colour::Similarity& other,
                      double within_degrees = 30);

}  // namespace coppermoon::uses
