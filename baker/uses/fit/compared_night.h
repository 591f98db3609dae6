// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "uses/fit/air_fit.h"
#include "uses/fit/nuisance_table.h"
#include "uses/fit/nuisances.h"

namespace coppermoon::uses {

/// Measured light at a distance from the shadow's axis, beside the light computed for the best-fitting air.
struct MeasuredLight {
  double distance_km;   ///< from the shadow's axis
  std::size_t channel;  ///< red, green, blue
  double light, model;  ///< relative to full sunlight
  double error;         ///< standard error of the light's logarithm
};

/// How a photograph's light in one channel differs from the light computed for an air: logarithms of their ratio. The
/// night's nuisance parameters are at their posterior mean, the photograph's own at 0.
struct Misfit {
  std::size_t photograph, channel;  ///< red, green, blue
  std::size_t count;                ///< number of measurements
  double chi_squared;               ///< its part of χ², with its own nuisance parameters
  double mean, scatter;             ///< weighted mean, and standard deviation about it
  double worst_km,
      worst;  ///< distance from the shadow's axis where χ² is largest, and the difference there
  std::string file{};  ///< of the photograph
};

/// Photographs from one camera and night as one data set: logarithms of light by bin and channel.
///
/// The noise of a measurement has three parts: its pixels' noise; the error of the Moon's map, 1.2 % for each area of
/// 200 km, about 0.3 % for a bin; and the error of the computation, 0.05 % of its value and 0.02 % of the bin's
/// brightest channel, which nearby bins share. The nuisance parameters come from nuisances_of.
class ComparedNight {
 public:
  /// Throws  Error  when fewer than six measurements are neither clipped nor lost in noise
  ComparedNight(std::span<const Binned> photographs, const NightErrors& errors);

  /// Number of measurements in all photographs.
  std::size_t count() const { return measurements_.size(); }
  /// Number of measurements in one photograph.
  std::size_t count_of(std::size_t photograph) const;

  /// Goodness of fit, with nuisance parameters marginalised.
  ///
  /// Given  light  computed for some air, in the rows of NightRows
  GoodnessOfFit goodness(const algebra::Grid<double>& light) const;

  /// Posterior mean of the tone curve, given the light of an air; the cameras' mean curve if light is linear.
  colour::ToneCurve curve(const algebra::Grid<double>& light) const;

  /// Posterior mean of the camera's matrix, given the light of an air.
  Mixing mixing(const algebra::Grid<double>& light) const;

  /// The photographs' light in steps of 100 km from the axis, given the light of an air. Nuisance parameters are at
  /// their posterior mean.
  std::vector<MeasuredLight> measured(const algebra::Grid<double>& light) const;

  /// Misfits by photograph, then channel, given the light of an air. Their parts of χ² are their terms in Σ r C⁻¹ r;
  /// together with the χ² of the night's own parameters they add up to the whole.
  std::vector<Misfit> misfits(const algebra::Grid<double>& light) const;

 private:
  /// Differences from an air's light, and how they change per second of the clock's correction.
  struct Residuals {
    std::vector<double> differences, per_second;
  };
  Residuals residuals(const algebra::Grid<double>& light) const;
  /// Differences from an air's light, with the clock at its posterior mean.
  std::vector<double> residuals_by_the_clock(const algebra::Grid<double>& light) const;

  NightErrors errors_;
  NightRows rows_;
  bool curved_ = false, mixed_ = false;
  double mixing_error_ = 0, saturation_error_ = 0;
  std::vector<Measurement> measurements_;
  std::vector<std::vector<double>> distances_km_;  // [photograph][bin]
  std::vector<std::array<double, 3>> sunlight_;    // [photograph][channel]
  std::map<std::string_view, std::size_t> first_;  // first column of each nuisance
  std::size_t first_own_ = 0;                      // first column of the photographs' own
  Nuisances nuisances_;
};

}  // namespace coppermoon::uses
