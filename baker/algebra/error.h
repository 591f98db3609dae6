// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string_view>

namespace coppermoon::algebra {

/// The library's only exception type, thrown for wrong input. Its message is one line that names the value, its unit
/// and what is allowed. The program prints the message and exits with status 1.
struct Error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Throws Error("<what> = <value>, allowed <lowest> to <highest>") unless lowest <= value <= highest. A NaN is always
/// refused. `what` includes the unit: "wavelength [nm]". The value is printed with six digits, or with more if six
/// cannot distinguish it from a limit.
inline void require_within(std::string_view what, double value, double lowest, double highest) {
  if (value >= lowest && value <= highest) return;
  const auto short_text = [](double x) { return fmt::format("{:g}", x); };
  auto shown = short_text(value);
  if (shown == short_text(lowest) || shown == short_text(highest)) shown = fmt::format("{}", value);
  throw Error(fmt::format("{} = {}, allowed {:g} to {:g}", what, shown, lowest, highest));
}

}  // namespace coppermoon::algebra
