// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <memory>
#include <sstream>

#include "algebra/error.h"
#include "algebra/number.h"
#include "almanac/gazetteer.h"
#include "result/as_json.h"
#include "uses/fit/fit_results.h"
#include "uses/fit/measured_light.h"
#include "uses/picture/local_time.h"
#include "uses/picture/photo_file.h"
#include "uses/picture/picture_parameters.h"
#include "verbs/command_line.h"
#include "verbs/flags/coding_option.h"
#include "verbs/flags/light_options.h"
#include "verbs/flags/moon_options.h"
#include "verbs/reports/fit_tables.h"
#include "verbs/reports/in_words.h"
#include "verbs/reports/one_line.h"
#include "verbs/reports/progress_bar.h"

namespace coppermoon::verbs {
namespace of_fit {
namespace {

struct Options {
  std::vector<std::string> photos, outputs;
  std::string instants, times, isos, magnitudes;
  std::string zone;  ///< time zone of the cameras' clocks; if empty, taken from the headers
  std::optional<double> clock_error_min;
  texture::Coding coding = texture::Coding::as_file_says;
  std::optional<double> f_number;
  uses::FitRequest request;  ///< request for the fit, still without photographs and magnitudes
  bool despite_misfit = false, misfits = false, json = false;
};

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

/// Request for the fit, and further information about the photographs for the report.
struct Input {
  uses::FitRequest request;
  std::vector<std::string> instants;
  std::vector<std::string> zones{};             ///< time zones of the photographs; "" if unknown
  std::vector<uses::ReadPhotograph> undated{};  ///< photographs without a date in their headers
};

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

/// Warns of photographs that an image editor may have changed.
void warn_of_editors(const Options& options) {
  if (options.coding != texture::Coding::as_file_says) return;
  std::optional<std::string> editor;
  std::size_t edited = 0;
  for (const auto& photo : options.photos)
    if (const auto its = uses::editor_of(photo)) editor = its, ++edited;
  if (edited > 0)
    fmt::print(stderr,
               "coppermoon: {} of {} photographs were written by {}, perhaps not as their camera "
               "wrote them: errors count three times; --coding camera vouches for them\n",
               edited, options.photos.size(), one_line(*editor));
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
      add_photograph(options, i, *value_for(options, instants, i, "instants"), input);
  }
  if (!options.magnitudes.empty())
    input.request.magnitudes = uses::read_magnitudes(options.magnitudes);
  return input;
}

/// Completes a fit's report with times as the user gave them, time zones of the clocks, and photographs without a date.
void add_told(const Input& input, uses::FitReport& found) {
  for (std::size_t i = 0; i < input.instants.size(); ++i)
    found.photographs[i].instant = input.instants[i];
  for (auto& night : found.nights)
    if (night.clock && !input.zones.empty())
      night.clock->zone = input.zones[night.photographs.front()];
  found.photographs.insert(found.photographs.end(), input.undated.begin(), input.undated.end());
}

void require_sound(const Options& options) {
  if (!options.photos.empty() && options.instants.empty())
    throw algebra::Error(
        "--instants is missing: photographs need the moments when they were taken (UTC)");
  if (options.photos.empty() && options.magnitudes.empty())
    throw algebra::Error("photographs or --magnitudes are missing: there is nothing to explain");
  if (options.photos.empty() && !options.outputs.empty())
    throw algebra::Error("--output: shows the light of photographs, and none is given");
  for (const auto& file : options.outputs) uses::require_light_file(file);
}

void run(const Options& options) {
  require_sound(options);
  const auto input = input_of(options);
  auto found = [&] {
    ProgressBar bar("fit");
    return uses::fitted_air(input.request, bar.progress());
  }();
  add_told(input, found);
  const bool explained = explains(found.fit);
  if (!explained && !options.despite_misfit) {
    if (!options.json) print_misfits(found);
    throw algebra::Error(misfit_in_words(found) + "; --despite-misfit answers all the same");
  }
  if (!explained) fmt::print(stderr, "coppermoon: {}\n", one_line(misfit_in_words(found)));
  std::vector<std::vector<uses::MeasuredLight>> nights;
  for (const auto& night : found.nights) nights.push_back(night.light);
  for (const auto& file : options.outputs) uses::write_measured_light(file, nights);
  warn_of_editors(options);
  for (const auto& night : found.nights)
    if (const auto doubt = night.curve ? doubt_of(*night.curve) : ""; !doubt.empty())
      fmt::print(stderr, "coppermoon: {}\n", doubt);
  if (options.json) return void(fmt::print("{}\n", result::as_json(found).dump(2)));
  print_fit(found);
  if (options.misfits || !explained) print_misfits(found);
}

void add_photograph_options(Verb& verb, Options& options) {
  const std::string group = "How the photographs were taken";
  const auto add = [&](const char* flag, auto& value, const char* text) -> request::Parameter& {
    return add_flag(verb, flag, value, text).in(group).only_with({{"photos"}});
  };
  add("--instants", options.instants,
      "moments of the photographs in UTC, one for all or one for each, with commas between; "
      "from-header: as GPS says, or else the cameras' clocks, whose errors are then found");
  add("--zone", options.zone,
      "time zone of the cameras' clocks, for --instants from-header, as +02:00 or Europe/Berlin; "
      "default: that in the header, else the one that the shadow on the Moon tells");
  add("--times", options.times,
      "exposure times [s], one for all or one for each; default: the header's");
  add("--isos", options.isos, "ISO speeds, one for all or one for each; default: the header's");
  add("--f-number", options.f_number,
      "focal length over aperture, 0.5 to 512; default: the header's")
      .within(0.5, 512);
  add("--camera", options.request.camera,
      "camera whose saturation is meant; default: that of ISO 12232");
  add("--exposure-error", options.request.exposure_error,
      "standard error of the exposures' logarithm, common to a night, 0.001 to 10; default: 0.1, "
      "with a camera's own tone curve free")
      .within(1e-3, 10);
  add("--shutter-error", options.request.shutter_error,
      "standard error of the logarithm of one exposure relative to the night's others, 0.001 to "
      "10; "
      "default: 0.03, for a camera's own JPEGs 0.1")
      .within(1e-3, 10);
  add("--white-balance-error", options.request.white_balance_error,
      "standard error of red and blue relative to green, 0.001 to 10; default: 0.03, for a "
      "camera's own "
      "JPEGs 0.3, or 0.06 to 0.2 if their header has the gains as shot")
      .within(1e-3, 10);
  add("--weather-error", options.request.weather_error,
      "standard error of the light of 30 degrees of the Earth's limb by weather, in red in usual "
      "air, 0 to 1; "
      "default: 0.2 for a camera's own JPEGs and raw files, else 0")
      .within(0, 1);
  add("--clock-error", options.clock_error_min,
      "standard error of a camera's clock [minutes], 0 to 60; the clock's own error is then found; "
      "default: 10 with --instants from-header, up to 3 hours where partial phases tell, else 0")
      .within(0, 60);
  add_coding_option(verb, options.coding,
                    "coding of the photographs' numbers: camera (its own tone curve, which is "
                    "found; so where the "
                    "header names a camera), srgb or linear")
      .in(group)
      .only_with({{"photos"}});
}

}  // namespace
}  // namespace of_fit

void add_fit(Program& program) {
  using namespace of_fit;
  auto& verb = add_verb(
      program, "fit",
      "finds the aerosol, cloud and ozone that explain photographs or magnitudes of an eclipse");
  const auto options = std::make_shared<Options>();
  add_flag(verb, "photos,--photos", options->photos,
           "photographs of eclipsed Moons: any image, or a camera's raw file")
      .reads_file()
      .of(request::Affects::share);
  add_flag(verb, "--magnitudes", options->magnitudes,
           "magnitudes of the whole Moon, .csv: instant,band,magnitude,error")
      .reads_file();
  add_flag(
      verb, "-o,--output", options->outputs,
      "light over full sunlight by distance from the shadow's axis, as the photographs show it "
      "and as the air that was found gives it: numbers as .csv, a plot as .png, .svg or .pdf. "
      "May be given again")
      .writes_file();
  add_photograph_options(verb, *options);
  auto& moon = options->request.moon;
  add_map_options(verb, moon);
  add_described(verb, moon.light.air, uses::describe_terms);
  add_described(verb, moon.light.air.column, uses::describe_layers);
  add_described(verb, moon.light, uses::describe_sunlight);
  add_described(verb, options->request.view, uses::describe_observer);
  add_described(verb, moon.response, uses::describe_response);
  add_choice<uses::Unknowns>(
      verb, "--unknowns", options->request.unknowns,
      {{"factors", uses::Unknowns::factors}, {"amounts", uses::Unknowns::amounts}},
      "what is looked for. factors: on the stratospheric aerosol, chance of cloud and ozone that "
      "the month has; amounts: a layer of dust, a deck of cloud and a column of ozone, the same "
      "everywhere. Default: factors, in air without a month amounts");
  add_switch(verb, "--despite-misfit", options->despite_misfit,
             "answers although no air explains what was seen, with a warning");
  add_run_switch(verb, "--misfits", options->misfits,
                 "prints how each photograph and channel differs from the air that was found; done "
                 "in any case where no air explains them")
      .not_beside({{"json"}});
  add_json_switch(verb, options->json, {result::fields_of<uses::FitReport>});
  on_run(verb, [options] { run(*options); });
}

}  // namespace coppermoon::verbs
