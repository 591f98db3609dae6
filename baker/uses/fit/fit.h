// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "algebra/error.h"
#include "algebra/progress.h"
#include "almanac/instant.h"
#include "colour/registration.h"
#include "texture/read_image.h"
#include "uses/fit/air_fit.h"
#include "uses/fit/compared_night.h"
#include "uses/fit/magnitudes.h"
#include "uses/picture/moon.h"
#include "uses/picture/view.h"

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
  /// standard, of the exposures' logarithm, common to a night's photographs, 0.001 to 10; of a camera's own
  /// tone curve any is as likely
  double exposure_error = 0.1;
  /// standard, of red and blue over green, 0.001 to 10; without: 0.03, of a camera's own tone curve 0.3
  std::optional<double> white_balance_error = {};
  double clock_error_s = 0;  ///< standard, of each camera's clock, 0 to 3600; 0: instants are right
  bool half_hours_free =
      false;  ///< instants may be wrong by any whole number of half hours besides
};

/// A photograph as it was read.
struct ReadPhotograph {
  colour::Registration registration{};
  bool exposure_known = false;  ///< else any exposure is as likely
  std::size_t numbers = 0;      ///< how many it gave
  bool curved = false;          ///< its camera's tone curve was in question
  std::string left_out{};       ///< why it tells nothing, one line; empty: it does
};

/// An error's line without the file's name, where it begins with that.
std::string reason_without_name(const std::string& file, const algebra::Error& error);

/// What was found of the camera of one night.
struct FittedNight {
  std::vector<std::size_t> photographs;  ///< of the request
  std::optional<ClockError> clock;       ///< what is to be added to its instants, where asked for
  std::optional<colour::ToneCurve> curve;
  std::vector<MeasuredLight> light;  ///< in order of distance
};

/// What was found, and from what.
struct FitReport {
  AirFit fit;
  std::vector<ReadPhotograph> photographs;  ///< in the order of the request
  std::vector<FittedNight> nights;
};

/// The dust, cloud cover and ozone that photographs and magnitudes of eclipses tell of, all at once:
///
///     FitRequest request{.photographs = {{"a.jpg", almanac::instant_from_utc("2018-07-27T20:40")}}};
///     request.view.observer = almanac::Observer{algebra::degrees(36), algebra::degrees(38), {}};
///     const auto found = fitted_air(request);
///     if (explains(found.fit)) use(found.fit.posterior.estimates);
///
/// Photographs of one camera and eclipse share a clock, a tone curve, and a factor of exposure. One of
/// several that cannot be used is left out.
///
/// Given   progress  told the part that is done; what it throws ends the fit
/// Throws  Error  when there is nothing to explain, or an error is outside its range; when no eclipse
///                is under way, or the Moon is below the horizon; "<file>: …" when none of the
///                photographs can be used
FitReport fitted_air(const FitRequest& request, const algebra::Progress& progress = {});

}  // namespace coppermoon::uses
