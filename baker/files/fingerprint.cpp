// SPDX-License-Identifier: MIT
#include "files/fingerprint.h"

#include <xxhash.h>

namespace coppermoon::files {

std::uint64_t fingerprint(std::string_view bytes) {
  return XXH3_64bits(bytes.data(), bytes.size());
}

}  // namespace coppermoon::files
