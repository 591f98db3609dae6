// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "request/parameter.h"
#include "uses/picture/baked_moon.h"
#include "uses/picture/development.h"

namespace coppermoon::uses {

/// Heading in the help text.
inline constexpr const char* camera_heading = "The camera and the picture";

/// The albedo map, its coding, and the photometry of the ground.
void describe_map(request::Parameters& is, MoonRequest& moon);

/// Width of the texture.
void describe_width(request::Parameters& is, MoonRequest& moon);

/// Response to colours: a sensor's matrix, or the filters through which a camera sees all light.
void describe_response(request::Parameters& is, std::optional<std::string>& response);

/// Whether the Moon is lit as if the Earth were not there.
void describe_unshadowed(request::Parameters& is, MoonRequest& moon);

/// The observer, and the air above the observer.
void describe_observer(request::Parameters& is, ViewRequest& view);

/// Stars and planets.
void describe_stars(request::Parameters& is, ViewRequest& view);

/// The observer, the air above the observer, and the frame: field, size, which way is up, stars and sky.
void describe(request::Parameters& is, ViewRequest& view);

/// The sky to add to a frame that has none.
void describe_sky_of_frame(request::Parameters& is, std::optional<double>& sky_cd_m2);

/// The camera: its optics and sensor.
void describe(request::Parameters& is, CameraRequest& camera);

/// Describes a frame's exposure and development: the first function leaves out the exposure time.
void describe_but_time(request::Parameters& is, Development& development);
void describe(request::Parameters& is, Development& development);

/// Whether a picture has a caption.
void describe_caption(request::Parameters& is, bool& caption);

/// Exposure time as text, for callers that accept more than one time in it.
void describe_time(request::Parameters& is, std::string& time);

/// A texture's colour space and number type.
void describe_numbers(request::Parameters& is, TextureContent& content);

/// A texture's colour space, number type, spectrum and passes.
void describe(request::Parameters& is, TextureContent& content);

/// Whether a texture or a frame has passes.
void describe_passes(request::Parameters& is, bool& passes);

/// Reads "auto", "follow", "composite" or a number of seconds.
///
/// Throws  Error  when the text is none of them
ExposureTime exposure_time_from(const std::string& text);

/// Reads an exposure time in seconds, such as "4", "0.03" or "1/30"; nothing for any other text.
std::optional<double> exposure_seconds(const std::string& text);

}  // namespace coppermoon::uses
