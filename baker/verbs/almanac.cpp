// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "algebra/error.h"
#include "almanac/calendar.h"
#include "almanac/gazetteer.h"
#include "eclipse/contacts.h"
#include "eclipse/feature.h"
#include "uses/light/photometer.h"
#include "uses/night/calendar_file.h"
#include "uses/night/eclipse_light.h"
#include "uses/picture/brightness.h"
#include "uses/picture/place_text.h"
#include "verbs/command_line.h"
#include "verbs/flags/moments.h"
#include "verbs/reports/report.h"
#include "verbs/reports/writers.h"

namespace coppermoon::verbs {
namespace of_almanac {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::string from, to, at, convention = "danjon";
  std::optional<int> year;
  std::optional<std::string> feature;
  std::vector<std::string> outputs;
  almanac::Calendar calendar = almanac::Calendar::gregorian;
  bool brightness = false, json = false, csv = false;
};

eclipse::ShadowConvention convention_from(const std::string& name) {
  if (name == "danjon-oblate") return eclipse::ShadowConvention::danjon_oblate;
  if (name == "chauvenet") return eclipse::ShadowConvention::chauvenet;
  if (name == "herald-sinnott") return eclipse::ShadowConvention::herald_sinnott;
  return eclipse::ShadowConvention::danjon;
}

/// Eclipse of a list, with the crossing times of the feature that was asked for.
struct Listed {
  eclipse::Eclipse eclipse;
  std::optional<uses::MoonBrightness> brightness{};  ///< at greatest eclipse
  std::optional<eclipse::FeatureTimes> feature{};
  std::optional<uses::Circumstances> night{};  ///< at the observer's place
  std::optional<std::string> seen{};           ///< first and last contact that is seen
};

/// Eclipses of some years: what the command prints.
struct EclipseList {
  std::vector<Listed> eclipses;
  almanac::Calendar calendar;
  std::optional<almanac::SelenographicPoint> feature;
  std::optional<almanac::Observer> observer;
  std::string at;  ///< the observer's place, as it was given
};

using Contact = std::pair<const char*, std::optional<almanac::Instant>>;

std::vector<Contact> contact_columns(const eclipse::Eclipse& e) {
  const auto& c = e.contacts;
  return {{"P1", c.P1}, {"U1", c.U1}, {"U2", c.U2}, {"U3", c.U3}, {"U4", c.U4}, {"P4", c.P4}};
}

Json numbers_of(const eclipse::Eclipse& e) {
  return {{"greatest", almanac::utc_text(e.greatest, e.calendar)},
          {"type", name(e.type)},
          {"gamma", e.gamma},
          {"umbral_magnitude", e.umbral_magnitude},
          {"penumbral_magnitude", e.penumbral_magnitude}};
}

Json as_json(const eclipse::Eclipse& e) {
  auto all = numbers_of(e);
  all["contacts"] = Json::object();
  for (const auto& [key, when] : contact_columns(e))
    if (when) all["contacts"][key] = almanac::utc_text(*when, e.calendar);
  return all;
}

Json as_json(const almanac::SelenographicPoint& place, const eclipse::FeatureTimes& times,
             almanac::Calendar calendar) {
  Json feature{{"latitude_deg", algebra::in_degrees(place.latitude)},
               {"longitude_deg", algebra::in_degrees(place.longitude)}};
  if (times.immersion) feature["immersion"] = almanac::utc_text(*times.immersion, calendar);
  if (times.emersion) feature["emersion"] = almanac::utc_text(*times.emersion, calendar);
  return feature;
}

/// Number, or null where there is none.
Json or_null(const std::optional<double>& number) { return number ? Json(*number) : Json(); }

Json as_json(const uses::MoonBrightness& brightness) {
  return {{"V_magnitude", brightness.disc.magnitudes[uses::V_band]},
          {"V_error", or_null(brightness.V_error)},
          {"danjon_by_V", or_null(brightness.danjon)}};
}

/// An eclipse as a row of a table; every row has each column.
Json as_row(const Listed& listed) {
  const auto calendar = listed.eclipse.calendar;
  const auto text = [&](const std::optional<almanac::Instant>& when) {
    return when ? Json(almanac::utc_text(*when, calendar)) : Json();
  };
  auto row = numbers_of(listed.eclipse);
  say_calendar(row, calendar);
  for (const auto& [key, when] : contact_columns(listed.eclipse)) row[key] = text(when);
  if (const auto& times = listed.feature)
    row["immersion"] = text(times->immersion), row["emersion"] = text(times->emersion);
  if (listed.seen) row["seen"] = *listed.seen;
  if (listed.brightness) row.update(as_json(*listed.brightness));
  return row;
}

std::string time_of_day(const std::optional<almanac::Instant>& when) {
  return when ? almanac::time_of_day_text(*when) : "-";
}

/// Default span: from today to ten years later.
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
  if (const auto& times = listed.feature)
    fmt::print("  {:<10}  {:<11}", time_of_day(times->immersion), time_of_day(times->emersion));
  if (const auto& light = listed.brightness)
    fmt::print("  {:>6.2f}{:<8}{:<4}", light->disc.magnitudes[uses::V_band],
               light->V_error ? fmt::format(" ± {:.2f}", *light->V_error) : "",
               light->danjon ? fmt::format("{:.1f}", *light->danjon) : "-");
  if (listed.seen) fmt::print("  {}", *listed.seen);
  fmt::print("\n");
}

void print(const EclipseList& list, bool brightness) {
  std::size_t width = 21;  // of a year without a sign, and a space
  for (const auto& each : list.eclipses) width = std::max(width, greatest(each).size() + 1);
  print_heading(list, brightness, width);
  for (const auto& each : list.eclipses) print(each, width);
}

/// First and last moment of a list.
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
  for (const auto& e : eclipse::eclipses_between(from, to, convention_from(options.convention))) {
    Listed& one = list.eclipses.emplace_back(Listed{e});
    one.eclipse.calendar = options.calendar;
    if (list.observer) {
      one.night = uses::seen_circumstances(e, *list.observer);
      one.seen = uses::contacts_seen(*one.night);
    }
    if (list.feature) one.feature = eclipse::feature_times(e, *list.feature);
    if (options.brightness) one.brightness = uses::brightness_of({}, almanac::sky_at(e.greatest));
  }
  return list;
}

std::string as_csv(const EclipseList& list) {
  auto rows = Json::array();
  for (const auto& each : list.eclipses) rows.push_back(as_row(each));
  return verbs::as_csv(rows);
}

std::string as_json(const EclipseList& list) {
  auto all = Json::array();
  for (const auto& each : list.eclipses) {
    all.push_back(as_json(each.eclipse));
    say_calendar(all.back(), list.calendar);
    if (each.seen) all.back()["seen"] = *each.seen;
    if (each.brightness) all.back().update(as_json(*each.brightness));
    if (list.feature) all.back()["feature"] = as_json(*list.feature, *each.feature, list.calendar);
  }
  return all.dump(2) + "\n";
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
  using List = EclipseList;
  using File = std::filesystem::path;
  static const Writers<List> all{
      {{".ics", "calendar"},
       [](const List& list, const File& file) { files::write_whole(file, as_calendar(list)); }},
      {{".csv", "table"},
       [](const List& list, const File& file) { files::write_whole(file, as_csv(list)); }},
      {{".json", "JSON document"},
       [](const List& list, const File& file) { files::write_whole(file, as_json(list)); }}};
  return all;
}

void run(const Options& options) {
  require_writers(options.outputs, writers(), "an almanac");
  const auto list = listed(options);
  if (has_ending(options.outputs, ".ics")) require_in_calendars(list);
  write_files(list, options.outputs, writers());
  if (options.csv) return fmt::print("{}", as_csv(list));
  if (options.json) return fmt::print("{}", as_json(list));
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
  add_flag(verb, "--shadow-convention", options->convention,
           "how the air enlarges the shadow: danjon, danjon-oblate, chauvenet or "
           "herald-sinnott")
      .one_of({"danjon", "danjon-oblate", "chauvenet", "herald-sinnott"});
  add_flag(
      verb, "--feature", options->feature,
      "place on the Moon: a feature's name, as Tycho, or LAT,LON [degrees north and east]; adds "
      "when the umbra's edge (danjon-oblate) crosses it, whether or not it is seen");
  add_switch(verb, "--brightness", options->brightness,
             "adds the V magnitude of the whole Moon at greatest eclipse in the air of its month, "
             "with the standard error of a total eclipse, and Danjon's L by V");
  add_outputs(verb, options->outputs, writers());
  add_run_switch(verb, "--csv", options->csv, "prints the eclipses as CSV");
  add_run_switch(verb, "--json", options->json, "prints one JSON document").not_beside({{"csv"}});
  on_run(verb, [options] { run(*options); });
}

}  // namespace coppermoon::verbs
