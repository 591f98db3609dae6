// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "almanac/instant.h"
#include "colour/working_space.h"
#include "texture/image.h"

namespace coppermoon::uses {

/// The version of coppermoon, as "0.2.0".
std::string_view version();

/// A moment as OpenEXR's capDate writes it: "2008:02:21 03:08:26", UTC.
std::string capture_date(const almanac::Instant& instant);

/// What the header of a scene-linear image in cd/m² says: its space, its moment, and who made it.
texture::Attributes scene_linear_header(colour::WorkingSpace space, const almanac::Instant& when);

/// Has a header of a scene-linear image say another space.
void say_space(texture::Attributes& header, colour::WorkingSpace space);

}  // namespace coppermoon::uses
