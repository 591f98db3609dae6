// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "algebra/grid.h"
#include "colour/tone_curve.h"
#include "uses/fit/binned_photograph.h"

namespace coppermoon::uses {

/// Matrix from linear Rec.709 light to the linear light that a camera writes: [to][from].
using Mixing = std::array<std::array<double, 3>, 3>;
inline constexpr Mixing no_mixing{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

/// Order of the rows in a grid (row, X Y Z) of light computed for the bins of a night's photographs.
///
/// For each photograph in turn, there is a row for each of its bins at one moment, then at the next. If the clock may
/// be wrong, there are three moments: a minute before the photograph's time, that time, and a minute after. Otherwise,
/// there is only the photograph's time.
struct NightRows {
  std::size_t moments = 1, bins = 0;

  /// Row of a bin at the time of the photograph itself.
  std::size_t own(std::size_t photograph, std::size_t bin) const {
    return at(photograph, moments / 2, bin);
  }
  std::size_t at(std::size_t photograph, std::size_t moment, std::size_t bin) const {
    return (photograph * moments + moment) * bins + bin;
  }
};

/// Offsets from a photograph's time at which light is computed [s]. They give the derivative of light with respect to
/// the clock correction. The middle one is 0.
std::vector<double> clock_steps_s(double clock_error_s);

/// What is known about a night's clock, camera and light before the fit. Errors are linearised around these values.
struct NightErrors {
  double clock_error_s = 0;   ///< standard error of the clock; 0 if times are exact
  double clock_mean_s = 0;    ///< prior mean of a further correction to the scenes' times
  colour::ToneCurve curve{};  ///< tone curve undone before binning, if light was not linear
  Mixing mixing = no_mixing;  ///< colour matrix that is expected for the camera
  algebra::Grid<double>
      expected{};  ///< light for the best air, in rows of NightRows; if empty, the scenes' is used
  algebra::Grid<double> clouded{};  ///< light for the best air with more cloud; empty if unknown
  algebra::Grid<double> dusty{};    ///< light for the best air with more aerosol; empty if unknown
  double dusty_by = 0;              ///< ln(aerosol in `dusty` / aerosol in `expected`)
  double clouded_by = 0;  ///< ln(cloud chance in `clouded` / `expected`); 0 if cover is fitted
};

/// Order of rows for the computed light of a night's photographs.
NightRows rows_of(std::span<const Binned> photographs, const NightErrors& night);

/// Whether the camera's colour matrix is uncertain.
bool is_mixed(std::span<const Binned> photographs);

/// A measurement: the logarithm of light in one bin and channel of a photograph.
struct Measurement {
  std::size_t photograph, bin, channel;
  double logarithm;
  double error;           ///< independent error of this measurement
  double of_computation;  ///< error of computed light, shared by nearby bins
};

/// Whether all photographs of a night share a nuisance's parameters, or each photograph has its own.
enum class SharedBy { night, photograph };

/// A row in the table of nuisances: one kind of error, with one or more parameters.
struct Nuisance {
  std::string_view name;
  SharedBy shared_by;
  std::size_t count;  ///< number of parameters per night or per photograph
  /// Prior standard deviation of the parameters for a given measurement; 0 if they do not affect the measurement.
  std::function<double(const Measurement&)> prior;
  /// Derivative of a measurement, a logarithm of light, with respect to one of the parameters.
  std::function<double(const Measurement&, std::size_t parameter)> derivative;
};

/// Table of the nuisance parameters of a night. All photographs share errors of exposure, white balance, tone
/// curve, saturation, colour matrix, dark channels, filters, weather and aerosol. Each photograph also has its own
/// errors of shutter time, white balance, dark channels, sky light, place in the shadow, and glow.
///
/// Given  photographs, night  must outlive the table
std::vector<Nuisance> nuisances_of(std::span<const Binned> photographs, const NightErrors& night);

/// Design matrix for a table of nuisances.
struct Design {
  algebra::Grid<double> matrix;                   ///< derivative × prior: (measurement, parameter)
  std::map<std::string_view, std::size_t> first;  ///< first column of each nuisance
  std::size_t first_own = 0;  ///< first column of parameters of only one photograph
};

/// Computes the design matrix for a table of nuisances.
///
/// Given  table  with the nuisances that all photographs share first, then those that each has for itself
Design design_of(std::span<const Nuisance> table, std::span<const Measurement> measurements,
                 std::size_t photographs);

/// A bin's light as a camera with the given colour matrix writes it, in linear Rec.709. Each channel is raised to at
/// least `least` times the brightest one.
std::array<double, 3> as_written(std::span<const double> xyz,
                                 const std::optional<CameraColours>& colours, const Mixing& mixing,
                                 double least);

}  // namespace coppermoon::uses
