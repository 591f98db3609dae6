// SPDX-License-Identifier: MIT
// A list of magnitudes.
#include <cmath>

#include "fuzz/refused.h"
#include "fuzz/scratch_file.h"
#include "uses/fit/magnitudes.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace coppermoon;
  static const fuzz::ScratchFile file("magnitudes.csv");
  fuzz::done([&] {
    const auto all = uses::read_magnitudes(file.holding(fuzz::as_text(data, size)));
    fuzz::require(!all.empty());
    for (const auto& measured : all)
      fuzz::require(std::abs(measured.magnitude) <= 30 && measured.error > 0 && measured.error < 1);
  });
  return 0;
}
