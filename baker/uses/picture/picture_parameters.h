// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "request/parameter.h"
#include "uses/picture/baked_moon.h"
#include "uses/picture/development.h"

namespace coppermoon::uses {

/// Heading for the camera's parameters in the help text.
inline constexpr const char* camera_heading = "The camera and the picture";

/// Adds the parameters for the albedo map, its coding, and the photometry of the ground.
void describe_map(request::Parameters& is, MoonRequest& moon);

/// Adds the parameter for the width of the texture.
void describe_width(request::Parameters& is, MoonRequest& moon);

/// Adds the parameter for the response to colours: a sensor's matrix, or the spectral filters of a camera.
void describe_response(request::Parameters& is, std::optional<std::string>& response);

/// Adds the parameter for whether the Moon is lit as if the Earth were not there.
void describe_unshadowed(request::Parameters& is, MoonRequest& moon);

/// Adds the parameters for the observer and the air above the observer.
void describe_observer(request::Parameters& is, ViewRequest& view);

/// Adds the parameter for stars and planets.
void describe_stars(request::Parameters& is, ViewRequest& view);

/// Adds the parameters for the observer, the air, and the frame: field, size, which way is up, stars and sky.
void describe(request::Parameters& is, ViewRequest& view);

/// Adds the parameter for a sky to be added to a frame that has none.
void describe_sky_of_frame(request::Parameters& is, std::optional<double>& sky_cd_m2);

/// Adds the parameters for the camera's model, optics and sensor.
void describe(request::Parameters& is, CameraRequest& camera);

/// Adds the parameters for a frame's exposure and development; describe_but_time leaves out the exposure time.
void describe_but_time(request::Parameters& is, Development& development);
void describe(request::Parameters& is, Development& development);

/// Adds the parameter for whether a picture has a caption.
void describe_caption(request::Parameters& is, bool& caption);

/// Adds the parameter for the exposure time as a string, for callers that accept several times in it.
void describe_time(request::Parameters& is, std::string& time);

/// Adds the parameters for a texture's colour space and number type.
void describe_numbers(request::Parameters& is, TextureContent& content);

/// Adds the parameters for a texture's colour space, number type, spectrum and passes.
void describe(request::Parameters& is, TextureContent& content);

/// Adds the parameter for whether a texture or a frame has passes.
void describe_passes(request::Parameters& is, bool& passes);

/// Reads "auto", "follow", "composite" or a number of seconds.
///
/// Throws  Error  when the string is none of them
ExposureTime exposure_time_from(const std::string& text);

/// Reads an exposure time in seconds, such as "4", "0.03" or "1/30"; nothing for any other string.
std::optional<double> exposure_seconds(const std::string& text);

}  // namespace coppermoon::uses
