// SPDX-License-Identifier: MIT
#include "files/fingerprint.h"

#include <OpenImageIO/detail/farmhash.h>

namespace coppermoon::files {

std::uint64_t fingerprint(std::string_view bytes) {
  return OIIO::farmhash::inlined::Fingerprint64(bytes.data(), bytes.size());
}

}  // namespace coppermoon::files
