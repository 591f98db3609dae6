// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "colour/tone_curve.h"
#include "uses/fit/air_fit.h"
#include "uses/fit/nuisances.h"
#include "uses/fit/photograph.h"

namespace coppermoon::uses {

/// Photometric scale of a photograph, and its standard errors.
struct PhotometricErrors {
  std::optional<double> value_per_cd_m2 = {};  ///< pixel value of 1 cd/m²; without: unknown
  double exposure_error = 0.1;  ///< of the exposure's logarithm, common to a night; 10: unknown
  double shutter_error = 0.03;  ///< of the logarithm of this exposure beside the night's others
  double white_balance_error = 0.03;  ///< of the logarithms of red and blue over green
  bool white_balance_fixed = false;   ///< common to a night; else each photograph has its own
  double place_error_km = 0;          ///< of the registration, towards the shadow's axis
  /// of a part of the limb 30 degrees wide by its weather, in red; a fifth more in green, half more in blue
  double weather_error = 0;
  double mixing_error = 0;      ///< of each element of the camera's matrix off its diagonal
  double saturation_error = 0;  ///< of the saturation of its colours, as styles of JPEG have it
};

/// Linear light that a camera writes for linear Rec.709 light: [to][from].
using Mixing = std::array<std::array<double, 3>, 3>;
inline constexpr Mixing no_mixing{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

/// A photograph in the bins of its scene.
struct NightPhotograph {
  FitScene scene;
  BinnedPhotograph light;
  PhotometricErrors errors{};
};

/// Camera of a night: errors that its photographs share.
struct NightErrors {
  double clock_error_s = 0;   ///< standard error of the clock; 0: instants are exact
  double clock_mean_s = 0;    ///< of that error's distribution, from the scenes' instants
  colour::ToneCurve curve{};  ///< with which light was binned, where a curve is in question
  Mixing mixing = no_mixing;  ///< expected, about which errors are small
  /// XYZ of all bins, as night_light has it, about which mixing is linear; empty: that of the usual air
  algebra::Grid<double> expected{};
  /// Light of the same air under more cloud, for its derivative by weather; empty: that of a rough formula.
  algebra::Grid<double> clouded{};
  /// Logarithm of that cloud's chance over the first's; 0: cloud is not a chance.
  double clouded_by = 0;
};

/// Model light of a night's photographs, and of moments a minute beside them where the clock may be wrong.
///
/// Given    instants  of the photographs: those of their scenes, or others
/// Returned           bins of the photographs in their order, as ComparedNight takes them
FittedLight night_light(const LightRequest& request, Unknowns unknowns,
                        std::span<const NightPhotograph> photographs,
                        std::span<const almanac::Instant> instants, double clock_error_s,
                        FittedAirs airs = FittedAirs::fine, const algebra::Progress& progress = {},
                        const std::optional<AirRange>& range = {});

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
};

/// Photographs of one camera and night as one data set: logarithms of light by bin and channel.
///
/// Noise of a measurement is that of its pixels; 1.2 % of the Moon's map in each place of 200 km, about 0.3 % of a bin;
/// and of the computation, alike in bins close by, 0.05 % of its value and 0.02 % of the bin's brightest channel.
/// Nuisance parameters are, of the night, the exposure, a fixed white balance, the tone curve where one is in question,
/// the clock, the camera's matrix and saturation, its filters where they are not known, and the weather of twelve parts
/// of the limb in each hour; of each photograph its exposure beside the others', as shutters and irises have it, the
/// white balance, the registration, the sky and the glow.
class ComparedNight {
 public:
  /// Throws  Error  when fewer than six bins and channels are neither clipped nor lost in noise
  ComparedNight(std::span<const NightPhotograph> photographs, const NightErrors& errors);

  /// Measurements of all photographs.
  std::size_t count() const { return measurements_.size(); }
  /// Measurements of one photograph.
  std::size_t count_of(std::size_t photograph) const;

  /// Goodness of fit, nuisance parameters marginalised.
  ///
  /// Given  light  night_light's X, Y, Z of all bins in some air
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
  struct Measurement {
    std::size_t photograph, bin, channel;
    double logarithm;
    double error;           ///< of this measurement alone
    double of_computation;  ///< error that is like those of its channel's other bins
  };
  /// Differences from an air's light, and their growth with a second of the clock.
  struct Residuals {
    std::vector<double> differences, per_second;
  };
  Residuals residuals(const algebra::Grid<double>& light) const;
  /// Differences with the clock at its posterior mean.
  std::vector<double> residuals_by_the_clock(const algebra::Grid<double>& light) const;
  void add_measurements(const NightPhotograph& photograph, std::size_t index);
  /// Noise covariance of each photograph's measurements.
  std::vector<algebra::Grid<double>> noise(std::span<const NightPhotograph> photographs) const;
  /// Design matrix of the nuisance parameters: (measurement, parameter).
  algebra::Grid<double> design(std::span<const NightPhotograph> photographs) const;
  /// Light of a bin in linear Rec.709 as the camera writes it, by the mixing expected.
  std::array<double, 3> as_written(std::span<const double> xyz) const;
  /// Light that a bin of a photograph is expected to have, in linear Rec.709 without mixing.
  std::array<double, 3> expected_of(const NightPhotograph& photograph, std::size_t index,
                                    std::size_t bin) const;

  /// Decrease of the logarithm of light by cloud, (photograph × bins + bin, channel), over its mean of red in the umbra;
  /// where cloud is a chance, times weather_over_usual; empty where it is not known.
  algebra::Grid<double> dimming_by_cloud() const;
  /// Writes a measurement's growth with the camera's saturation and the elements of its matrix.
  void add_mixing(const NightPhotograph& photograph, const Measurement& measurement,
                  std::span<double> night) const;

  NightErrors errors_;
  std::size_t bins_ = 0;
  bool curved_ = false, mixed_ = false;
  double mixing_error_ = 0, saturation_error_ = 0;
  std::vector<Measurement> measurements_;
  std::vector<std::vector<double>> distances_km_;  // [photograph][bin]
  std::vector<std::array<double, 3>> sunlight_;    // [photograph][channel]
  Nuisances nuisances_;
};

}  // namespace coppermoon::uses
