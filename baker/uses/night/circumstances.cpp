// SPDX-License-Identifier: MIT
#include "uses/night/circumstances.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <numbers>
#include <utility>

#include "uses/picture/view.h"

namespace coppermoon::uses {
namespace {

using almanac::Instant;

/// Position angle of the point on the limb that is nearest to the shadow's axis or, for U2 and U3, farthest from it.
algebra::Angle contact_angle(const std::string& name, const almanac::SkyState& sky) {
  const auto north = glm::row(sky.equator_from_gcrs, 2);
  const double inside = name == "U2" || name == "U3" ? std::numbers::pi : 0,
               turn = 2 * std::numbers::pi,
               angle = inside +
                       algebra::in_radians(almanac::position_angle(sky.moon_m, -sky.sun_m, north));
  return algebra::radians(angle - turn * std::floor(angle / turn));
}

/// Moonrises and moonsets that happen within the given number of hours before or after greatest eclipse.
std::vector<NightMoment> rises_and_sets(const Circumstances& night, double hours) {
  std::vector<NightMoment> all;
  const auto& greatest = night.eclipse.greatest;
  for (const auto& [when, rises] :
       horizon_crossings(night.place, almanac::later(greatest, -hours * 3600),
                         almanac::later(greatest, hours * 3600))) {
    all.push_back(moment_at(night.place, rises ? "moonrise" : "moonset", almanac::sky_at(when)));
    all.back().up = true;
  }
  return all;
}

/// Text that gives a time relative to the nearest contact, such as "12 min after U1".
std::string from_contact(const Circumstances& night, const Instant& when) {
  const auto contacts = contacts_of(night.eclipse);
  const auto away = [&](const auto& contact) {
    return std::abs(almanac::seconds_between(contact.second, when));
  };
  const auto nearest = *std::ranges::min_element(contacts, {}, away);
  const double minutes = almanac::seconds_between(nearest.second, when) / 60;
  const auto& name = nearest.first == "greatest" ? std::string("greatest eclipse") : nearest.first;
  if (std::abs(minutes) < 1) return "at " + name;
  return fmt::format("{:.0f} min {} {}", std::abs(minutes), minutes > 0 ? "after" : "before", name);
}

/// Whether the Moon is seen during all of an interval, and whether it is seen during some of it.
struct Share {
  bool all = false, some = false;
};

Share seen_between(const Circumstances& night, const Instant& from, const Instant& to) {
  Share share;
  for (const auto& span : night.seen) {
    share.all |= holds(span, from) && holds(span, to);
    share.some |= almanac::seconds_between(span.first, to) > 0 &&
                  almanac::seconds_between(from, span.second) > 0;
  }
  return share;
}

/// The spans between P1 and P4 during which the Moon is up, found from the moments when it rises and sets.
std::vector<Span> up_spans(const Circumstances& night) {
  const auto &first = *night.eclipse.contacts.P1, &last = *night.eclipse.contacts.P4;
  std::vector<Span> spans;
  if (moment_at(night.place, {}, almanac::sky_at(first)).up) spans.emplace_back(first, last);
  for (const auto& moment : night.moments) {
    if (!moment.name.starts_with("moon") || !holds({first, last}, moment.when)) continue;
    if (moment.name == "moonrise")
      spans.emplace_back(moment.when, last);
    else if (!spans.empty())
      spans.back().second = moment.when;
  }
  return spans;
}

std::string part_seen(const Share& share, const char* what) {
  return fmt::format("{} of {} is seen", share.all ? "all" : share.some ? "some" : "nothing", what);
}

}  // namespace

bool holds(const Span& span, const Instant& when) {
  return almanac::seconds_between(span.first, when) >= 0 &&
         almanac::seconds_between(when, span.second) >= 0;
}

NightMoment moment_at(const almanac::Observer& place, std::string name,
                      const almanac::SkyState& sky) {
  const auto view = almanac::view_from(place, sky);
  const double sine = glm::dot(glm::normalize(sky.sun_m - view.position_m), view.zenith);
  return {std::move(name), sky.when, apparent_place(place, sky), algebra::radians(std::asin(sine)),
          algebra::in_radians(above_horizon(place, sky)) > 0};
}

const char* twilight_name(algebra::Angle sun_altitude) {
  const double degrees = algebra::in_degrees(sun_altitude);
  return degrees > -5. / 6 ? "day"
         : degrees > -6    ? "civil twilight"
         : degrees > -12   ? "nautical twilight"
         : degrees > -18   ? "astronomical twilight"
                           : "night";
}

bool is_seen(const Circumstances& night, const Instant& when) {
  return std::ranges::any_of(night.seen, [&](const Span& span) { return holds(span, when); });
}

Circumstances circumstances(const eclipse::Eclipse& eclipse, const almanac::Observer& place,
                            double hours) {
  Circumstances night{eclipse, place, {}};
  for (const auto& [name, when] : contacts_of(eclipse)) {
    const auto sky = almanac::sky_at(when);
    night.moments.push_back(moment_at(place, name, sky));
    if (name != "greatest") night.moments.back().position_angle = contact_angle(name, sky);
  }
  for (auto& moment : rises_and_sets(night, hours)) night.moments.push_back(std::move(moment));
  std::ranges::stable_sort(night.moments, [](const auto& a, const auto& b) {
    return almanac::seconds_between(a.when, b.when) > 0;
  });
  night.seen = night.up = up_spans(night);
  return night;
}

std::string what_is_seen(const Circumstances& night) {
  const auto& c = night.eclipse.contacts;
  const auto whole = seen_between(night, *c.P1, *c.P4);
  if (whole.all) return "All of the eclipse is seen.";
  if (night.up.empty()) return "Nothing of the eclipse is seen: the Moon is below the horizon.";
  if (!whole.some)
    return "Nothing of the eclipse is seen: the Moon does not stand out from its sky.";
  std::vector<std::string> changes;
  for (const auto& [name, verb] : {std::pair{"moonrise", "rises"},
                                   {"first seen", "is first seen"},
                                   {"last seen", "is last seen"},
                                   {"moonset", "sets"}})
    for (const auto& moment : night.moments)
      if (moment.name == name && holds({*c.P1, *c.P4}, moment.when))
        changes.push_back(fmt::format("{} {}", verb, from_contact(night, moment.when)));
  const auto text = fmt::format("The Moon {}; ", fmt::join(changes, ", "));
  if (c.U2) return text + part_seen(seen_between(night, *c.U2, *c.U3), "totality") + ".";
  if (c.U1) return text + part_seen(seen_between(night, *c.U1, *c.U4), "the partial phase") + ".";
  return text + "some of the penumbral phase is seen.";
}

std::string contacts_seen(const Circumstances& night) {
  const auto contacts = contacts_of(night.eclipse);
  if (night.seen.empty()) return "none";
  if (seen_between(night, contacts.front().second, contacts.back().second).all) return "all";
  std::vector<std::string> parts;
  for (const auto& span : night.seen) {
    std::vector<std::string> names;
    std::string before;
    for (const auto& [name, when] : contacts)
      if (holds(span, when))
        names.push_back(name);
      else if (almanac::seconds_between(when, span.first) > 0)
        before = name;
      else if (names.empty() && !before.empty()) {
        names.push_back(fmt::format("between {} and {}", before, name));
        break;
      }
    parts.push_back(names.size() == 1 ? names.front() : names.front() + " to " + names.back());
  }
  return fmt::format("{}", fmt::join(parts, " and "));
}

}  // namespace coppermoon::uses
