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
#include "uses/picture/photo_file.h"
#include "uses/picture/view.h"

namespace coppermoon::uses {

/// A photograph of an eclipsed Moon, and how it was taken.
struct EclipsePhotograph {
  std::string file;
  almanac::Instant instant;
  texture::Coding coding = texture::Coding::as_file_says;      ///< of its pixel values
  std::optional<double> time_s = {}, iso = {}, f_number = {};  ///< without: by its header
};

/// Data to be fitted, and all that is taken for known.
struct FitRequest {
  std::optional<Unknowns> unknowns = {};  ///< of the air; without: usual_unknowns
  std::vector<EclipsePhotograph> photographs = {};
  std::vector<MeasuredMagnitude> magnitudes = {};
  /// air but for the unknowns; limb darkening, scattered light, starlight; map and photometry;
  /// the rest is ignored
  MoonRequest moon = {};
  ViewRequest view = {};  ///< observer of the photographs, and the air above
  /// one of colour::camera_names(), for its saturation; empty: by ISO 12232
  std::string camera = {};
  /// standard error of the exposures' logarithm, common to a night's photographs, 0.001 to 10; without: 0.1, with a
  /// camera's own tone curve 10, which leaves it free
  std::optional<double> exposure_error = {};
  /// standard error of the logarithm of one exposure beside the night's others, 0.001 to 10
  double shutter_error = 0.03;
  /// standard error of the logarithms of red and blue over green, 0.001 to 10; without: 0.03, with a camera's
  /// own tone curve 0.3
  std::optional<double> white_balance_error = {};
  /// standard error of the light of 30 degrees of the limb by weather in usual air, 0 to 1; without: 0.1 for a
  /// camera's own JPEGs and raw files, else 0
  std::optional<double> weather_error = {};
  /// standard error of each camera's clock, 0 to 3600; 0: exact; above 300 the clock is looked for over three errors
  double clock_error_s = 0;
  bool response_assumed = false;  ///< the Moon's response stands for that of an unknown camera
  bool half_hours_free = false;   ///< any whole number of half hours may be added to instants
  /// how far a clock may be wrong beyond that error, where partial phases tell it [s]; 0: no farther
  double clock_search_s = 0;
};

/// A photograph as it was read.
struct ReadPhotograph {
  colour::Registration registration{};
  bool exposure_known = false;            ///< else the exposure is free
  std::size_t measurements = 0;           ///< bins and channels used
  bool curved = false;                    ///< its camera's tone curve was in question
  std::optional<ClippedAt> clipped_at{};  ///< where that is not 1
  std::string left_out{};                 ///< reason in one line; empty: it was used
  std::string file{};
  std::optional<std::string> instant{};  ///< as it was told, UTC; none: it has no date
};

/// Message of an error, without the file's name that it begins with.
std::string reason_without_name(const std::string& file, const algebra::Error& error);

/// Why a night is looked at again with what was found.
enum class Again {
  no,            ///< nothing of it would change
  in_its_air,    ///< its photographs were registered in usual air
  by_its_curve,  ///< its photographs were read by a tone curve that has changed
  nearby         ///< its light is computed at nodes too far from the air found
};

/// Camera of one night, as found.
struct FittedNight {
  std::vector<std::size_t> photographs;  ///< of the request
  std::optional<ClockError> clock;       ///< where clock_error_s > 0
  /// through which its camera sees: asked for, known by its name, or usual
  std::optional<std::string> response;
  std::optional<colour::ToneCurve> curve;
  std::vector<MeasuredLight> light;  ///< in order of distance
  std::vector<Misfit> misfits;       ///< photographs of the request
  std::vector<Again> turns;          ///< why it was looked at again, each time
  std::vector<std::string> files;    ///< of its photographs
};

/// Air that was found, and the photographs and cameras that it is from.
struct FitReport {
  AirFit fit;
  std::vector<ReadPhotograph> photographs;  ///< in the order of the request
  std::vector<FittedNight> nights;
};

/// Unknowns that a request looks for.
Unknowns unknowns_of(const FitRequest& request);

/// Fits aerosol, cloud and ozone to photographs and magnitudes of eclipses, jointly:
///
///     FitRequest request{.photographs = {{"a.jpg", almanac::instant_from_utc("2018-07-27T20:40")}}};
///     request.view.observer = almanac::Observer{algebra::degrees(36), algebra::degrees(38), {}};
///     const auto found = fitted_air(request);
///     if (explains(found.fit)) use(found.fit.posterior.estimates);
///
/// Without a response, light is seen through the filters of the camera that a header names, where these are known; by
/// JPEGs of others through those of a Canon EOS 600D, for cameras differ less among each other than from the CIE
/// observer; that others and the observer differ from it is an error of the light then. Photographs of one camera and
/// eclipse share a clock, a tone curve, and an error of exposure. A photograph that cannot be used is left out while
/// there are other data.
///
/// Given   progress  called with the part that is done; an exception of it ends the fit
/// Throws  Error  when there are no data, or an error is outside its range; when no eclipse
///                is under way, or the Moon is below the horizon; "<file>: …" when none of the
///                photographs can be used
FitReport fitted_air(const FitRequest& request, const algebra::Progress& progress = {});

}  // namespace coppermoon::uses
