// SPDX-License-Identifier: MIT
#include "texture/images_ahead.h"

namespace coppermoon::texture {

// nothing to do: a program linked with OpenImageIO has already loaded it
ImagesAhead::ImagesAhead() = default;
ImagesAhead::~ImagesAhead() = default;

}  // namespace coppermoon::texture
