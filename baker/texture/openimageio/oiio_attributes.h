// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "texture/image.h"
#include "texture/openimageio/oiio.h"

namespace coppermoon::texture {

/// OpenImageIO's name for an attribute: it knows `capDate` as DateTime, `expTime` as ExposureTime,
/// …
std::string oiio_name(std::string_view name);

/// Puts an attribute into a specification such that the file gets it under its standard name and
/// type.
///
/// Throws  Error  where OpenImageIO would drop or change it: no name, a name kept for the file's
///                own layout, a value of the wrong type for a standard name
void set_attribute(OIIO::ImageSpec& spec, const std::string& name, const Attribute& value);

}  // namespace coppermoon::texture
