// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "algebra/error.h"
#include "almanac/calendar.h"
#include "eclipse/contacts.h"
#include "eclipse/feature.h"
#include "uses/light/photometric_bands.h"
#include "uses/night/circumstances.h"
#include "uses/picture/brightness.h"
#include "uses/picture/place_text.h"
#include "verbs/command_line.h"
#include "verbs/flags/moments.h"
#include "verbs/recipes/recipe.h"
#include "verbs/reports/report.h"

namespace coppermoon::verbs {
namespace of_almanac {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::string from, to, at, convention = "danjon";
  std::optional<std::string> feature;
  almanac::Calendar calendar = almanac::Calendar::gregorian;
  bool brightness = false, json = false, csv = false;
};

eclipse::ShadowConvention convention_from(const std::string& name) {
  if (name == "danjon-oblate") return eclipse::ShadowConvention::danjon_oblate;
  if (name == "chauvenet") return eclipse::ShadowConvention::chauvenet;
  if (name == "herald-sinnott") return eclipse::ShadowConvention::herald_sinnott;
  return eclipse::ShadowConvention::danjon;
}

/// Eclipse of the list, with the crossing times of the feature that was asked for.
struct Listed {
  eclipse::Eclipse eclipse;
  std::optional<uses::MoonBrightness> brightness{};  ///< at greatest eclipse
  std::optional<eclipse::FeatureTimes> feature{};
  std::optional<std::string> seen{};  ///< first and last contact with the Moon above the horizon
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

void print_heading(bool feature, bool seen, bool brightness) {
  fmt::print("{:<21}{:<10}{:>8}{:>9}{:>9}", "greatest (UTC)", "type", "gamma", "umbral", "penumb.");
  for (const char* key : {"P1", "U1", "U2", "U3", "U4", "P4"}) fmt::print("  {:<8}", key);
  if (feature) fmt::print("  {:<10}  {:<11}", "feature in", "feature out");
  if (brightness) fmt::print("  {:<14}{:<4}", "V", "L");
  if (seen) fmt::print("  seen");
  fmt::print("\n");
}

void print(const Listed& listed) {
  const auto& e = listed.eclipse;
  fmt::print("{:<21}{:<10}{:>8.4f}{:>9.4f}{:>9.4f}", almanac::utc_text(e.greatest, e.calendar),
             name(e.type), e.gamma, e.umbral_magnitude, e.penumbral_magnitude);
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

std::vector<Listed> listed(const Options& options,
                           const std::optional<almanac::SelenographicPoint>& place) {
  const auto first = options.from.empty() ? today(0, options.calendar) : options.from,
             last = options.to.empty() ? today(10, options.calendar) : options.to;
  const auto from = almanac::instant_from_utc(first, options.calendar),
             to = almanac::instant_from_utc(last, options.calendar);
  if (almanac::seconds_between(from, to) < 0)
    throw algebra::Error(fmt::format("--to = {}, allowed {} or later", last, first));
  std::optional<almanac::Observer> observer;
  if (!options.at.empty()) observer = uses::observer_from(options.at);
  std::vector<Listed> list;
  for (const auto& e : eclipse::eclipses_between(from, to, convention_from(options.convention))) {
    Listed& one = list.emplace_back(Listed{e});
    one.eclipse.calendar = options.calendar;
    if (observer) one.seen = uses::contacts_seen(e, *observer);
    if (place) one.feature = eclipse::feature_times(e, *place);
    if (options.brightness) one.brightness = uses::brightness_of({}, almanac::sky_at(e.greatest));
  }
  return list;
}

void run(const Options& options) {
  std::optional<almanac::SelenographicPoint> place;
  if (options.feature) place = uses::feature_from(*options.feature);
  const auto list = listed(options, place);
  auto all = Json::array();
  if (options.csv) {
    for (const auto& each : list) all.push_back(as_row(each));
    return fmt::print("{}", as_csv(all));
  }
  if (!options.json) {
    print_heading(place.has_value(), !options.at.empty(), options.brightness);
    for (const auto& each : list) print(each);
    return;
  }
  for (const auto& each : list) {
    all.push_back(as_json(each.eclipse));
    say_calendar(all.back(), options.calendar);
    if (each.seen) all.back()["seen"] = *each.seen;
    if (each.brightness) all.back().update(as_json(*each.brightness));
    if (place) all.back()["feature"] = as_json(*place, *each.feature, options.calendar);
  }
  fmt::print("{}\n", all.dump(2));
}

}  // namespace
}  // namespace of_almanac

void add_almanac(CLI::App& program) {
  using namespace of_almanac;
  auto* verb = add_verb(program, "almanac", "lists eclipses: type, gamma, magnitudes, contacts");
  const auto options = std::make_shared<Options>();
  add_flag(*verb, "--from", options->from, "first day, as 2026-01-01; default: today");
  add_flag(*verb, "--to", options->to, "last day; default: ten years from today");
  add_calendar_option(*verb, options->calendar);
  add_flag(
      *verb, "--at", options->at,
      "place of an observer: a city, as Honolulu, or LAT,LON [degrees north and east]; adds from "
      "which contact to which some of the Moon is above the horizon");
  add_flag(*verb, "--shadow-convention", options->convention,
           "how the air enlarges the shadow: danjon, danjon-oblate, chauvenet or "
           "herald-sinnott")
      .one_of({"danjon", "danjon-oblate", "chauvenet", "herald-sinnott"});
  add_flag(
      *verb, "--feature", options->feature,
      "place on the Moon: a feature's name, as Tycho, or LAT,LON [degrees north and east]; adds "
      "when the umbra's edge (danjon-oblate) crosses it, whether or not it is seen");
  add_switch(*verb, "--brightness", options->brightness,
             "adds the V magnitude of the whole Moon at greatest eclipse in the air of its month, "
             "with the standard error of a total eclipse, and Danjon's L by V");
  add_run_switch(*verb, "--csv", options->csv, "prints the eclipses as CSV");
  add_run_switch(*verb, "--json", options->json, "prints one JSON document").not_beside({{"csv"}});
  add_recipe_option(*verb);
  on_run(*verb, [options] { run(*options); });
}

}  // namespace coppermoon::verbs
