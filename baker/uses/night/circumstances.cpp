// SPDX-License-Identifier: MIT
#include "uses/night/circumstances.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "uses/picture/horizon_crossings.h"
#include "uses/picture/view.h"

namespace coppermoon::uses {
namespace {

using almanac::Instant;

constexpr double longest_night_s = 13 * 3600.;

double height(const almanac::Observer& place, const Instant& when) {
  return algebra::in_radians(above_horizon(place, almanac::sky_at(when)));
}

NightMoment moment_at(const almanac::Observer& place, std::string name, const Instant& when) {
  return {std::move(name), when, apparent_place(place, almanac::sky_at(when)),
          height(place, when) > 0};
}

/// Moonrise and moonset within the night.
std::vector<NightMoment> rises_and_sets(const Circumstances& night) {
  std::vector<NightMoment> all;
  const auto& greatest = night.eclipse.greatest;
  for (const auto& [when, rises] :
       horizon_crossings(night.place, almanac::later(greatest, -longest_night_s),
                         almanac::later(greatest, longest_night_s))) {
    all.push_back(moment_at(night.place, rises ? "moonrise" : "moonset", when));
    all.back().up = true;
  }
  return all;
}

/// Time from the nearest contact: "12 min after U1".
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

/// Whether the Moon is up in all of an interval, or in some of it.
struct Share {
  bool all = true, some = false;
};

Share up_between(const Circumstances& night, const Instant& from, const Instant& to) {
  const bool up = height(night.place, from) > 0;
  const bool changes = std::ranges::any_of(night.moments, [&](const NightMoment& moment) {
    return moment.name.starts_with("moon") && almanac::seconds_between(from, moment.when) > 0 &&
           almanac::seconds_between(moment.when, to) > 0;
  });
  return {up && !changes, up || changes};
}

std::string part_seen(const Share& share, const char* what) {
  return fmt::format("{} of {} is seen", share.all ? "all" : share.some ? "some" : "nothing", what);
}

}  // namespace

Circumstances circumstances(const eclipse::Eclipse& eclipse, const almanac::Observer& place) {
  Circumstances night{eclipse, place, {}};
  for (const auto& [name, when] : contacts_of(eclipse))
    night.moments.push_back(moment_at(place, name, when));
  for (auto& moment : rises_and_sets(night)) night.moments.push_back(std::move(moment));
  std::ranges::stable_sort(night.moments, [](const auto& a, const auto& b) {
    return almanac::seconds_between(a.when, b.when) > 0;
  });
  return night;
}

std::string what_is_seen(const Circumstances& night) {
  const auto& c = night.eclipse.contacts;
  const auto whole = up_between(night, *c.P1, *c.P4);
  if (whole.all) return "All of the eclipse is seen.";
  if (!whole.some) return "Nothing of the eclipse is seen: the Moon is below the horizon.";
  std::string text;
  for (const auto& moment : night.moments)
    if (moment.name.starts_with("moon") && almanac::seconds_between(*c.P1, moment.when) > 0 &&
        almanac::seconds_between(moment.when, *c.P4) > 0)
      text += fmt::format("The Moon {} {}; ", moment.name == "moonrise" ? "rises" : "sets",
                          from_contact(night, moment.when));
  if (c.U2) return text + part_seen(up_between(night, *c.U2, *c.U3), "totality") + ".";
  if (c.U1) return text + part_seen(up_between(night, *c.U1, *c.U4), "the partial phase") + ".";
  return text + "some of the penumbral phase is seen.";
}

std::string contacts_seen(const eclipse::Eclipse& eclipse, const almanac::Observer& place) {
  const auto contacts = contacts_of(eclipse);
  const auto changes = horizon_crossings(place, contacts.front().second, contacts.back().second);
  auto change = changes.begin();
  bool up = height(place, contacts.front().second) > 0;
  if (changes.empty()) return up ? "all" : "none";
  std::vector<std::string> parts, names;
  const auto end_part = [&](const std::string& before, const std::string& after) {
    if (names.empty())
      parts.push_back(fmt::format("between {} and {}", before, after));
    else
      parts.push_back(names.size() == 1 ? names.front() : names.front() + " to " + names.back());
    names.clear();
  };
  std::string last;
  for (const auto& [name, when] : contacts) {
    for (; change != changes.end() && almanac::seconds_between(change->when, when) > 0; ++change) {
      if (!change->rises) end_part(last, name);
      up = change->rises;
    }
    if (up) names.push_back(name);
    last = name;
  }
  if (up) end_part(last, last);
  return fmt::format("{}", fmt::join(parts, " and "));
}

}  // namespace coppermoon::uses
