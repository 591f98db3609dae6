// SPDX-License-Identifier: MIT
#include <erfa.h>
#include <erfam.h>

#include <cmath>
#include <span>

#include "almanac/instant.h"

namespace coppermoon::almanac {
namespace {

constexpr double first_leap_second_day = 2441317.5;  // 1972-01-01
constexpr double seconds_per_day = 86400;

/// One of Espenak & Meeus's polynomials in (year − origin) / unit, valid until `end_year`.
struct Piece {
  double end_year, origin, unit;
  double coefficients[8];
};

constexpr Piece pieces[] = {
    {-500, 1820, 100, {-20, 0, 32}},
    {500, 0, 100, {10583.6, -1014.41, 33.78311, -5.952053, -0.1798452, 0.022174192, 0.0090316521}},
    {1600,
     1000,
     100,
     {1574.2, -556.01, 71.23472, 0.319781, -0.8503463, -0.005050998, 0.0083572073}},
    {1700, 1600, 1, {120, -0.9808, -0.01532, 1 / 7129.0}},
    {1800, 1700, 1, {8.83, 0.1603, -0.0059285, 0.00013336, -1 / 1174000.0}},
    {1860,
     1800,
     1,
     {13.72, -0.332447, 0.0068612, 0.0041116, -0.00037436, 0.0000121272, -0.0000001699,
      0.000000000875}},
    {1900, 1860, 1, {7.62, 0.5737, -0.251754, 0.01680668, -0.0004473624, 1 / 233174.0}},
    {1920, 1900, 1, {-2.79, 1.494119, -0.0598939, 0.0061966, -0.000197}},
    {1941, 1920, 1, {21.20, 0.84493, -0.076100, 0.0020936}},
    {1961, 1950, 1, {29.07, 0.407, -1 / 233.0, 1 / 2547.0}},
    {1986, 1975, 1, {45.45, 1.067, -1 / 260.0, -1 / 718.0}},
};

double polynomial(std::span<const double> coefficients, double x) {
  double sum = 0;
  for (std::size_t i = coefficients.size(); i-- > 0;) sum = sum * x + coefficients[i];
  return sum;
}

/// ΔT from the polynomials of Espenak & Meeus (2006). A further term changes the Moon's assumed secular acceleration
/// from −26″/cy² to −25.858″/cy².
double espenak_meeus_2006_s(double year) {
  const Piece* piece = pieces;
  while (year >= piece->end_year) ++piece;
  const double acceleration = year < 1955 ? -0.000012932 * (year - 1955) * (year - 1955) : 0;
  return polynomial(piece->coefficients, (year - piece->origin) / piece->unit) + acceleration;
}

double julian_year(double day) { return 2000 + (day - 2451544.5) / 365.25; }

struct LeapSeconds {
  double tai_minus_utc_s;
  bool tabulated;
};

LeapSeconds leap_seconds(int year) {
  LeapSeconds leap{};
  leap.tabulated = eraDat(year, 1, 1, 0, &leap.tai_minus_utc_s) == 0;
  return leap;
}

/// Julian day on which ERFA's table of leap seconds ends: 1 January of the first year that ERFA calls dubious.
double last_leap_second_day() {
  static const double end = [] {
    int year = 1972;
    while (leap_seconds(year).tabulated) ++year;
    double zero = 0, mjd = 0;
    eraCal2jd(year, 1, 1, &zero, &mjd);
    return zero + mjd;
  }();
  return end;
}

double predicted_s(double day) {
  const double centuries = (day - last_leap_second_day()) / 36525;
  return leap_seconds(2100).tai_minus_utc_s + ERFA_TTMTAI + 32.5 * centuries * centuries;
}

double tabulated_s(const Instant& instant) {
  double tai1 = 0, tai2 = 0, utc1 = 0, utc2 = 0;
  eraTttai(instant.tt_day, instant.tt_fraction, &tai1, &tai2);
  eraTaiutc(tai1, tai2, &utc1, &utc2);
  int year = 0, month = 0, day = 0;
  double fraction = 0, tai_minus_utc_s = 0;
  eraJd2cal(utc1, utc2, &year, &month, &day, &fraction);
  eraDat(year, month, day, fraction, &tai_minus_utc_s);
  return tai_minus_utc_s + ERFA_TTMTAI;
}

}  // namespace

double delta_t_s(const Instant& instant) {
  const double tt = instant.tt_day + instant.tt_fraction;
  if (delta_t_is_predicted(instant)) return predicted_s(tt);
  const double first_tt = first_leap_second_day + 42.184 / seconds_per_day;
  if (tt >= first_tt) return tabulated_s(instant);
  double delta = 0;  // the polynomials need UT, so iterate until UT is known to 0.01 s
  for (int round = 0; round < 3; ++round)
    delta = espenak_meeus_2006_s(julian_year(tt - delta / seconds_per_day));
  return delta;
}

bool delta_t_is_predicted(const Instant& instant) {
  const double end = last_leap_second_day();
  const double delta_s = leap_seconds(2100).tai_minus_utc_s + ERFA_TTMTAI;
  return instant.tt_day - end + instant.tt_fraction >= delta_s / seconds_per_day;
}

}  // namespace coppermoon::almanac
