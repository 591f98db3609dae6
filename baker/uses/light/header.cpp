// SPDX-License-Identifier: MIT
#include "uses/light/header.h"

#include <algorithm>
#include <vector>

#include "almanac/calendar.h"

namespace coppermoon::uses {

std::string_view version() { return COPPERMOON_VERSION; }

std::string capture_date(const almanac::Instant& instant) {
  std::string date = almanac::date_text(instant);
  std::replace(date.begin() + 1, date.end(), '-', ':');
  return date + " " + almanac::time_of_day_text(instant);
}

texture::Attributes scene_linear_header(colour::WorkingSpace space, const almanac::Instant& when) {
  texture::Attributes header{{"whiteLuminance", 1.F},
                             {"capDate", capture_date(when)},
                             {"utcOffset", 0.F},
                             {"coppermoon:version", std::string(version())},
                             {"coppermoon:unit", std::string("cd/m^2")}};
  say_space(header, space);
  return header;
}

void say_space(texture::Attributes& header, colour::WorkingSpace space) {
  const auto xy = colour::chromaticities(space);
  header["colorInteropID"] = std::string(colour::interop_id(space));
  header["chromaticities"] = std::vector<float>(xy.begin(), xy.end());
  header["coppermoon:colour_space"] = std::string(colour::name(space));
}

}  // namespace coppermoon::uses
