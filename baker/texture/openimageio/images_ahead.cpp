// SPDX-License-Identifier: MIT
#include "texture/images_ahead.h"

namespace coppermoon::texture {

// Nothing to do: a program linked with OpenImageIO has loaded it already.
ImagesAhead::ImagesAhead() = default;
ImagesAhead::~ImagesAhead() = default;

}  // namespace coppermoon::texture
