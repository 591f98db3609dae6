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
  std::optional<double> time_s = {}, iso = {}, f_number = {};  ///< read from the header if absent
};

/// Data to be fitted, and everything that the fit takes as known.
struct FitRequest {
  std::optional<Unknowns> unknowns = {};  ///< what to fit; if absent, usual_unknowns decides
  std::vector<EclipsePhotograph> photographs = {};
  std::vector<MeasuredMagnitude> magnitudes = {};
  /// Supplies the air (apart from the unknowns), limb darkening, scattered light, starlight, map, photometry and
  /// response. Its other members are ignored.
  MoonRequest moon = {};
  ViewRequest view = {};  ///< the photographer's place, and the air above it
  /// One of colour::camera_names(), for the luminance that saturates the sensor. If empty, ISO 12232 gives it.
  std::string camera = {};
  /// Standard error of the logarithm of exposure, which all photographs of a night share, 0.001 to 10. If absent, it is
  /// 0.1, or 10 if the exposure is free, as for photographs with a camera's own tone curve.
  std::optional<double> exposure_error = {};
  /// Standard error of the logarithm of one exposure relative to the night's others, 0.001 to 10. If absent, it is
  /// 0.03, or 0.1 for photographs with a camera's own tone curve.
  std::optional<double> shutter_error = {};
  /// Standard error of the logarithms of red / green and blue / green, 0.001 to 10. If absent, it is 0.03. For
  /// photographs with a camera's own tone curve it is 0.06 if the header has the white-balance gains as shot and the
  /// camera's filters are known, 0.2 if only the gains are known, else 0.3.
  std::optional<double> white_balance_error = {};
  /// Relative error, 0 to 1, of the light from each 30 degrees of the Earth's limb. It is due to unknown weather, and
  /// applies to typical air. If absent, it is 0.2 for raw files and for photographs whose tone curve is fitted, else 0.
  std::optional<double> weather_error = {};
  /// Standard error of each camera's clock [s], 0 (exact) to 3600. If it exceeds 300, corrections of up to three times
  /// this error are tried.
  double clock_error_s = 0;
  bool response_assumed = false;  ///< whether `moon.response` stands in for an unknown response
  bool half_hours_free = false;   ///< whether times may be off by any number of half hours
  /// Largest clock correction to try [s], even if clock_error_s is smaller. It can be found only from partial phases.
  double clock_search_s = 0;
};

/// How a photograph was read, or why it was left out.
struct ReadPhotograph {
  colour::Registration registration{};
  bool exposure_known = false;   ///< if false, the fit leaves the exposure free
  std::size_t measurements = 0;  ///< number of measurements, one for each bin and channel used
  bool curved = false;           ///< whether the camera's own tone curve was fitted
  std::optional<ClippedAt> clipped_at{};  ///< pixel value that counts as clipped, if not 1
  std::string left_out{};  ///< one-line reason why it was left out; empty if it was used
  std::string file{};
  std::optional<std::string> instant{};  ///< time of the photograph in UTC; absent if unknown
};

/// An error's message without the file name at its beginning.
std::string reason_without_name(const std::string& file, const algebra::Error& error);

/// Reason to process a night again with the results of the fit.
enum class Again {
  no,            ///< no reason, because nothing would change
  in_its_air,    ///< photographs were registered with the assumed air, not with the fitted air
  by_its_curve,  ///< photographs were read with a tone curve that has since changed
  nearby         ///< the fitted air is not well within the range for which light was computed
};

/// What the fit found about one night's camera and photographs.
struct FittedNight {
  std::vector<std::size_t> photographs;  ///< indices of the night's photographs in the request
  std::optional<ClockError> clock;       ///< clock correction; absent if clock_error_s is 0
  /// Camera response: the one requested, else the camera's own if it is known, else the default for such files.
  std::optional<std::string> response;
  std::optional<colour::ToneCurve> curve;
  std::vector<MeasuredLight> light;  ///< measured light, by distance from the shadow's axis
  std::vector<Misfit> misfits;       ///< misfit by channel and index of photograph in the request
  std::vector<Again> turns;          ///< why the night was processed again: a reason for each time
  std::vector<std::string> files;    ///< file names of the night's photographs
};

/// Result of a fit: the air, and what was found about the photographs and cameras.
struct FitReport {
  AirFit fit;
  std::vector<ReadPhotograph> photographs;  ///< photographs in the order of the request
  std::vector<FittedNight> nights;
};

/// The unknowns to fit: those of the request or, if it names none, the usual ones for its air.
Unknowns unknowns_of(const FitRequest& request);

/// Fits aerosol, cloud and ozone to photographs and magnitudes of eclipses, jointly:
///
///     FitRequest request{.photographs = {{"a.jpg", almanac::instant_from_utc("2018-07-27T20:40")}}};
///     request.view.observer = almanac::Observer{algebra::degrees(36), algebra::degrees(38), {}};
///     const auto found = fitted_air(request);
///     if (explains(found.fit)) use(found.fit.posterior.estimates);
///
/// If no response is given, light is computed for the filters of the camera that the file's header names, if they are
/// known. For JPEGs from other cameras, the filters of a Canon EOS 600D are assumed, because cameras differ less from
/// each other than from the CIE observer. The differences between cameras then count as an error. Photographs from one
/// camera and eclipse share a clock, a tone curve, and an error of exposure. A photograph that cannot be used is left
/// out as long as other data remain.
///
/// Given   progress  called with the fraction done; may throw to cancel the fit
/// Throws  Error  when there are no data, a standard error is out of range, no eclipse is under way, or the Moon is
///                below the horizon; "<file>: …" when none of the photographs can be used
FitReport fitted_air(const FitRequest& request, const algebra::Progress& progress = {});

}  // namespace coppermoon::uses
