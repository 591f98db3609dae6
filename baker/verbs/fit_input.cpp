// SPDX-License-Identifier: MIT
#include "verbs/fit_input.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <sstream>

#include "algebra/error.h"
#include "algebra/number.h"
#include "almanac/gazetteer.h"
#include "eclipse/moment.h"
#include "uses/picture/local_time.h"
#include "uses/picture/photo_file.h"
#include "verbs/flags/moments.h"
#include "verbs/reports/one_line.h"

namespace coppermoon::verbs::of_fit {
namespace {

/// Value for the i-th photograph, from a list that holds one value for each photograph or a single value for all.
/// Absent if the list is empty.
template <class Value>
std::optional<Value> value_for(const Options& options, const std::vector<Value>& values,
                               std::size_t i, const char* what) {
  const auto photos = options.photos.size();
  if (values.empty()) return std::nullopt;
  if (values.size() != 1 && values.size() != photos)
    throw algebra::Error(fmt::format("{} {}, allowed one for all or {}, one for each photograph",
                                     values.size(), what, photos));
  return values[values.size() == 1 ? 0 : i];
}

/// Number for the i-th photograph, from a string such as "0.5,1,2" with a number for each photograph or one for all.
std::optional<double> number_for(const Options& options, const std::string& list, std::size_t i,
                                 const char* what) {
  const auto numbers = algebra::numbers_in(list);
  if (!numbers)
    throw algebra::Error(fmt::format("{} = {}, allowed numbers with commas", what, list));
  return value_for(options, *numbers, i, what);
}

constexpr const char* from_header = "from-header";

/// Time zone of a camera's clock: the one given as an option, else the one in the header; empty if unknown.
std::string zone_of(const uses::HeaderClock& clock, const Options& options) {
  return options.zone.empty() ? clock.offset.value_or("") : options.zone;
}

/// Time of a photograph in UTC according to the camera's clock. If the clock's time zone is unknown, it is taken to be
/// that of the observer's place, or UTC if there is no observer.
std::string instant_by(const uses::HeaderClock& clock, const Options& options) {
  const auto zone = zone_of(clock, options);
  if (zone.starts_with('+') || zone.starts_with('-')) return clock.local + zone;
  const auto& observer = options.request.view.observer;
  const auto named = zone.empty() && observer ? uses::time_zone_of(*observer) : zone;
  return named.empty() ? clock.local + "Z"
                       : almanac::utc_text(uses::instant_of_local(clock.local, named));
}

/// Time of a photograph in UTC, given as a time in UTC, a day or a moment relative to a contact.
std::string instant_told(const std::string& moment, const Options& options) {
  return eclipse::is_day(moment) || eclipse::is_from_contact(moment)
             ? almanac::utc_text(
                   instant_of(MomentOptions{.text = moment}, options.request.view.observer))
             : moment;
}

/// Adds the i-th photograph to the request, with the time at which it was taken.
void add_photograph(const Options& options, std::size_t i, const std::string& instant,
                    Input& input) {
  input.request.photographs.push_back({.file = options.photos[i],
                                       .instant = almanac::instant_from_utc(instant),
                                       .coding = options.coding,
                                       .time_s = number_for(options, options.times, i, "times"),
                                       .iso = number_for(options, options.isos, i, "ISO speeds"),
                                       .f_number = options.f_number});
  input.instants.push_back(instant);
}

/// Warns if the offset from UTC in a photograph's header is needed but cannot be read.
void warn_of_offset(const Options& options, const std::string& photo,
                    const uses::HeaderClock& clock) {
  if (options.zone.empty() && !clock.unread.empty())
    fmt::print(stderr,
               "coppermoon: {}: its header's offset from UTC = {}, allowed as +03:00: its zone "
               "counts as unknown\n",
               one_line(photo), one_line(clock.unread));
}

/// Whether the photographs' times are taken from GPS. They are if all photographs have a GPS time, no camera's clock
/// drifts relative to GPS (a drift would mean that an old GPS time was repeated), and no zone is given for the clocks.
bool are_by_gps(const Options& options) try {
  constexpr double most_drift_s = 2;
  std::map<std::string, double> ahead_s;
  for (const auto& photo : options.photos) {
    const auto gps = uses::gps_clock_of(photo);
    if (!gps || !options.zone.empty()) return false;
    const double ahead =
        uses::taken_at_s(photo).value_or(uses::seconds_at(*gps)) - uses::seconds_at(*gps);
    const auto [first, added] = ahead_s.try_emplace(uses::camera_of(photo).value_or(""), ahead);
    if (std::abs(ahead - first->second) > most_drift_s) return false;
  }
  return true;
} catch (const algebra::Error&) {  // the date in a header is not a valid date
  return false;
}

/// Adds photographs with the times in their headers. Photographs without a date are left out. Throws if none has a
/// date.
void add_by_headers(const Options& options, bool by_gps, Input& input) {
  for (std::size_t i = 0; i < options.photos.size(); ++i) {
    std::optional<uses::HeaderClock> clock;
    try {
      clock = by_gps ? uses::gps_clock_of(options.photos[i]) : uses::clock_of(options.photos[i]);
    } catch (const algebra::Error& error) {
      input.undated.push_back({.left_out = uses::reason_without_name(options.photos[i], error),
                               .file = options.photos[i]});
      continue;
    }
    warn_of_offset(options, options.photos[i], *clock);
    add_photograph(options, i, instant_by(*clock, options), input);
    input.zones.push_back(by_gps ? "GPS" : zone_of(*clock, options));
    input.request.half_hours_free |= input.zones.back().empty();
  }
  if (input.request.photographs.empty() && !input.undated.empty())
    throw algebra::Error(
        fmt::format("{}: {}", input.undated.front().file, input.undated.front().left_out));
}

}  // namespace

Input input_of(const Options& options) {
  constexpr double usual_clock_error_min = 10, gps_error_min = 1. / 60, farthest_clock_s = 3 * 3600;
  const bool by_headers = options.instants == from_header,
             by_gps = by_headers && are_by_gps(options);
  Input input{options.request, {}};
  input.request.clock_search_s = by_headers && !by_gps ? farthest_clock_s : 0;
  input.request.clock_error_s =
      60 * options.clock_error_min.value_or(by_gps       ? gps_error_min
                                            : by_headers ? usual_clock_error_min
                                                         : 0);
  if (by_headers) {
    add_by_headers(options, by_gps, input);
  } else if (!options.photos.empty()) {
    std::vector<std::string> instants;
    std::istringstream parts(options.instants);
    for (std::string part; std::getline(parts, part, ',');) instants.push_back(part);
    for (std::size_t i = 0; i < options.photos.size(); ++i)
      add_photograph(options, i,
                     instant_told(*value_for(options, instants, i, "instants"), options), input);
  }
  if (!options.magnitudes.empty())
    input.request.magnitudes = uses::read_magnitudes(options.magnitudes);
  return input;
}

}  // namespace coppermoon::verbs::of_fit
