// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "request/parameter.h"
#include "uses/picture/baked_moon.h"
#include "uses/picture/development.h"

namespace coppermoon::uses {

/// Heading of help.
inline constexpr const char* camera_heading = "The camera and the picture";

/// The albedo map, its coding, and the photometry of the ground.
void describe_map(request::Parameters& is, MoonRequest& moon);

/// Width of the texture.
void describe_width(request::Parameters& is, MoonRequest& moon);

/// Response to colours: a sensor's matrix, or the filters of a camera that sees all light through them.
void describe_response(request::Parameters& is, std::optional<std::string>& response);

/// Whether the Moon is lit as if the Earth were away.
void describe_unshadowed(request::Parameters& is, MoonRequest& moon);

/// The observer, and the air above.
void describe_observer(request::Parameters& is, ViewRequest& view);

/// Stars and planets.
void describe_stars(request::Parameters& is, ViewRequest& view);

/// The observer, the air above, and the frame: its field, its size, which way is up, its stars and sky.
void describe(request::Parameters& is, ViewRequest& view);

/// The sky that is added to a frame without one.
void describe_sky_of_frame(request::Parameters& is, std::optional<double>& sky_cd_m2);

/// The camera: its optics and sensor.
void describe(request::Parameters& is, CameraRequest& camera);

/// Exposure and development of a frame, without its time, and with it.
void describe_but_time(request::Parameters& is, Development& development);
void describe(request::Parameters& is, Development& development);

/// Whether a picture has a caption.
void describe_caption(request::Parameters& is, bool& caption);

/// Exposure time as text, for whoever reads more than one time in it.
void describe_time(request::Parameters& is, std::string& time);

/// Space and type of numbers of a texture.
void describe_numbers(request::Parameters& is, TextureContent& content);

/// Space, type of numbers, spectrum and passes of a texture.
void describe(request::Parameters& is, TextureContent& content);

/// Whether a texture or a frame has passes.
void describe_passes(request::Parameters& is, bool& passes);

/// "auto", "follow", "composite" or seconds.
///
/// Throws  Error  when the text is none of them
ExposureTime exposure_time_from(const std::string& text);

/// Seconds of an exposure: "4", "0.03" or "1/30"; none when the text is no such number.
std::optional<double> exposure_seconds(const std::string& text);

}  // namespace coppermoon::uses
