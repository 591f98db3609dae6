// SPDX-License-Identifier: MIT
// A flag's value that has a grammar of its own; the first byte chooses the flag.
#include <cmath>

#include "colour/working_space.h"
#include "fuzz/refused.h"
#include "verbs/flags/air_options.h"
#include "verbs/flags/number_list.h"
#include "verbs/reports/one_line.h"
#include "verbs/flags/plan_options.h"
#include "verbs/flags/view_options.h"

namespace {

using namespace coppermoon;

void read_region(const std::string& text) {
  verbs::RegionReader reader;
  const auto air = uses::atmosphere_of({.regions = {reader.read(text)}}, algebra::degrees(10), 2000);
  for (const auto& region : air.regions)
    fuzz::require(std::isfinite(algebra::in_radians(region.from)) &&
                  std::isfinite(algebra::in_radians(region.to)));
}

void read_shown(const std::string& text) {
  const auto line = verbs::one_line(text);
  fuzz::require(verbs::is_utf8(line) && line.find_first_of("\n\r\x1b\x7f") == std::string::npos);
}

void read_work(const std::string& text, std::uint8_t which) {
  verbs::PlanOptions options;
  (which == 0 ? options.tolerance : which == 1 ? options.budget : options.leave_out) = text;
  verbs::wish_of(options);
  verbs::by_hand(options);
}

void read(std::uint8_t which, const std::string& text) {
  switch (which % 8) {
    case 0:
      return read_region(text);
    case 1:
      return static_cast<void>(verbs::observer_from(text));
    case 2:
      return static_cast<void>(verbs::number_list(text));
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
