// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace coppermoon::almanac {

/// A moment as a Julian date in TT. As in ERFA, the date has two parts: a day, at noon or midnight, and a fraction.
struct Instant {
  double tt_day = 0, tt_fraction = 0;
};

/// The calendar that a date is given in. ISO 8601 uses only the Gregorian calendar; historians give dates before 15
/// October 1582 in the Julian calendar.
enum class Calendar { gregorian, julian };

/// Reads an instant from an ISO 8601 text, in UTC unless it ends in an offset.
///
/// Given   text      such as "2008-02-21T03:08:26Z" or "20080221T030826Z". The Z, the seconds and their decimals may be
///                   left out, and so may the time of day, which is then midnight. T and Z may be lower-case. A space
///                   may replace the T. An offset from UTC, positive to the east and up to 18 h, may replace the Z:
///                   "+04:00". 24:00 is the end of the day. Leap seconds can be given in any zone:
///                   "2016-12-31T15:59:60-08:00". Years are −1999 to 3000, with a sign as in "-0584-05-22"
///         calendar  calendar of the date: Thales' eclipse is "-0584-05-22" in the Gregorian calendar,
///                   "-0584-05-28" in the Julian one
/// Throws  Error  if the text is not a valid date; the message quotes the text and gives an example
Instant instant_from_utc(std::string_view text, Calendar calendar = Calendar::gregorian);

/// A moment as ISO 8601 text in UTC, such as "2008-02-21T03:26:05Z". Seconds are rounded to `decimals` places.
///
/// Throws  Error  if `decimals` is not 0 to 9
std::string utc_text(const Instant& instant, int decimals = 0);

/// ΔT, which is TT − UT1 [s].
///
/// From 1972 to the end of ERFA's table of leap seconds (2026 with ERFA 2.0.0), UT1 is assumed to equal UTC; they
/// differ by less than 0.9 s. Before 1972, ΔT comes from the polynomials of Espenak & Meeus (2006), and times in UTC
/// are read as UT1. After the table, ΔT is its last value plus 32.5 s times the square of the centuries since then.
/// This is continuous, and has the curvature due to tidal braking over the last 27 centuries.
///
/// Accuracy  1 s from 1972 to 2026; before that, some 0.8 s times the square of the centuries from 1820:
///           4 minutes in year 0, 20 minutes in −1999
/// Omits     UT1 − UTC, which causes a step of 0.07 s in 1972
/// Source    Espenak & Meeus (2006), Five Millennium Canon of Solar Eclipses, NASA/TP-2006-214141;
///           for 32.5 s, Stephenson, Morrison & Hohenkerk (2016), Proc. R. Soc. A 472, 20160404
double delta_t_s(const Instant& instant);

/// Whether ΔT at a moment is a prediction because ERFA's table of leap seconds has ended by then.
bool delta_t_is_predicted(const Instant& instant);

/// A moment as a decimal year, counted in tropical years of 365.2422 days; 2000.0 is 1 January 2000, 0 h.
double year_of(const Instant& instant);

/// The moment that is `seconds` later than an instant, or earlier if `seconds` is negative.
Instant later(const Instant& instant, double seconds);

/// Time from one moment to another [s]; negative if `to` is earlier than `from`.
double seconds_between(const Instant& from, const Instant& to);

}  // namespace coppermoon::almanac
