// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "colour/bracket.h"
#include "colour/exposure.h"
#include "colour/working_space.h"
#include "texture/image.h"
#include "texture/read_image.h"

namespace coppermoon::uses {

/// Exposure settings in a photograph's header.
struct CameraSettings {
  std::optional<double> time_s{}, f_number{}, iso{};
  std::optional<std::string> gain{};  ///< GAIN of a FITS file, in the camera's unit
};

/// Exposure settings in a photograph's header. APEX values (EXIF 2.32, annex C) are used if there are no others. A time
/// that the camera rounded is replaced by the real one (colour::real_time_s). Times in FITS files are exact.
CameraSettings settings_of(const std::string& photo);

/// Maker and model of the camera that took a photograph, or INSTRUME in a FITS file; nothing if the header lacks them.
std::optional<std::string> camera_of(const std::string& photo);

/// Whether the user set the white balance, so that the camera does not change it from one photograph to the next.
bool white_balance_is_fixed(const std::string& photo);

/// Reading of a camera's clock.
struct HeaderClock {
  std::string local;                  ///< "2018-07-27T23:40:12", in the clock's own zone
  std::optional<std::string> offset;  ///< offset from UTC, such as "+03:00"; absent if unknown
  std::string unread{};               ///< the header's text for the offset, if it is not valid
  bool operator==(const HeaderClock&) const = default;
};

/// A clock's reading in seconds on a uniform time scale. If the clock's zone is unknown, UTC is assumed.
double seconds_at(const HeaderClock& clock);

/// Reads a header's date and zone, as EXIF defines them or as cameras write them.
///
/// A date is "2019:01:21 05:12:16". It may have - or / between its numbers, a T before the time, no seconds, or a zone
/// at its end. "24:12:16", from a clock that counts hours from 1 to 24, is in the first hour of that day. A zone is
/// "+03:00", "-5:00", "+0300", "Z", "UTC" or "GMT", up to 15 h 59 min. If the text for the zone is blanks and colons,
/// the zone is unknown. It is also unknown for any other text, which is kept in `unread`.
///
/// Returned  nothing if the date has only blanks or zeros, because the camera's clock was not set
/// Throws    Error  when the date has any other form
std::optional<HeaderClock> clock_in(const std::string& date, const std::string& offset = {});

/// When a photograph was taken, by the camera's clock. The date in a FITS file is in UTC, or is converted to UTC from
/// the scale that TIMESYS names. If TIMESYS is LOCAL, the zone is unknown. Coppermoon's pictures have UTC dates.
///
/// Throws  Error  with the photograph's name, when the header has no date or an unknown TIMESYS, or clock_in throws
/// Source  FITS Standard 4.0 (2018), 9.2.1
HeaderClock clock_of(const std::string& photo);

/// When a photograph was taken, in UTC, from the GPS data in its header; nothing if there are none. A receiver that has
/// lost the satellites may repeat an earlier time.
std::optional<HeaderClock> gps_clock_of(const std::string& photo);

/// The program that developed a camera's photograph into sRGB, if the header names one (in EXIF's Software, in XMP's
/// CreatorTool or history, or by applied settings of Camera Raw); otherwise nothing. The photograph then has the
/// program's tone curve, not the camera's.
std::optional<std::string> developer_of(const std::string& photo);

/// The program that developed, edited or merely saved a picture with integer samples, if the header names the program.
/// If it names none, but states another size than the picture's, "a program that the header does not name". The header
/// need not name a camera. Such samples cannot be converted to light, because their tone curve is unknown.
/// Nothing for raw files and for files that cannot be read.
std::optional<std::string> editor_of(const std::string& photo);

/// The coding of a photograph's numbers, as requested. If the request leaves the coding to the file, it is the camera's
/// tone curve, provided that the header names a camera and the numbers are coded as sRGB. The rule does not apply to
/// raw files, which are linear, or to photographs that a program has developed (developer_of).
texture::Coding coding_of(const std::string& photo, texture::Coding told);

/// Whether a photograph's numbers are coded as sRGB, and not by its camera's own tone curve.
bool is_display_coded(const std::string& photo, texture::Coding told);

/// Exposure settings in a photograph's header; nothing if one is missing.
std::optional<colour::Exposure> exif_of(const std::string& photo);

/// Number at which a photograph is clipped, both as stored in its file and as light on the scale of photo_light.
struct ClippedAt {
  double number = 1, light = 1;
  bool of_header = false;  ///< whether the number is from DATAMAX, not the greatest number found
};

/// Number at which a photograph in a FITS file is clipped: DATAMAX or, if that is absent, the greatest number in the
/// photograph, because sensors saturate at different numbers. Nothing for other files, or if no number exceeds 1.
std::optional<ClippedAt> clipped_at(const std::string& photo, const texture::Image& light);

/// Light of a photograph, read with texture::read_light. If the response is spectral (colour::camera_spectra), a raw
/// file's channels are converted to colours by the matrix for that response.
texture::Image photo_light(const std::string& photo, texture::Coding coding,
                           const std::optional<std::string>& response);

/// The light in a camera's raw file, scaled by the exposure in its header (colour::exposure_scale): channels
/// R, G, B, or X, Y, Z, in a working space [cd/m²]. Clipped pixels become white, at saturation.
///
/// Throws  Error  when the header lacks part of the exposure, or when photo_light does
texture::Image raw_light(const std::string& photo, colour::WorkingSpace space,
                         const std::optional<std::string>& response = {});

/// Attributes in a frame's or photograph's header that describe the scene: recipe, moment, meaning of the numbers.
texture::Attributes scene_attributes(const std::string& file);

/// When a photograph was taken, in seconds on a uniform time scale; nothing if its header has no date.
///
/// Throws  Error  with the photograph's name, when clock_in does
std::optional<double> taken_at_s(const std::string& photo);

/// Reads one photograph of a bracketed set that coppermoon made: its light, its valid pixels, and its weight.
///
/// Throws  Error  with the file's name, when its channels, numbers or header are not those of such a photograph
colour::Bracketed bracketed(const std::string& file);

}  // namespace coppermoon::uses
