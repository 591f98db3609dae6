// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "almanac/instant.h"
#include "colour/registration.h"
#include "texture/read_image.h"
#include "uses/picture/moon.h"
#include "uses/picture/view.h"
#include "uses/study/fit_air.h"
#include "uses/study/fit_magnitudes.h"

namespace coppermoon::uses {

/// A photograph of an eclipsed Moon, and what is known of how it was taken.
struct EclipsePhotograph {
  std::string file;
  almanac::Instant instant;                                    ///< when it was taken
  texture::Coding coding = texture::Coding::as_file_says;      ///< of its numbers
  std::optional<double> time_s = {}, iso = {}, f_number = {};  ///< without: as its header says
};

/// What is to be explained, and all that is taken for known.
struct FitRequest {
  std::vector<EclipsePhotograph> photographs = {};
  std::vector<MeasuredMagnitude> magnitudes = {};
  /// the air but for dust, cloud cover and ozone; limb darkening, scattered light, starlight; the map
  /// and photometry. Nothing else of it counts
  MoonRequest moon = {};
  ViewRequest view = {};  ///< the photographs' observer and the air above
  /// one of colour::camera_names(), for its saturation; empty: by ISO 12232
  std::string camera = {};
  double exposure_error = 0.1;        ///< standard, of its logarithm, 0.001 to 10
  double white_balance_error = 0.03;  ///< standard, of red and blue over green, 0.001 to 10
};

/// A photograph as it was read.
struct ReadPhotograph {
  colour::Registration registration;
  bool exposure_known;  ///< else any exposure is as likely
  std::size_t numbers;  ///< how many it gave
};

/// What was found, and from what.
struct FitReport {
  AirFit fit;
  std::vector<ReadPhotograph> photographs;  ///< in the order of the request
};

/// The dust, cloud cover and ozone that photographs and magnitudes of eclipses tell of, all at once:
///
///     FitRequest request{.photographs = {{"a.jpg", almanac::instant_from_utc("2018-07-27T20:40")}}};
///     request.view.observer = almanac::Observer{algebra::degrees(36), algebra::degrees(38), {}};
///     const auto [fit, photographs] = fitted_air(request);
///     if (explains(fit)) use(fit.posterior.estimates);
///
/// Throws  Error  when there is nothing to explain, or an error is outside its range; when no eclipse
///                is under way, or the Moon is below the horizon; "<file>: …" when a photograph cannot
///                be read, registered or used
FitReport fitted_air(const FitRequest& request);

}  // namespace coppermoon::uses
