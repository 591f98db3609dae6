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
  double distance_km;   ///< distance from the shadow's axis
  std::size_t channel;  ///< 0 is red, 1 green, 2 blue
  double light, model;  ///< measured and computed light, relative to full sunlight
  double error;         ///< standard error of the logarithm of measured light
};

/// Difference between a photograph's light in one channel and the light computed for an air, as the logarithm of their
/// ratio. The nuisance parameters that a night shares have their posterior mean. Those of single photographs are 0.
struct Misfit {
  std::size_t photograph, channel;  ///< index of the photograph; channel 0 is red, 1 green, 2 blue
  std::size_t count;                ///< number of measurements
  double chi_squared;               ///< part of χ² that comes from this photograph and channel
  double mean, scatter;             ///< weighted mean difference, and its standard deviation
  double worst_km,
      worst;  ///< distance from the shadow's axis at which χ² is largest, and the difference there
  std::string file{};  ///< name of the photograph's file
};

/// Photographs from one camera and night as a data set. A measurement is the logarithm of light in a bin and channel.
///
/// The noise of a measurement has three parts. The first is the noise of its pixels. The second is the error of the
/// Moon's map, 1.2 % in each square of 200 km, or about 0.3 % in a bin. The third is the error of the computed light,
/// which nearby bins share: 0.1 % of the light and 0.02 % of the light in the bin's brightest channel. The nuisance
/// parameters come from nuisances_of.
class ComparedNight {
 public:
  /// Throws  Error  when fewer than six measurements are neither clipped nor lost in noise
  ComparedNight(std::span<const Binned> photographs, const NightErrors& errors);

  /// Number of measurements in all photographs.
  std::size_t count() const { return measurements_.size(); }
  /// Number of measurements in one photograph.
  std::size_t count_of(std::size_t photograph) const;

  /// Goodness of fit for an air, with the nuisance parameters marginalised.
  ///
  /// Given  light  computed for that air, with rows in the order of NightRows
  GoodnessOfFit goodness(const algebra::Grid<double>& light) const;

  /// Posterior mean of the camera's tone curve, given the light computed for an air. If the photographs are linear, the
  /// result is the mean curve of all cameras.
  colour::ToneCurve curve(const algebra::Grid<double>& light) const;

  /// Posterior mean of the camera's colour matrix, given the light computed for an air.
  Mixing mixing(const algebra::Grid<double>& light) const;

  /// Measured light in steps of 100 km of distance from the shadow's axis, together with the light computed for an air.
  /// Nuisance parameters have their posterior mean.
  std::vector<MeasuredLight> measured(const algebra::Grid<double>& light) const;

  /// Misfits for each photograph and channel, given the light of an air. The χ² of a misfit is part of (r − s)ᵀ C⁻¹ r,
  /// with the residuals r, their covariance C, and the part s of r that the night's shared parameters explain.
  std::vector<Misfit> misfits(const algebra::Grid<double>& light) const;

 private:
  /// Logarithms of measured / computed light, and the change of ln(computed light) per second of clock correction.
  struct Residuals {
    std::vector<double> differences, per_second;
  };
  Residuals residuals(const algebra::Grid<double>& light) const;
  /// Logarithms of measured light / computed light, with the clock correction at its posterior mean.
  std::vector<double> residuals_by_the_clock(const algebra::Grid<double>& light) const;

  NightErrors errors_;
  NightRows rows_;
  bool curved_ = false, mixed_ = false;
  double mixing_error_ = 0, saturation_error_ = 0;
  std::vector<Measurement> measurements_;
  std::vector<std::vector<double>> distances_km_;      // distance for each photograph and bin
  std::vector<std::array<double, 3>> sunlight_;        // sunlight for each photograph and channel
  std::vector<std::optional<CameraColours>> colours_;  // camera colours for each photograph
  std::map<std::string_view, std::size_t> first_;      // first matrix column of each nuisance
  std::size_t first_own_ = 0;  // first matrix column of single photographs' parameters
  Nuisances nuisances_;
};

}  // namespace coppermoon::uses
