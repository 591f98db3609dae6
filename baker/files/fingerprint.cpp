// SPDX-License-Identifier: MIT
#include "files/fingerprint.h"

#include <xxhash.h>

#include <memory>

namespace coppermoon::files {

std::uint64_t fingerprint(std::string_view bytes) {
  return XXH3_64bits(bytes.data(), bytes.size());
}

std::uint64_t fingerprint_of_pieces(const std::function<std::string()>& next) {
  const std::unique_ptr<XXH3_state_t, XXH_errorcode (*)(XXH3_state_t*)> state(XXH3_createState(),
                                                                              &XXH3_freeState);
  XXH3_64bits_reset(state.get());
  for (std::string piece; !(piece = next()).empty();)
    XXH3_64bits_update(state.get(), piece.data(), piece.size());
  return XXH3_64bits_digest(state.get());
}

}  // namespace coppermoon::files
