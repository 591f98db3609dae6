// SPDX-License-Identifier: MIT
// A flag's value that has a grammar of its own; the first byte chooses the flag.
#include <cmath>

#include "algebra/number.h"
#include "colour/working_space.h"
#include "fuzz/refused.h"
#include "uses/light/light_parameters.h"
#include "uses/picture/place_text.h"
#include "verbs/reports/one_line.h"

namespace {

using namespace coppermoon;

/// Dated air takes long to make, undated air does not: one text in 16 meets dated air.
void read_region(const std::string& text) {
  const std::string air_name = text.size() % 16 == 0 ? "standard" : "undated";
  const auto air = uses::atmosphere_of(
      {.atmosphere = air_name, .regions = {uses::region_from(text)}}, algebra::degrees(10), 2000);
  for (const auto& region : air.regions)
    fuzz::require(std::isfinite(algebra::in_radians(region.from)) &&
                  std::isfinite(algebra::in_radians(region.to)));
}

void read_shown(const std::string& text) {
  const auto line = verbs::one_line(text);
  fuzz::require(verbs::is_utf8(line) && line.find_first_of("\n\r\x1b\x7f") == std::string::npos);
}

void read_work(const std::string& text, std::uint8_t which) {
  uses::Effort effort;
  if (which == 2) return static_cast<void>(uses::everything_but(text));
  (which == 0 ? effort.tolerance : effort.budget) = text;
  uses::wish_of(effort);
}

void read(std::uint8_t which, const std::string& text) {
  switch (which % 8) {
    case 0:
      return read_region(text);
    case 1:
      return static_cast<void>(uses::observer_from(text));
    case 2:
      return static_cast<void>(algebra::numbers_in(text));
    case 3:
      return static_cast<void>(colour::working_space(text));
    case 4:
      return read_shown(text);
    default:
      return read_work(text, which % 8 - 5);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  fuzz::done([&] { read(data[0], std::string(fuzz::as_text(data + 1, size - 1))); });
  return 0;
}
