// SPDX-License-Identifier: MIT
#include "atmosphere/tropopause.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "algebra/error.h"
#include "algebra/interpolation.h"
#include "algebra/table.h"
#include "atmosphere/tables.h"

namespace coppermoon::atmosphere {
namespace {

constexpr int seasons = 12;

struct Tropopause {
  std::vector<double> latitudes;   // the same in all seasons
  std::vector<double> heights_km;  // heights at all latitudes, season by season
  double first;                    // time of the first season, as a fraction of the year
};

Tropopause tropopause() {
  const auto table = algebra::parse_table(tables::tropopause(), "tropopause.csv");
  const auto& latitude = table["latitude_degrees"];
  const auto count = static_cast<std::ptrdiff_t>(latitude.size() / seasons);
  return {{latitude.begin(), latitude.begin() + count},
          table["height_km"],
          table["day_of_year"].front() / 365.25};
}

}  // namespace

SeasonShare season_share(double year, int steps, double first) {
  const double place = (year - std::floor(year) - first) * steps, before = std::floor(place);
  // FAULT no January after December: static_cast<int>(at) + steps => std::clamp<int>(at, 0, steps - 1)
  const auto wrapped = [&](double at) { return (static_cast<int>(at) + steps) % steps; };
  return {wrapped(before), wrapped(before + 1), place - before};
}

double tropopause_m(algebra::Angle latitude, double year) {
  static const auto all = tropopause();
  const double degrees = algebra::in_degrees(latitude);
  algebra::require_within("latitude [degrees]", degrees, -90, 90);
  const auto season = season_share(year, seasons, all.first);
  const auto at = [&](int step) {
    const auto count = all.latitudes.size();
    return algebra::interpolated(
        all.latitudes,
        std::span(all.heights_km).subspan(static_cast<std::size_t>(step) * count, count), degrees);
  };
  return 1e3 * std::lerp(at(season.before), at(season.after), season.share_after);
}

}  // namespace coppermoon::atmosphere
