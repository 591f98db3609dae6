// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

namespace coppermoon::uses {

/// Part K of N equal parts of the work, written "K/N", with K from 1 to N.
struct Shard {
  std::size_t part = 1, parts = 1;
};

/// Throws  Error  when the text is not of the form "K/N", or N is above 100000
Shard shard_from(const std::string& text);

}  // namespace coppermoon::uses
