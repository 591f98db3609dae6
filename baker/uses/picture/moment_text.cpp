// SPDX-License-Identifier: MIT
#include "uses/picture/moment_text.h"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "algebra/error.h"
#include "almanac/calendar.h"
#include "eclipse/moment.h"
#include "uses/picture/local_time.h"
#include "uses/picture/view.h"

namespace coppermoon::uses {
namespace {

using almanac::Instant;

constexpr auto usual = eclipse::ShadowConvention::danjon;

/// The time zone that a context sets; empty if it has neither a zone nor a place.
std::string zone_of(const MomentContext& context) {
  if (!context.zone.empty() && context.zone != "local") return context.zone;
  if (context.observer) return time_zone_of(*context.observer);
  if (context.zone.empty()) return "";
  throw algebra::Error("time zone = local: that of a place, and none is given");
}

Instant instant_in(const std::string& text, const MomentContext& context) {
  if (context.zone.empty() || !eclipse::is_clock_time(text))
    return almanac::instant_from_utc(text, context.calendar);
  return instant_of_local(text, zone_of(context), context.calendar);
}

/// The last moonrise before P4 and the first moonset after P1, if they occur within a lunar day. Each is moved by up to
/// a second, so that the Moon is still up when the time is rounded to the second.
std::vector<std::pair<std::string, Instant>> rise_and_set(const eclipse::Eclipse& eclipse,
                                                          const almanac::Observer& place) {
  constexpr double lunar_day_s = 25 * 3600.;
  const auto &first = *eclipse.contacts.P1, &last = *eclipse.contacts.P4;
  std::vector<std::pair<std::string, Instant>> found;
  for (const auto& [when, rises] :
       horizon_crossings(place, almanac::later(last, -lunar_day_s), last))
    if (rises) found = {{"moonrise", almanac::later(when, 0.55)}};
  for (const auto& [when, rises] :
       horizon_crossings(place, first, almanac::later(first, lunar_day_s))) {
    if (rises) continue;
    found.emplace_back("moonset", almanac::later(when, -0.5));
    break;
  }
  return found;
}

Instant to_the_second(const Instant& when) {
  return almanac::instant_from_utc(almanac::utc_text(when));
}

}  // namespace

Instant moment_in(const std::string& text, const MomentContext& context) {
  if (!context.zone.empty()) local_time({2451545, 0}, zone_of(context));  // refuses an unknown zone
  if (eclipse::is_day(text)) return to_the_second(eclipse_on(text, context).greatest);
  if (!eclipse::is_from_contact(text)) return instant_in(text, context);
  const auto space = text.find(' ');
  return to_the_second(
      moment_from(text.substr(space + 1), eclipse_on(text.substr(0, space), context), context));
}

Instant moment_from(const std::string& text, const eclipse::Eclipse& eclipse,
                    const MomentContext& context) {
  if (eclipse::begins_with_digit(text)) return instant_in(text, context);
  if (!eclipse::is_from_horizon(text)) return eclipse::moment_from(text, eclipse);
  if (!context.observer)
    throw algebra::Error("moonrise and moonset are those of a place, and none is given");
  return eclipse::moment_from(text, eclipse, rise_and_set(eclipse, *context.observer));
}

std::optional<eclipse::Eclipse> eclipse_of_day(const std::string& day,
                                               const MomentContext& context) {
  constexpr double day_and_night_s = 36 * 3600.;
  auto found = eclipse::eclipse_of_day(almanac::instant_from_utc(day, context.calendar), usual);
  if (const auto zone = found ? "" : zone_of(context); !zone.empty()) {
    const auto midnight = instant_of_local(day, zone, context.calendar);
    const auto all =
        eclipse::eclipses_between(midnight, almanac::later(midnight, day_and_night_s), usual);
    if (!all.empty()) found = all.front();
  }
  if (found) found->calendar = context.calendar;
  return found;
}

eclipse::Eclipse eclipse_on(const std::string& day, const MomentContext& context) {
  if (auto found = eclipse_of_day(day, context)) return *found;
  const auto noon = almanac::later(almanac::instant_from_utc(day, context.calendar), 43200);
  const auto nearest = eclipse::nearest_eclipse(noon, usual);
  const auto zone = zone_of(context);
  throw algebra::Error(
      fmt::format("{}: no lunar eclipse is greatest on that day ({}); the nearest is at {}. Any "
                  "other moment needs a time of day, as {}T21:30Z",
                  day, zone.empty() ? "UTC" : "UTC or " + zone,
                  almanac::utc_text(nearest.greatest, context.calendar), day));
}

}  // namespace coppermoon::uses
