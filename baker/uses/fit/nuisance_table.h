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

/// Weights of linear R, G, B (Rec.709) in luminance.
inline constexpr std::array luminance_of_rec709{0.2126, 0.7152, 0.0722};

/// Rows of a grid (row, X Y Z) that holds the light computed for an air in the bins of a night's photographs.
///
/// For each photograph in turn, the rows are its bins at one moment, then at the next. The moments are a minute before
/// its own, its own, and a minute after, if the clock may be wrong; else its own alone.
struct NightRows {
  std::size_t moments = 1, bins = 0;

  /// Row for a bin at a photograph's own moment.
  std::size_t own(std::size_t photograph, std::size_t bin) const {
    return at(photograph, moments / 2, bin);
  }
  std::size_t at(std::size_t photograph, std::size_t moment, std::size_t bin) const {
    return (photograph * moments + moment) * bins + bin;
  }
};

/// Offsets from each photograph's moment at which to compute light, for its derivative with respect to the clock [s].
/// The middle one is 0.
std::vector<double> clock_steps_s(double clock_error_s);

/// What is known about a night's light before comparison; errors are linear around it.
struct NightErrors {
  double clock_error_s = 0;   ///< standard error of the clock; 0: instants are exact
  double clock_mean_s = 0;    ///< mean of the clock's error, relative to the scenes' instants
  colour::ToneCurve curve{};  ///< with which light was binned, if it was not linear
  Mixing mixing = no_mixing;  ///< expected for the camera
  algebra::Grid<double>
      expected{};  ///< light for the best air, in NightRows; if empty, the usual air's
  algebra::Grid<double> clouded{};  ///< light for that air with more cloud; empty if not known
  double clouded_by = 0;  ///< ln(chance of cloud in `clouded` / in `expected`); 0: cloud is a deck
};

/// Rows for the light that a night's photographs are compared with.
NightRows rows_of(std::span<const Binned> photographs, const NightErrors& night);

/// Whether the camera's matrix is uncertain.
bool is_mixed(std::span<const Binned> photographs);

/// A measurement: the logarithm of light in one bin and channel of a photograph.
struct Measurement {
  std::size_t photograph, bin, channel;
  double logarithm;
  double error;           ///< independent error of this measurement
  double of_computation;  ///< error of the computation, which nearby bins share
};

/// Whether a nuisance has its parameters once for the night or for each photograph.
enum class SharedBy { night, photograph };

/// A row in the table of nuisances: parameters of one kind.
struct Nuisance {
  std::string_view name;
  SharedBy shared_by;
  std::size_t count;  ///< number of parameters, for the night or for each photograph
  /// Prior standard deviation of the parameters that affect this measurement; 0 if none does.
  std::function<double(const Measurement&)> prior;
  /// Derivative of the measurement's logarithm with respect to one parameter.
  std::function<double(const Measurement&, std::size_t parameter)> derivative;
};

/// Nuisances of a night: exposure, white balance, tone curve, the camera's matrix, saturation and filters, and weather
/// along the limb. Each photograph adds its own: shutter, white balance, sky, place and glow.
///
/// Given  photographs, night  must outlive the table
std::vector<Nuisance> nuisances_of(std::span<const Binned> photographs, const NightErrors& night);

/// Design matrix for a table of nuisances.
struct Design {
  algebra::Grid<double> matrix;                   ///< (measurement, parameter): derivative × prior
  std::map<std::string_view, std::size_t> first;  ///< first column of each nuisance
  std::size_t first_own = 0;  ///< first column of the photographs' own parameters
};

/// Given  table  nuisances of the night first, then those of photographs
Design design_of(std::span<const Nuisance> table, std::span<const Measurement> measurements,
                 std::size_t photographs);

/// A bin's light in linear Rec.709 as a camera writes it. Each channel is at least `least` times the brightest one.
std::array<double, 3> as_written(std::span<const double> xyz, const Mixing& mixing, double least);

}  // namespace coppermoon::uses
