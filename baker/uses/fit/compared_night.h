// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "uses/fit/air_fit.h"
#include "uses/fit/nuisance_table.h"
#include "uses/fit/nuisances.h"

namespace coppermoon::uses {

/// Measured light at a distance from the shadow's axis, beside that of the air of the least χ².
struct MeasuredLight {
  double distance_km;   ///< from the shadow's axis
  std::size_t channel;  ///< red, green, blue
  double light, model;  ///< over full sunlight
  double error;         ///< standard error of the light's logarithm
};

/// Difference of a photograph's light in one channel from that of an air, the night's nuisance parameters at their
/// posterior mean, the photograph's own at 0: logarithms of light over that of the air.
struct Misfit {
  std::size_t photograph, channel;  ///< red, green, blue
  std::size_t count;                ///< of measurements
  double chi_squared;               ///< part of χ², own nuisance parameters included
  double mean, scatter;             ///< weighted mean, standard deviation about it
  double worst_km,
      worst;  ///< distance from the shadow's axis of the largest part of χ²; difference there
  std::string file{};  ///< of the photograph
};

/// Photographs of one camera and night as one data set: logarithms of light by bin and channel.
///
/// Noise of a measurement is that of its pixels; 1.2 % of the Moon's map in each place of 200 km, about 0.3 % of a bin;
/// and of the computation, alike in bins close by, 0.05 % of its value and 0.02 % of the bin's brightest channel.
/// Nuisances are those of nuisances_of.
class ComparedNight {
 public:
  /// Throws  Error  when fewer than six bins and channels are neither clipped nor lost in noise
  ComparedNight(std::span<const Binned> photographs, const NightErrors& errors);

  /// Measurements of all photographs.
  std::size_t count() const { return measurements_.size(); }
  /// Measurements of one photograph.
  std::size_t count_of(std::size_t photograph) const;

  /// Goodness of fit, nuisance parameters marginalised.
  ///
  /// Given  light  of some air, as NightRows
  GoodnessOfFit goodness(const algebra::Grid<double>& light) const;

  /// Posterior mean of the tone curve, given the light of an air; the mean of cameras where no curve is in
  /// question.
  colour::ToneCurve curve(const algebra::Grid<double>& light) const;

  /// Posterior mean of the camera's matrix, given the light of an air.
  Mixing mixing(const algebra::Grid<double>& light) const;

  /// Photographs' light in steps of 100 km from the axis, nuisance parameters at their posterior mean, given
  /// the light of an air.
  std::vector<MeasuredLight> measured(const algebra::Grid<double>& light) const;

  /// Misfits of photographs and channels, given the light of an air, in that order. Their parts of χ² are those of
  /// Σ r C⁻¹ r; with χ² of the night's own parameters they make up the whole.
  std::vector<Misfit> misfits(const algebra::Grid<double>& light) const;

 private:
  /// Differences from an air's light, and their growth with a second of the clock.
  struct Residuals {
    std::vector<double> differences, per_second;
  };
  Residuals residuals(const algebra::Grid<double>& light) const;
  /// Differences with the clock at its posterior mean.
  std::vector<double> residuals_by_the_clock(const algebra::Grid<double>& light) const;

  NightErrors errors_;
  NightRows rows_;
  bool curved_ = false, mixed_ = false;
  double mixing_error_ = 0, saturation_error_ = 0;
  std::vector<Measurement> measurements_;
  std::vector<std::vector<double>> distances_km_;  // [photograph][bin]
  std::vector<std::array<double, 3>> sunlight_;    // [photograph][channel]
  std::map<std::string_view, std::size_t> first_;  // column of a nuisance
  std::size_t first_own_ = 0;                      // column of the photographs' own
  Nuisances nuisances_;
};

}  // namespace coppermoon::uses
