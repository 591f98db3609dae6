// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "texture/image.h"
#include "texture/openimageio/oiio.h"

namespace coppermoon::texture {

/// OpenImageIO's name for a standard attribute, such as DateTime for `capDate` or ExposureTime for `expTime`.
std::string oiio_name(std::string_view name);

/// Adds an attribute to a specification, so that the file will have it under its standard name and type.
///
/// Throws  Error  if OpenImageIO would drop or change the attribute: an empty name, a name reserved for the file's own
///                layout, or a value of the wrong type for a standard name
void set_attribute(OIIO::ImageSpec& spec, const std::string& name, const Attribute& value);

}  // namespace coppermoon::texture
