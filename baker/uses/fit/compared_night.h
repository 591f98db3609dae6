// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "colour/tone_curve.h"
#include "uses/fit/air_fit.h"
#include "uses/fit/nuisances.h"
#include "uses/fit/photograph.h"

namespace coppermoon::uses {

/// What is known of a photograph's scale.
struct PhotometricErrors {
  std::optional<double> value_per_cd_m2 = {};  ///< photograph's value of 1 cd/m²; without: any
  double exposure_error = 0.1;  ///< standard error of its logarithm, the same in all of a night
  double white_balance_error = 0.03;  ///< the same of red and of blue over green
  bool white_balance_fixed = false;   ///< the same in all of a night; else each has its own
  double place_error_km = 0;          ///< of the registration, towards the shadow's axis
};

/// A photograph of a night.
struct NightPhotograph {
  FitScene scene;
  BinnedPhotograph light;
  PhotometricErrors errors{};
};

/// What the photographs of one camera and night have in common.
struct NightErrors {
  double clock_error_s = 0;   ///< standard, of all their instants; 0: they are right
  colour::ToneCurve curve{};  ///< with which light was binned, where a curve is in question
};

/// Moments beside each photograph's at which light is computed, so that a clock's error is known to it [s].
std::vector<double> clock_steps_s(double clock_error_s);

/// Light of photographs and of moments beside them, as ComparedNight takes it.
///
/// Given  skies  in which they were taken: as assumed for the scenes, or others
FittedLight night_light(const LightRequest& request, std::span<const NightPhotograph> photographs,
                        std::span<const almanac::Instant> instants, double clock_error_s,
                        FittedAirs airs = FittedAirs::fine, const algebra::Progress& progress = {});

/// Light that was measured over what there is in full sunlight, and what the air that explains it best
/// has there.
struct MeasuredLight {
  double distance_km;  ///< from the shadow's axis
  std::size_t channel;
  double light, model;
  double error;  ///< standard, of the logarithm of light
};

/// The photographs of one camera and night, as one witness of the air.
///
/// The logarithms of what bins and channels hold are compared. Each has the error of its own noise; that of
/// the map of the Moon, 1.2 % in each place of 200 km, so about 0.3 % of a whole bin; and of the computation 0.1 %
/// that channels and bins close by share, 0.1 % of its value and 0.03 % of the bin's brightest. All share a tone
/// curve, where one is in question, a clock and the exposure's error; each has 3 % of exposure of its own, as
/// shutters and irises have, and the colours of its white balance.
class ComparedNight {
 public:
  /// Throws  Error  when fewer than six numbers are neither clipped nor lost in noise
  ComparedNight(std::span<const NightPhotograph> photographs, const NightErrors& errors);

  std::size_t count() const { return numbers_.size(); }
  std::size_t count_of(std::size_t photograph) const;

  /// Given  light  X, Y, Z of all bins: night_light's at some air
  Weighed weighed(const algebra::Grid<double>& light) const;

  /// The tone curve that makes light that of the photographs; the mean of cameras where none is in
  /// question.
  colour::ToneCurve curve(const algebra::Grid<double>& light) const;

  /// Photographs' light, with exposure, colours and curve as the light of the best air has them, in
  /// steps of 100 km from the axis.
  std::vector<MeasuredLight> measured(const algebra::Grid<double>& light) const;

 private:
  struct Number {
    std::size_t photograph, bin, channel;
    double logarithm;
    double error;  ///< of this number alone
  };
  /// Differences from an air's light, and how they grow with a second of the clock.
  struct Residuals {
    std::vector<double> apart, a_second;
  };
  Residuals residuals(const algebra::Grid<double>& light) const;
  void add_numbers(const NightPhotograph& photograph, std::size_t index);
  /// Of each photograph's numbers.
  std::vector<algebra::Grid<double>> own_covariances(
      std::span<const NightPhotograph> photographs) const;
  algebra::Grid<double> effects(std::span<const NightPhotograph> photographs) const;

  NightErrors errors_;
  std::size_t bins_ = 0;
  bool curved_ = false;
  std::vector<Number> numbers_;
  std::vector<std::vector<double>> distances_km_;  // [photograph][bin]
  std::vector<std::array<double, 3>> sunlight_;    // [photograph][channel]
  Nuisances nuisances_;
};

}  // namespace coppermoon::uses
