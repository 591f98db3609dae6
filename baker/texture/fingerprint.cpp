// SPDX-License-Identifier: MIT
#include "texture/fingerprint.h"

#include <OpenImageIO/hash.h>

namespace coppermoon::texture {

std::uint64_t fingerprint(std::string_view bytes) {
  return OIIO::farmhash::Fingerprint64(bytes.data(), bytes.size());
}

}  // namespace coppermoon::texture
