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

/// Linear light that a camera writes for linear Rec.709 light: [to][from].
using Mixing = std::array<std::array<double, 3>, 3>;
inline constexpr Mixing no_mixing{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

/// Luminance of linear Rec.709.
inline constexpr std::array luminance_of_rec709{0.2126, 0.7152, 0.0722};

/// Light of an air in the bins of a night's photographs: (row, X Y Z).
///
/// Rows are bins of a photograph at one moment, then at the next: moments a minute before and after its own where the
/// clock may be wrong, else its own alone; then those of the next photograph.
struct NightRows {
  std::size_t moments = 1, bins = 0;

  /// Row of a bin at a photograph's own moment.
  std::size_t own(std::size_t photograph, std::size_t bin) const {
    return at(photograph, moments / 2, bin);
  }
  std::size_t at(std::size_t photograph, std::size_t moment, std::size_t bin) const {
    return (photograph * moments + moment) * bins + bin;
  }
};

/// Moments beside each photograph's at which light is computed, for its derivative by the clock [s]: its own in the
/// middle.
std::vector<double> clock_steps_s(double clock_error_s);

/// What is known of a night's light before it is compared, about which errors are linear.
struct NightErrors {
  double clock_error_s = 0;   ///< standard error of the clock; 0: instants are exact
  double clock_mean_s = 0;    ///< mean of the clock's error, from the scenes' instants
  colour::ToneCurve curve{};  ///< with which light was binned, where a curve is in question
  Mixing mixing = no_mixing;  ///< expected of the camera
  algebra::Grid<double>
      expected{};                   ///< light of the best air, as NightRows; empty: the usual air's
  algebra::Grid<double> clouded{};  ///< light of that air under more cloud; empty: not known
  double clouded_by = 0;  ///< ln(chance of cloud of `clouded` / of `expected`); 0: cloud is a deck
};

/// Rows of light that a night's photographs are compared with.
NightRows rows_of(std::span<const Binned> photographs, const NightErrors& night);

/// Whether the matrix of the camera is in question.
bool is_mixed(std::span<const Binned> photographs);

/// A measurement: the logarithm of light in one bin and channel of a photograph.
struct Measurement {
  std::size_t photograph, bin, channel;
  double logarithm;
  double error;           ///< of this measurement alone
  double of_computation;  ///< error of the computation, which bins close by share
};

/// Whose parameters those of a nuisance are.
enum class SharedBy { night, photograph };

/// A row of the table of nuisances: parameters of one kind.
struct Nuisance {
  std::string_view name;
  SharedBy shared_by;
  std::size_t count;  ///< parameters: of the night, or of each photograph
  /// Standard deviation before anything is measured, of those that this measurement grows with; 0: it grows with none.
  std::function<double(const Measurement&)> prior;
  /// Growth of the measurement's logarithm with one of them.
  std::function<double(const Measurement&, std::size_t parameter)> derivative;
};

/// Nuisances of a night: exposure, white balance, tone curve, the camera's matrix, saturation and filters, weather
/// along the limb; of each photograph shutter, white balance, sky, place and glow.
///
/// Given  photographs, night  outlive the table
std::vector<Nuisance> nuisances_of(std::span<const Binned> photographs, const NightErrors& night);

/// Design matrix of a table of nuisances.
struct Design {
  algebra::Grid<double> matrix;                   ///< (measurement, parameter): derivative × prior
  std::map<std::string_view, std::size_t> first;  ///< column where a nuisance begins
  std::size_t first_own = 0;                      ///< column where parameters of photographs begin
};

/// Given  table  nuisances of the night before those of photographs
Design design_of(std::span<const Nuisance> table, std::span<const Measurement> measurements,
                 std::size_t photographs);

/// Light of a bin in linear Rec.709 as a camera writes it, in each channel at least `least` of the brightest channel.
std::array<double, 3> as_written(std::span<const double> xyz, const Mixing& mixing, double least);

}  // namespace coppermoon::uses
