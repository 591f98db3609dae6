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
  std::optional<std::string> gain{};  ///< FITS's GAIN, in whatever unit its camera has
};

/// Settings by the header, by APEX values where it has no others (EXIF 2.32, annex C), of several ISO speeds the first. Of a
/// camera those that it really uses, as colour::real_time_s has them; those of FITS are exact.
CameraSettings settings_of(const std::string& photo);

/// Maker and model of the camera that took it, in one line, or FITS's INSTRUME; nothing when its header does not say.
std::optional<std::string> camera_of(const std::string& photo);

/// Whether the camera's colours were set by hand, and not by itself for each photograph.
bool white_balance_is_fixed(const std::string& photo);

/// Reading of a camera's clock.
struct HeaderClock {
  std::string local;                  ///< "2018-07-27T23:40:12", by the clock's own zone
  std::optional<std::string> offset;  ///< of that zone, as "+03:00", where the header has it
  std::string unread{};               ///< the header's offset, where it is none
  bool operator==(const HeaderClock&) const = default;
};

/// Reads a header's date and zone, as EXIF has them or as cameras write them.
///
/// A date is "2019:01:21 05:12:16". It may have - or / between its numbers, a T before the time, no seconds, a zone behind
/// it. "24:12:16" of a clock that counts hours from 1 to 24 is the first hour of that day. A zone is "+03:00", "-5:00",
/// "+0300", "Z", "UTC" or "GMT", up to 15 h 59 min; blanks and colons mean that it is unknown, and so does anything else,
/// which is kept as unread.
///
/// Returned  nothing for the date of a camera whose clock was not set: blanks or zeros
/// Throws    Error  when the date is anything else
std::optional<HeaderClock> clock_in(const std::string& date, const std::string& offset = {});

/// Time of exposure by the camera's clock. That of FITS is UTC, or in the time scale of TIMESYS, from which it is converted; of
/// LOCAL the zone is unknown.
///
/// Throws  Error  with the photograph's name: when its header does not say, for another TIMESYS, or as clock_in
/// Source  FITS Standard 4.0 (2018), 9.2.1
HeaderClock clock_of(const std::string& photo);

/// Program that developed a photograph of a camera, as the header's Software names it, where the numbers are coded as
/// sRGB: they are that program's, not the camera's own. Nothing for all others.
std::optional<std::string> developer_of(const std::string& photo);

/// Coding of a photograph's numbers: as asked for; where the file is to say, the camera's tone curve when they are
/// coded as sRGB and the header names a camera, but never for a raw file, which is linear, nor where developer_of names a
/// program.
texture::Coding coding_of(const std::string& photo, texture::Coding told);

/// Exposure settings of a photograph's header; nothing when one is missing.
std::optional<colour::Exposure> exif_of(const std::string& photo);

/// Number at which a photograph is clipped, as in its file and in the scale of photo_light.
struct ClippedAt {
  double number = 1, light = 1;
  bool of_header = false;  ///< FITS's DATAMAX; else the photograph's greatest
};

/// Number at which a photograph in a FITS file is clipped: DATAMAX, else the greatest of its light, where that is beyond 1:
/// sensors count to whatever they count to. Nothing of other files, and of light that ends at 1.
std::optional<ClippedAt> clipped_at(const std::string& photo, const texture::Image& light);

/// Light of a photograph, as texture::read_light; a raw file's channels become colours by the matrix of a response,
/// where that is spectral (colour::camera_spectra).
texture::Image photo_light(const std::string& photo, texture::Coding coding,
                           const std::optional<std::string>& response);

/// The light of a camera's raw file by the exposure in its header, as colour::exposure_scale has it: channels
/// R, G, B, or X, Y, Z, of a working space [cd/m²]. What is clipped is white at saturation.
///
/// Throws  Error  when its header does not say all of the exposure; as photo_light
texture::Image raw_light(const std::string& photo, colour::WorkingSpace space,
                         const std::optional<std::string>& response = {});

/// Attributes of a frame or photograph that describe the scene: recipe, moment, meaning of the numbers.
texture::Attributes scene_attributes(const std::string& file);

/// Time of a photograph in seconds on a uniform scale; nothing when its header does not say.
///
/// Throws  Error  with the photograph's name, as clock_in
std::optional<double> taken_at_s(const std::string& photo);

/// Photograph of a bracketed set made by coppermoon: its light, its valid pixels, and its weight.
///
/// Throws  Error  with the file's name: for channels, numbers or a header that no such photograph has
colour::Bracketed bracketed(const std::string& file);

}  // namespace coppermoon::uses
