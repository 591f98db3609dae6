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
  texture::Coding coding = texture::Coding::as_file_says;      ///< how its pixel values are coded
  std::optional<double> time_s = {}, iso = {}, f_number = {};  ///< if absent, from its header
};

/// Data to be fitted, and everything that is taken as known.
struct FitRequest {
  std::optional<Unknowns> unknowns = {};  ///< of the air; if absent, usual_unknowns
  std::vector<EclipsePhotograph> photographs = {};
  std::vector<MeasuredMagnitude> magnitudes = {};
  /// The air apart from the unknowns, limb darkening, scattered light, starlight, map and photometry; the rest is
  /// ignored.
  MoonRequest moon = {};
  ViewRequest view = {};  ///< observer of the photographs, and the air above
  /// One of colour::camera_names(), for its saturation; if empty, saturation follows ISO 12232.
  std::string camera = {};
  /// Standard error of the logarithm of exposure, shared by a night's photographs, 0.001 to 10; if absent, 0.1, or 10
  /// with a camera's own tone curve, which leaves the exposure free.
  std::optional<double> exposure_error = {};
  /// Standard error of the logarithm of one exposure relative to the night's others, 0.001 to 10.
  double shutter_error = 0.03;
  /// Standard error of the logarithms of red / green and blue / green, 0.001 to 10; if absent, 0.03, or 0.3 with a
  /// camera's own tone curve.
  std::optional<double> white_balance_error = {};
  /// Standard error, due to weather in usual air, of the light from 30 degrees of the limb, 0 to 1; if absent, 0.1 for
  /// a camera's own JPEGs and raw files, else 0.
  std::optional<double> weather_error = {};
  /// Standard error of each camera's clock, 0 (exact) to 3600 s; above 300, the fit searches within three errors.
  double clock_error_s = 0;
  bool response_assumed = false;  ///< the response in `moon` stands in for an unknown camera's
  bool half_hours_free = false;   ///< instants may be off by any whole number of half hours
  /// How much further a clock may be off than its error, if partial phases show it [s]; 0: no further.
  double clock_search_s = 0;
};

/// What was read from a photograph.
struct ReadPhotograph {
  colour::Registration registration{};
  bool exposure_known = false;   ///< if not, the exposure is free
  std::size_t measurements = 0;  ///< number of bins and channels used
  bool curved = false;           ///< whether it has its camera's own tone curve, which is fitted
  std::optional<ClippedAt> clipped_at{};  ///< number that counts as clipped, if not 1
  std::string left_out{};  ///< why it was left out, in one line; empty if it was used
  std::string file{};
  std::optional<std::string> instant{};  ///< as stated, UTC; none if it has no date
};

/// The message of an error, without the file name at its beginning.
std::string reason_without_name(const std::string& file, const algebra::Error& error);

/// Why a night is processed again with the results of the fit.
enum class Again {
  no,            ///< nothing would change
  in_its_air,    ///< its photographs were registered in usual air
  by_its_curve,  ///< its photographs were read with a tone curve that has since changed
  nearby         ///< its light was computed at nodes too far from the air that was found
};

/// What was found about the camera of one night.
struct FittedNight {
  std::vector<std::size_t> photographs;  ///< indices in the request
  std::optional<ClockError> clock;       ///< if clock_error_s > 0
  /// Response of its camera: the one asked for, the one known by the camera's name, or the usual one.
  std::optional<std::string> response;
  std::optional<colour::ToneCurve> curve;
  std::vector<MeasuredLight> light;  ///< ordered by distance
  std::vector<Misfit> misfits;       ///< their photographs are indices in the request
  std::vector<Again> turns;          ///< why it was processed again, each time
  std::vector<std::string> files;    ///< of its photographs
};

/// The air that was found, and the photographs and cameras it was found from.
struct FitReport {
  AirFit fit;
  std::vector<ReadPhotograph> photographs;  ///< in the order of the request
  std::vector<FittedNight> nights;
};

/// The unknowns that a request asks to fit.
Unknowns unknowns_of(const FitRequest& request);

/// Fits aerosol, cloud and ozone to photographs and magnitudes of eclipses, jointly:
///
///     FitRequest request{.photographs = {{"a.jpg", almanac::instant_from_utc("2018-07-27T20:40")}}};
///     request.view.observer = almanac::Observer{algebra::degrees(36), algebra::degrees(38), {}};
///     const auto found = fitted_air(request);
///     if (explains(found.fit)) use(found.fit.posterior.estimates);
///
/// If no response is given, light is seen through the filters of the camera that the header names, if they are known.
/// JPEGs from other cameras use the filters of a Canon EOS 600D, because cameras differ less from each other than from
/// the CIE observer; the differences of other cameras and the observer from it then count as an error of the light.
/// Photographs from one camera and eclipse share a clock, a tone curve, and an error of exposure. A photograph that
/// cannot be used is left out as long as other data remain.
///
/// Given   progress  called with the fraction done; an exception from it ends the fit
/// Throws  Error  when there are no data, or an error is outside its range; when no eclipse
///                is under way, or the Moon is below the horizon; "<file>: …" when none of the
///                photographs can be used
FitReport fitted_air(const FitRequest& request, const algebra::Progress& progress = {});

}  // namespace coppermoon::uses
