// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

namespace coppermoon::uses {

/// One of N equal parts of work, "K/N": K from 1 to N.
struct Shard {
  std::size_t part = 1, parts = 1;
};

/// Throws  Error  when the text is no such part, N at most 100000
Shard shard_from(const std::string& text);

}  // namespace coppermoon::uses
