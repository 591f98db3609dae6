// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "almanac/instant.h"
#include "colour/working_space.h"
#include "texture/image.h"

namespace coppermoon::uses {

/// Version of coppermoon, such as "0.2.0".
std::string_view version();

/// A moment in UTC, in the format of OpenEXR's capDate attribute: "2008:02:21 03:08:26".
std::string capture_date(const almanac::Instant& instant);

/// Header attributes for a scene-linear image in cd/m²: colour space, moment and program version.
texture::Attributes scene_linear_header(colour::WorkingSpace space, const almanac::Instant& when);

/// Replaces the colour space in the header of a scene-linear image.
void say_space(texture::Attributes& header, colour::WorkingSpace space);

}  // namespace coppermoon::uses
