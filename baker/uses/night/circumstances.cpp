// SPDX-License-Identifier: MIT
#include "uses/night/circumstances.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "uses/picture/view.h"

namespace coppermoon::uses {
namespace {

using almanac::Instant;

constexpr double longest_night_s = 13 * 3600., step_s = 600;

/// Altitude of the upper limb over where it rises and sets [rad].
double limb_altitude(const almanac::Observer& place, const Instant& when) {
  constexpr auto refraction = algebra::degrees(34. / 60);
  const auto view = almanac::view_from(place, almanac::sky_at(when));
  const double semidiameter = std::asin(almanac::lunar_radius / view.moon_distance);
  return algebra::in_radians(view.altitude) + semidiameter + algebra::in_radians(refraction);
}

/// Where the altitude goes through 0 between two moments, by bisection to 0.02 s.
Instant crossing(const almanac::Observer& place, Instant from, double seconds) {
  const bool up = limb_altitude(place, from) > 0;
  while (seconds > 0.02) {
    seconds /= 2;
    const auto middle = almanac::later(from, seconds);
    if ((limb_altitude(place, middle) > 0) == up) from = middle;
  }
  return from;
}

NightMoment moment_at(const almanac::Observer& place, std::string name, const Instant& when) {
  return {std::move(name), when, apparent_place(place, almanac::sky_at(when)),
          limb_altitude(place, when) > 0};
}

/// Rise and set around the greatest phase.
std::vector<NightMoment> horizon_crossings(const Circumstances& night) {
  std::vector<NightMoment> all;
  const auto first = almanac::later(night.eclipse.greatest, -longest_night_s);
  bool up = limb_altitude(night.place, first) > 0;
  for (double s = 0; s < 2 * longest_night_s; s += step_s) {
    const bool then = limb_altitude(night.place, almanac::later(first, s + step_s)) > 0;
    if (then != up) {
      auto found = moment_at(night.place, then ? "moonrise" : "moonset",
                             crossing(night.place, almanac::later(first, s), step_s));
      found.up = true;
      all.push_back(std::move(found));
    }
    up = then;
  }
  return all;
}

/// "12 min after U1", from the nearest contact on.
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

/// Whether the Moon is up from one moment to another: always, or at some time.
struct Share {
  bool all = true, some = false;
};

Share up_between(const Circumstances& night, const Instant& from, const Instant& to) {
  const bool up = limb_altitude(night.place, from) > 0;
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
  for (auto& moment : horizon_crossings(night)) night.moments.push_back(std::move(moment));
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

}  // namespace coppermoon::uses
