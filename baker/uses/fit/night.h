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

/// The photographs of one camera and eclipse, as they are read.
class Night {
 public:
  /// Reads them, finds the clock's error where there may be one, and computes the light.
  ///
  /// Given   request      outlives this
  ///         photographs  of one camera and eclipse, outlive this
  /// Throws  Error        "<file>: …" for one alone that cannot be read or used, the first of several when
  ///                      none can
  Night(const FitRequest& request, std::vector<const EclipsePhotograph*> photographs,
        const algebra::Progress& progress = {});

  /// Refers to this.
  Witness witness() const;

  /// Reads the photographs again with the tone curve that the best air asks for.
  ///
  /// Returned  whether a curve is in question at all
  bool refine(const AirFit& fit);

  /// What is to be added to the instants told, that moments of the scenes have by now [s].
  double clock_s() const { return clock_s_; }
  bool curved() const;
  colour::ToneCurve curve(const AirFit& fit) const;
  std::vector<MeasuredLight> measured(const AirFit& fit) const;
  /// In the order of the photographs given.
  std::vector<ReadPhotograph> read() const;

 private:
  /// A photograph that was read, and which.
  struct Taken {
    std::size_t index;
    colour::Registration registration;
    std::array<std::size_t, 2> extent;  ///< of its picture [pixels]
    double px_per_rad;                  ///< of its picture
  };

  std::vector<almanac::SkyState> way() const;
  /// Reads photographs, and recognises the Moon in them. Those of one size of picture have one scale: what is
  /// at odds with the most of them is left out, for light and shadow hid its limb.
  void take(double clock_s, std::span<const std::size_t> indices);
  void take_one(double clock_s, std::size_t index);
  bool at_odds(const Taken& taken) const;
  void require_any() const;
  std::vector<almanac::Instant> instants(double clock_s) const;
  /// What the best of a few airs says.
  Weighed looked_at(double clock_s) const;
  void find_half_hour();
  void find_clock();
  void compare();

  const FitRequest& request_;
  algebra::Progress look_;  ///< told now and then, before the light is computed
  std::unique_ptr<const FitGroundwork> groundwork_;
  std::vector<const EclipsePhotograph*> photographs_;
  std::vector<std::string> left_out_;  ///< [photograph] why; empty: it is read
  std::vector<Taken> taken_;
  std::vector<NightPhotograph> known_;  ///< of those taken
  double clock_s_ = 0;
  colour::ToneCurve curve_{};
  std::unique_ptr<const FittedLight> light_;
  std::unique_ptr<const ComparedNight> compared_;
};

}  // namespace coppermoon::uses
