// SPDX-License-Identifier: MIT
// The date of a photograph's header.
#include <string>
#include <string_view>

#include "fuzz/refused.h"
#include "uses/picture/photo_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace coppermoon;
  fuzz::done([&] {
    const auto clock = uses::clock_in(std::string(fuzz::as_text(data, size)));
    fuzz::require(!clock || clock->local.size() == std::string_view("2018-07-27T23:40:12").size());
  });
  return 0;
}
