// SPDX-License-Identifier: MIT
#include "almanac/lunar_orientation.h"

#include <erfa.h>
#include <erfam.h>

#include <cmath>

#include "algebra/table.h"
#include "almanac/erfa_matrix.h"
#include "almanac/tables.h"

namespace coppermoon::almanac {
namespace {

struct Term {
  double argument, argument_per_day, right_ascension, declination, meridian;  // [degrees]
};

std::vector<Term> parsed_terms() {
  const auto table = algebra::parse_table(tables::lunar_orientation(), "lunar_orientation.csv");
  const auto &argument = table["argument_deg"], &rate = table["argument_deg_per_day"];
  const auto &right_ascension = table["right_ascension_deg"],
             &declination = table["declination_deg"], &meridian = table["meridian_deg"];
  std::vector<Term> terms;
  for (std::size_t i = 0; i < argument.size(); ++i)
    terms.push_back({argument[i], rate[i], right_ascension[i], declination[i], meridian[i]});
  return terms;
}

const std::vector<Term>& terms() {
  static const std::vector<Term> parsed = parsed_terms();
  return parsed;
}

struct Pole {
  double right_ascension_deg, declination_deg, meridian_deg;
};

Pole pole_at(double days) {
  const double t = days / ERFA_DJC;
  Pole pole{269.9949 + 0.0031 * t, 66.5392 + 0.0130 * t,
            38.3213 + 13.17635815 * days - 1.4e-12 * days * days};
  for (const Term& term : terms()) {
    const double e = (term.argument + term.argument_per_day * days) * ERFA_DD2R;
    pole.right_ascension_deg += term.right_ascension * std::sin(e);
    pole.declination_deg += term.declination * std::cos(e);
    pole.meridian_deg += term.meridian * std::sin(e);
  }
  return pole;
}

}  // namespace

glm::dmat3 selenographic_from_gcrs(const Instant& instant) {
  const Pole pole = pole_at((instant.tt_day - ERFA_DJ00) + instant.tt_fraction);
  double r[3][3];
  eraIr(r);
  eraRz((90 + pole.right_ascension_deg) * ERFA_DD2R, r);
  eraRx((90 - pole.declination_deg) * ERFA_DD2R, r);
  eraRz(std::fmod(pole.meridian_deg, 360) * ERFA_DD2R, r);
  return matrix_from_rows(r);
}

SelenographicPoint selenographic_point(const glm::dvec3& position) {
  return {algebra::radians(std::atan2(position.z, std::hypot(position.x, position.y))),
          algebra::radians(std::atan2(position.y, position.x))};
}

glm::dvec3 selenographic_direction(const SelenographicPoint& place) {
  const double latitude = algebra::in_radians(place.latitude);
  const double longitude = algebra::in_radians(place.longitude);
  return {std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
          std::sin(latitude)};
}

}  // namespace coppermoon::almanac
