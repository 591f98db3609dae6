// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "algebra/error.h"
#include "almanac/calendar.h"
#include "almanac/gazetteer.h"
#include "eclipse/contacts.h"
#include "eclipse/feature.h"
#include "result/as_json.h"
#include "uses/light/photometer.h"
#include "uses/night/calendar_file.h"
#include "uses/night/eclipse_light.h"
#include "uses/picture/brightness.h"
#include "uses/picture/place_text.h"
#include "verbs/command_line.h"
#include "verbs/flags/moments.h"
#include "verbs/reports/writers.h"

namespace coppermoon::verbs {
namespace of_almanac {
namespace {

struct Options {
  std::string from, to, at;
  eclipse::ShadowConvention convention = eclipse::ShadowConvention::danjon;
  std::optional<int> year;
  std::optional<std::string> feature;
  std::vector<std::string> outputs;
  almanac::Calendar calendar = almanac::Calendar::gregorian;
  bool brightness = false, json = false, csv = false;
};

using Contact = std::pair<const char*, std::optional<almanac::Instant>>;

std::vector<Contact> contact_columns(const eclipse::Eclipse& e) {
  const auto& c = e.contacts;
  return {{"P1", c.P1}, {"U1", c.U1}, {"U2", c.U2}, {"U3", c.U3}, {"U4", c.U4}, {"P4", c.P4}};
}

/// A feature on the Moon, and the times at which the umbra's edge crosses it.
struct Crossing {
  almanac::SelenographicPoint place;
  eclipse::FeatureTimes times;
};

template <class Field>
void describe(Field&& is, const Crossing& crossing) {
  namespace unit = algebra::unit;
  is.a("Crossing", "Times at which the umbra's edge crosses a feature.");
  is("latitude_deg", crossing.place.latitude, unit::degrees, "latitude of the feature");
  is("longitude_deg", crossing.place.longitude, unit::degrees, "longitude of the feature");
  describe_times(is, crossing.times);
}

/// An eclipse in the printed list, with the optional results that the user requested.
struct Listed {
  eclipse::Eclipse eclipse;
  std::optional<uses::MoonBrightness> brightness{};  ///< the Moon's brightness at greatest eclipse
  std::optional<Crossing> feature{};
  std::optional<uses::Circumstances> night{};  ///< circumstances at the observer's place
  std::optional<std::string> seen{};           ///< first and last contact visible to the observer
};

template <class Field>
void describe_seen(Field&& is, const Listed& listed) {
  is("seen", algebra::if_any(listed.seen),
     "contacts between which a place sees the Moon, with --at");
}

template <class Field>
void describe_brightness(Field&& is, const Listed& listed) {
  const auto of_light = [&](auto value) { return algebra::of_any(listed.brightness, value); };
  using Light = uses::MoonBrightness;
  is("V_magnitude",
     of_light([](const Light& light) { return light.disc.magnitudes[uses::V_band]; }),
     algebra::unit::mag, "V magnitude of the whole Moon at greatest eclipse, with --brightness");
  is("V_error", of_light([](const Light& light) { return light.V_error; }), algebra::unit::mag,
     "its standard error, of a total eclipse");
  is("danjon_by_V", of_light([](const Light& light) { return light.danjon; }),
     "step of Danjon's scale by V");
}

template <class Field>
void describe(Field&& is, const Listed& listed) {
  describe(is, listed.eclipse);
  describe_seen(is, listed);
  describe_brightness(is, listed);
  is("feature", listed.feature, "when the umbra's edge crosses the feature, with --feature");
}

/// An eclipse as a row of a table in which all rows have the same columns.
struct Row {
  Listed listed;
};

template <class Field>
void describe(Field&& is, const Row& row) {
  const auto& [eclipse, brightness, feature, night, seen] = row.listed;
  describe_numbers(is, eclipse);
  if (eclipse.calendar == almanac::Calendar::julian) is("calendar", "julian", "of all dates");
  for (const auto& [name, when] : contact_columns(eclipse)) is(name, when, "a contact");
  if (feature) describe_times(is, feature->times);
  if (seen) describe_seen(is, row.listed);
  if (brightness) describe_brightness(is, row.listed);
}

struct EclipseList {
  std::vector<Listed> eclipses;
  almanac::Calendar calendar;
  std::optional<almanac::SelenographicPoint> feature;
  std::optional<almanac::Observer> observer;
  std::string at;  ///< the observer's place, as the user gave it
};

std::string time_of_day(const std::optional<almanac::Instant>& when) {
  return when ? almanac::time_of_day_text(*when) : "-";
}

/// Today's date, moved forward by the given number of years, as text.
std::string today(int years_later, almanac::Calendar calendar) {
  const auto now = std::chrono::year_month_day(
      std::chrono::floor<std::chrono::days>(std::chrono::system_clock::now()));
  return almanac::date_in(
      calendar, fmt::format("{:04}-{:02}-{:02}", static_cast<int>(now.year()) + years_later,
                            static_cast<unsigned>(now.month()),
                            std::min(28U, static_cast<unsigned>(now.day()))));
}

std::string greatest(const Listed& listed) {
  return almanac::utc_text(listed.eclipse.greatest, listed.eclipse.calendar);
}

void print_heading(const EclipseList& list, bool brightness, std::size_t width) {
  fmt::print("{:<{}}{:<10}{:>8}{:>9}{:>9}", "greatest (UTC)", width, "type", "gamma", "umbral",
             "penumb.");
  for (const char* key : {"P1", "U1", "U2", "U3", "U4", "P4"}) fmt::print("  {:<8}", key);
  if (list.feature) fmt::print("  {:<10}  {:<11}", "feature in", "feature out");
  if (brightness) fmt::print("  {:<14}{:<4}", "V", "L");
  if (list.observer) fmt::print("  seen");
  fmt::print("\n");
}

void print(const Listed& listed, std::size_t width) {
  const auto& e = listed.eclipse;
  fmt::print("{:<{}}{:<10}{:>8.4f}{:>9.4f}{:>9.4f}", greatest(listed), width, name(e.type), e.gamma,
             e.umbral_magnitude, e.penumbral_magnitude);
  for (const auto& [key, when] : contact_columns(e)) fmt::print("  {:<8}", time_of_day(when));
  if (const auto& feature = listed.feature)
    fmt::print("  {:<10}  {:<11}", time_of_day(feature->times.immersion),
               time_of_day(feature->times.emersion));
  if (const auto& light = listed.brightness)
    fmt::print("  {:>6.2f}{:<8}{:<4}", light->disc.magnitudes[uses::V_band],
               light->V_error ? fmt::format(" ± {:.2f}", *light->V_error) : "",
               light->danjon ? fmt::format("{:.1f}", *light->danjon) : "-");
  if (listed.seen) fmt::print("  {}", *listed.seen);
  fmt::print("\n");
}

void print(const EclipseList& list, bool brightness) {
  std::size_t width = 21;  // characters in a date and time with an unsigned year, plus a space
  for (const auto& each : list.eclipses) width = std::max(width, greatest(each).size() + 1);
  print_heading(list, brightness, width);
  for (const auto& each : list.eclipses) print(each, width);
}

/// First and last moment of the time span that the list covers.
std::pair<std::string, std::string> span_of(const Options& options) {
  if (options.year) {
    algebra::require_within("year", *options.year, -1999, 3000);
    const auto year = fmt::format("{}{:04}", *options.year < 0 ? "-" : "", std::abs(*options.year));
    return {year + "-01-01", year + "-12-31T23:59:59Z"};
  }
  return {options.from.empty() ? today(0, options.calendar) : options.from,
          options.to.empty() ? today(10, options.calendar) : options.to};
}

EclipseList listed(const Options& options) {
  const auto [first, last] = span_of(options);
  const auto from = almanac::instant_from_utc(first, options.calendar),
             to = almanac::instant_from_utc(last, options.calendar);
  if (almanac::seconds_between(from, to) < 0)
    throw algebra::Error(fmt::format("--to = {}, allowed {} or later", last, first));
  EclipseList list{{}, options.calendar, {}, {}, options.at};
  if (options.feature) list.feature = uses::feature_from(*options.feature);
  if (!options.at.empty()) list.observer = uses::observer_from(options.at);
  for (const auto& e : eclipse::eclipses_between(from, to, options.convention)) {
    Listed& one = list.eclipses.emplace_back(Listed{e});
    one.eclipse.calendar = options.calendar;
    if (list.observer) {
      one.night = uses::seen_circumstances(e, *list.observer);
      one.seen = uses::contacts_seen(*one.night);
    }
    if (list.feature) one.feature = {*list.feature, eclipse::feature_times(e, *list.feature)};
    if (options.brightness) one.brightness = uses::brightness_of({}, almanac::sky_at(e.greatest));
  }
  return list;
}

std::string as_csv(const EclipseList& list) {
  std::vector<Row> rows;
  for (const auto& each : list.eclipses) rows.push_back({each});
  return result::as_csv(rows, {list.calendar});
}

result::Json as_json(const EclipseList& list) {
  auto all = result::json_of(list.eclipses, {list.calendar});
  for (auto& each : all) say_calendar(each, list.calendar);
  return all;
}

std::vector<eclipse::Eclipse> eclipses_of(const EclipseList& list) {
  std::vector<eclipse::Eclipse> eclipses;
  for (const auto& each : list.eclipses) eclipses.push_back(each.eclipse);
  return eclipses;
}

std::vector<uses::Circumstances> nights_of(const EclipseList& list) {
  std::vector<uses::Circumstances> nights;
  for (const auto& each : list.eclipses) nights.push_back(*each.night);
  return nights;
}

std::string place_name(const EclipseList& list) {
  const auto city = almanac::city_named(list.at);
  return city ? city->name : uses::place_text(*list.observer);
}

void require_in_calendars(const EclipseList& list) {
  if (list.observer && !list.eclipses.empty())
    return uses::require_in_calendars(nights_of(list), place_name(list));
  uses::require_in_calendars(eclipses_of(list));
}

std::string as_calendar(const EclipseList& list) {
  if (list.observer) return uses::as_calendar(nights_of(list), place_name(list), now());
  return uses::as_calendar(eclipses_of(list), now());
}

const Writers<EclipseList>& writers() {
  static const Writers<EclipseList> all{writer_of({".ics", "calendar"}, as_calendar),
                                        writer_of({".csv", "table"}, as_csv),
                                        writer_of({".json", "JSON document"}, as_json)};
  return all;
}

void run(const Options& options) {
  require_writers(options.outputs, writers(), "an almanac");
  const auto list = listed(options);
  if (has_ending(options.outputs, ".ics")) require_in_calendars(list);
  write_files(list, options.outputs, writers());
  if (options.csv) return fmt::print("{}", as_csv(list));
  if (options.json) return print_json(as_json(list));
  print(list, options.brightness);
  print_names(options.outputs);
  const auto unseen = std::ranges::count_if(
      list.eclipses, [](const Listed& each) { return each.night && each.night->seen.empty(); });
  if (unseen > 0 && has_ending(options.outputs, ".ics"))
    fmt::print("The calendar leaves out {} of {} eclipses, of which nothing is seen there.\n",
               unseen, list.eclipses.size());
}

}  // namespace
}  // namespace of_almanac

void add_almanac(Program& program) {
  using namespace of_almanac;
  auto& verb = add_verb(program, "almanac", "lists eclipses: type, gamma, magnitudes, contacts");
  const auto options = std::make_shared<Options>();
  add_flag(verb, "--from", options->from, "first day, as 2026-01-01; default: today");
  add_flag(verb, "--to", options->to, "last day; default: ten years from today");
  add_flag(verb, "year,--year", options->year, "year, as 2026, -1999 to 3000: all of it")
      .within(-1999, 3000)
      .excludes("from")
      .excludes("to");
  add_calendar_option(verb, options->calendar);
  add_flag(
      verb, "--at", options->at,
      "place of an observer: a city, as Honolulu, or LAT,LON [degrees north and east]; adds from "
      "which contact to which the Moon is seen: it is up and stands out from its sky");
  add_choice<eclipse::ShadowConvention>(
      verb, "--shadow-convention", options->convention,
      {eclipse::convention_words.begin(), eclipse::convention_words.end()},
      "how the air enlarges the shadow: danjon, danjon-oblate, chauvenet or herald-sinnott");
  add_flag(
      verb, "--feature", options->feature,
      "place on the Moon: a feature's name, as Tycho, or LAT,LON [degrees north and east]; adds "
      "when the umbra's edge (danjon-oblate) crosses it, whether or not it is seen");
  add_switch(verb, "--brightness", options->brightness,
             "adds the V magnitude of the whole Moon at greatest eclipse in the air of its month, "
             "with the standard error of a total eclipse, and Danjon's L by V");
  add_outputs(verb, options->outputs, writers());
  add_run_switch(verb, "--csv", options->csv, "prints the eclipses as CSV");
  add_json_switch(verb, options->json, {result::fields_of_each<Listed>}).not_beside({{"csv"}});
  on_run(verb, [options] { run(*options); });
}

}  // namespace coppermoon::verbs
