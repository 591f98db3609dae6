// SPDX-License-Identifier: MIT
#include "verbs/film_times.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "algebra/error.h"
#include "verbs/number_with_unit.h"

namespace coppermoon::verbs {
namespace {

using almanac::Instant;

constexpr double most_frames = 1e6;
constexpr std::size_t usual_frames = 240;

bool begins_with_digit(const std::string& text) {
  return !text.empty() && text.find_first_of("0123456789") <= (text.front() == '-' ? 1 : 0);
}

constexpr double half_a_month_s = 15 * 86400.;

/// Of "P1-10min" the contact, and the seconds from it on.
struct FromContact {
  std::string name;
  std::optional<double> seconds;
};

FromContact from_contact(const std::string& text) {
  const auto sign = text.find_first_of("+-");
  if (sign == std::string::npos) return {text, 0};
  const auto seconds =
      number_with_unit(text.substr(sign + 1), {{"min", 60}, {"h", 3600}, {"s", 1}});
  const double way = text[sign] == '-' ? -1 : 1;
  const bool near =
      seconds && std::abs(*seconds) <= half_a_month_s;  // not so where it is no number
  return {text.substr(0, sign), near ? std::optional(way * *seconds) : std::nullopt};
}

/// The eclipse nearest to a moment, which is half a month away at most: another Moon's is not meant.
eclipse::Eclipse eclipse_near(const std::string& text) {
  const auto moment = almanac::instant_from_utc(text);
  const auto nearest = eclipse::nearest_eclipse(moment, eclipse::ShadowConvention::danjon);
  if (std::abs(almanac::seconds_between(moment, nearest.greatest)) > half_a_month_s)
    throw algebra::Error(
        fmt::format("no lunar eclipse within 15 days of {}; the nearest is greatest at {}", text,
                    almanac::utc_text(nearest.greatest)));
  return nearest;
}

/// The eclipse that is named, or else nearest to a moment that is.
eclipse::Eclipse eclipse_of(const FilmTimes& options) {
  for (const auto& text : {options.eclipse, options.from, options.to})
    if (begins_with_digit(text)) return eclipse_near(text);
  if (!options.eclipse.empty()) almanac::instant_from_utc(options.eclipse);  // says what is allowed
  throw algebra::Error(
      fmt::format("from {} to {} of which eclipse? Name a day near it, as 2018-07-27", options.from,
                  options.to));
}

std::size_t count_of(const FilmTimes& options, double seconds) {
  if (options.frames && options.time_scale)
    throw algebra::Error(fmt::format("frames = {} and time-scale = {:g}, allowed one of the two",
                                     *options.frames, *options.time_scale));
  if (options.time_scale) {
    algebra::require_within("time scale", *options.time_scale, 1e-3, 1e6);
    const double count = std::floor(seconds * options.fps / *options.time_scale + 1e-6) + 1;
    algebra::require_within("frames", count, 1, most_frames);
    return static_cast<std::size_t>(count);
  }
  const auto frames = options.frames.value_or(usual_frames);
  algebra::require_within("frames", static_cast<double>(frames), 1, most_frames);
  return frames;
}

}  // namespace

void add_film_times(CLI::App& verb, FilmTimes& options) {
  const std::string group = "The film";
  add_flag(verb, "eclipse,--eclipse", options.eclipse,
           "a day near it, as 2018-07-27; or a file that coppermoon made of it, to go on")
      .in(group);
  const char* moments =
      "an instant, or a contact: P1, U1, U2, greatest, U3, U4, P4, as P1-10min or U2+90s";
  add_flag(verb, "--from", options.from, moments).in(group);
  add_flag(verb, "--to", options.to, moments).in(group);
  add_flag(verb, "--frames", options.frames,
           "1 to 1000000, the first at the one moment, the last "
           "at the other; without: 240")
      .not_negative()
      .in(group);
  add_flag(verb, "--fps", options.fps, "frames in a second of the film, 1 to 1000").in(group);
  add_flag(verb, "--time-scale", options.time_scale,
           "seconds of the eclipse in a second of the film, instead of --frames")
      .in(group);
}

std::vector<std::pair<std::string, Instant>> contacts_of(const eclipse::Eclipse& eclipse) {
  std::vector<std::pair<std::string, Instant>> all;
  const auto& contacts = eclipse.contacts;
  const auto add = [&](const char* name, const std::optional<Instant>& when) {
    if (when) all.emplace_back(name, *when);
  };
  add("P1", contacts.P1), add("U1", contacts.U1), add("U2", contacts.U2);
  add("greatest", eclipse.greatest);
  add("U3", contacts.U3), add("U4", contacts.U4), add("P4", contacts.P4);
  return all;
}

std::string name_of(const eclipse::Eclipse& eclipse) {
  using enum eclipse::EclipseType;
  const auto day = almanac::utc_text(eclipse.greatest);
  const char* type = eclipse.type == total     ? "Total"
                     : eclipse.type == partial ? "Partial"
                                               : "Penumbral";
  return fmt::format("{} eclipse of the Moon, {}", type, day.substr(0, day.find('T')));
}

Instant moment_from(const std::string& text, const eclipse::Eclipse& eclipse) {
  if (begins_with_digit(text)) return almanac::instant_from_utc(text);
  const auto [name, seconds] = from_contact(text);
  std::vector<std::string> names;
  for (const auto& [contact, when] : contacts_of(eclipse)) {
    if (contact == name && seconds) return almanac::later(when, *seconds);
    names.push_back(contact);
  }
  throw algebra::Error(fmt::format(
      "moment = {}, allowed an instant or one of {} of the eclipse of {}, as {}-10min", text,
      fmt::join(names, ", "), almanac::utc_text(eclipse.greatest).substr(0, 10), names.front()));
}

Moments moments_of(const FilmTimes& options) {
  algebra::require_within("fps", options.fps, 1, 1000);
  Moments moments{{}, eclipse_of(options)};
  const auto from = moment_from(options.from, moments.eclipse),
             to = moment_from(options.to, moments.eclipse);
  const double seconds = almanac::seconds_between(from, to);
  constexpr double longest = 86400;
  if (seconds < 0 || seconds > longest)
    throw algebra::Error(fmt::format("from {} to {} are {:.0f} s, allowed 0 to {:.0f}",
                                     almanac::utc_text(from), almanac::utc_text(to), seconds,
                                     longest));
  const auto count = count_of(options, seconds);
  double step = count > 1 ? seconds / static_cast<double>(count - 1) : 0;
  if (options.time_scale) step = *options.time_scale / options.fps;
  for (std::size_t i = 0; i < count; ++i)
    moments.frames.push_back(almanac::later(from, step * static_cast<double>(i)));
  return moments;
}

}  // namespace coppermoon::verbs
