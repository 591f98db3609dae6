// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace coppermoon::almanac {

/// A moment: a two-part Julian date in TT (day at noon or midnight, plus the fraction), as ERFA keeps it.
struct Instant {
  double tt_day = 0, tt_fraction = 0;
};

/// The calendar that a date is given in. ISO 8601 is Gregorian throughout; historians give dates before
/// 15 October 1582 in the Julian calendar.
enum class Calendar { gregorian, julian };

/// Reads an instant from an ISO 8601 text, in UTC unless it ends in an offset.
///
/// Given   text      "2008-02-21T03:08:26Z" or "20080221T030826Z"; the Z, the seconds and their decimals may be left
///                   out, and so may the time of day (midnight). A space may stand for the T, an offset to the east for
///                   the Z ("+04:00", up to 18 h), and t and z for T and Z. 24:00 is the end of the day. Leap seconds
///                   are those of UTC, and can be given in any zone: "2016-12-31T15:59:60-08:00". Years are −1999 to
///                   3000, with a sign as in "-0584-05-22"
///         calendar  that the date is in: Thales' eclipse is "-0584-05-22" in the Gregorian calendar,
///                   "-0584-05-28" in the Julian one
/// Throws  Error  if the text is not such a date; the message quotes the text and gives an example
Instant instant_from_utc(std::string_view text, Calendar calendar = Calendar::gregorian);

/// ISO 8601 text in UTC, with seconds rounded to `decimals` decimals (0 to 9): "2008-02-21T03:26:05Z".
///
/// Throws  Error  if `decimals` is out of range
std::string utc_text(const Instant& instant, int decimals = 0);

/// TT − UT1 [s].
///
/// 1972 to the end of ERFA's table of leap seconds (2026 with ERFA 2.0.0): UTC is used as UT1, from which it
/// differs by less than 0.9 s. Before: polynomials of Espenak & Meeus (2006), with UTC read as UT1. After: the last
/// value plus 32.5 s times the square of the centuries since then, which is continuous and has the curvature of
/// tidal braking over the last 27 centuries.
///
/// Accuracy  1 s from 1972 to 2026; before, some 0.8 s times the square of the centuries from 1820:
///           4 minutes at year 0, 20 at −1999
/// Omits     UT1 − UTC, hence a step of 0.07 s in 1972
/// Source    Espenak & Meeus (2006), Five Millennium Canon of Solar Eclipses, NASA/TP-2006-214141;
///           32.5 s: Stephenson, Morrison & Hohenkerk (2016), Proc. R. Soc. A 472, 20160404
double delta_t_s(const Instant& instant);

/// Whether ΔT is a prediction at a moment, because ERFA's table of leap seconds ends before it.
bool delta_t_is_predicted(const Instant& instant);

/// A moment as a year with a fraction, in tropical years of 365.2422 days; 2000 is 1 January 2000, 0 h.
double year_of(const Instant& instant);

/// The moment `seconds` later (earlier if negative).
Instant later(const Instant& instant, double seconds);

/// `to` − `from` [s].
double seconds_between(const Instant& from, const Instant& to);

}  // namespace coppermoon::almanac
