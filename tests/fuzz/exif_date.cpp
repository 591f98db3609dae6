// SPDX-License-Identifier: MIT
// The date of a photograph's header.
#include <cmath>
#include <string>

#include "fuzz/refused.h"
#include "uses/picture/photo_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace coppermoon;
  fuzz::done([&] {
    const auto seconds = uses::seconds_of_date(std::string(fuzz::as_text(data, size)));
    fuzz::require(!seconds || std::isfinite(*seconds));
  });
  return 0;
}
