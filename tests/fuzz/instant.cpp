// SPDX-License-Identifier: MIT
// A date: refused, or the same again when it is written and read.
#include "almanac/instant.h"

#include <cmath>
#include <string>

#include "fuzz/refused.h"

namespace {

using namespace coppermoon;

/// UTC and UT1 meet at 1972 with a step, which counts twice where writing rounds over it; the very
/// last moment may be rounded out of range.
void read(std::string_view text) {
  constexpr double step_s = 0.2;
  const auto instant = almanac::instant_from_utc(text);
  fuzz::require(std::isfinite(almanac::delta_t_s(instant)));
  for (const int decimals : {0, 3}) {
    const auto written = almanac::utc_text(instant, decimals);
    if (written.starts_with("3001") || written.starts_with("-2000")) continue;
    const auto again = almanac::instant_from_utc(written);
    const double rounding_s = 0.5 * std::pow(10, -decimals);
    fuzz::require(std::abs(almanac::seconds_between(instant, again)) < rounding_s + step_s);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::done([&] { read(fuzz::as_text(data, size)); });
  return 0;
}
