// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

#include "algebra/error.h"
#include "algebra/number.h"
#include "almanac/gazetteer.h"
#include "uses/fit/fit.h"
#include "uses/fit/measured_light.h"
#include "uses/fit/misfit.h"
#include "uses/picture/local_time.h"
#include "uses/picture/photo_file.h"
#include "uses/picture/picture_parameters.h"
#include "verbs/command_line.h"
#include "verbs/flags/coding_option.h"
#include "verbs/flags/light_options.h"
#include "verbs/flags/moon_options.h"
#include "verbs/reports/in_words.h"
#include "verbs/reports/one_line.h"
#include "verbs/reports/progress_bar.h"

namespace coppermoon::verbs {
namespace of_fit {
namespace {

using Json = nlohmann::ordered_json;
using uses::Estimate, uses::ReadPhotograph;

struct Options {
  std::vector<std::string> photos, outputs;
  std::string instants, times, isos, magnitudes;
  std::string zone;  ///< of the cameras' clocks; empty: by the headers, else unknown
  std::optional<double> clock_error_min;
  texture::Coding coding = texture::Coding::as_file_says;
  std::optional<double> f_number;
  uses::FitRequest request;  ///< without photographs and magnitudes
  bool despite_misfit = false, misfits = false, json = false;
};

/// Value for a photograph, of a list with one for each or one for all.
template <class Value>
const Value& one_of(const std::vector<Value>& values, std::size_t i) {
  return values[values.size() == 1 ? 0 : i];
}

void require_one_or(std::size_t photos, std::size_t count, const char* what) {
  if (count != 1 && count != photos)
    throw algebra::Error(fmt::format("{} {}, allowed one for all or {}, one for each photograph",
                                     count, what, photos));
}

/// Texts of the instants, one for each photograph or one for all.
std::vector<std::string> instants_of(const Options& options) {
  std::vector<std::string> all;
  std::istringstream parts(options.instants);
  for (std::string part; std::getline(parts, part, ',');) all.push_back(part);
  require_one_or(options.photos.size(), all.size(), "instants");
  return all;
}

/// Number for a photograph from a list with one for each or one for all; nothing of an empty list.
std::optional<double> number_for(const std::string& list, std::size_t i, std::size_t photos,
                                 const char* what) {
  const auto numbers = algebra::numbers_in(list);
  if (!numbers)
    throw algebra::Error(fmt::format("{} = {}, allowed numbers with commas", what, list));
  if (numbers->empty()) return std::nullopt;
  require_one_or(photos, numbers->size(), what);
  return one_of(*numbers, i);
}

/// A photograph without a date in its header.
struct Undated {
  std::string file, why;
};

/// Request of the fit, the texts of its instants, and photographs left out.
struct Input {
  uses::FitRequest request;
  std::vector<std::string> instants;
  std::vector<std::string> zones{};  ///< [photograph] of the clocks, empty: unknown; or none
  std::vector<Undated> undated{};
};

constexpr const char* from_header = "from-header";

/// Zone of a camera's clock by the option, else by the header; empty: unknown.
std::string zone_of(const uses::HeaderClock& clock, const Options& options) {
  return options.zone.empty() ? clock.offset.value_or("") : options.zone;
}

/// Instant in UTC by a camera's clock, in its zone, else the place's; without any, the clock's reading passes for UTC.
std::string instant_by(const uses::HeaderClock& clock, const Options& options) {
  const auto zone = zone_of(clock, options);
  if (zone.starts_with('+') || zone.starts_with('-')) return clock.local + zone;
  const auto& observer = options.request.view.observer;
  const auto named = zone.empty() && observer ? uses::time_zone_of(*observer) : zone;
  return named.empty() ? clock.local + "Z"
                       : almanac::utc_text(uses::instant_of_local(clock.local, named));
}

/// Adds the i-th photograph, taken at an instant.
void add_photograph(const Options& options, std::size_t i, const std::string& instant,
                    Input& input) {
  const auto photos = options.photos.size();
  input.request.photographs.push_back({.file = options.photos[i],
                                       .instant = almanac::instant_from_utc(instant),
                                       .coding = options.coding,
                                       .time_s = number_for(options.times, i, photos, "times"),
                                       .iso = number_for(options.isos, i, photos, "ISO speeds"),
                                       .f_number = options.f_number});
  input.instants.push_back(instant);
}

/// Says that a header's offset from UTC is none, where it would count.
void warn_of_offset(const Options& options, const std::string& photo,
                    const uses::HeaderClock& clock) {
  if (options.zone.empty() && !clock.unread.empty())
    fmt::print(stderr,
               "coppermoon: {}: its header's offset from UTC = {}, allowed as +03:00: its zone "
               "counts as unknown\n",
               one_line(photo), one_line(clock.unread));
}

/// Adds photographs by their headers' clocks; photographs without a date are left out while there are others.
void add_by_headers(const Options& options, Input& input) {
  for (std::size_t i = 0; i < options.photos.size(); ++i) {
    std::optional<uses::HeaderClock> clock;
    try {
      clock = uses::clock_of(options.photos[i]);
    } catch (const algebra::Error& error) {
      input.undated.push_back(
          {options.photos[i], uses::reason_without_name(options.photos[i], error)});
      continue;
    }
    warn_of_offset(options, options.photos[i], *clock);
    add_photograph(options, i, instant_by(*clock, options), input);
    input.zones.push_back(zone_of(*clock, options));
    input.request.half_hours_free |= input.zones.back().empty();
  }
  if (input.request.photographs.empty() && !input.undated.empty())
    throw algebra::Error(
        fmt::format("{}: {}", input.undated.front().file, input.undated.front().why));
}

Input input_of(const Options& options) {
  constexpr double usual_clock_error_min = 10, farthest_clock_s = 3 * 3600;
  const bool by_headers = options.instants == from_header;
  Input input{options.request, {}};
  input.request.clock_search_s = by_headers ? farthest_clock_s : 0;
  input.request.clock_error_s =
      60 * options.clock_error_min.value_or(by_headers ? usual_clock_error_min : 0);
  if (by_headers) {
    add_by_headers(options, input);
  } else if (!options.photos.empty()) {
    const auto instants = instants_of(options);
    for (std::size_t i = 0; i < options.photos.size(); ++i)
      add_photograph(options, i, one_of(instants, i), input);
  }
  if (!options.magnitudes.empty())
    input.request.magnitudes = uses::read_magnitudes(options.magnitudes);
  return input;
}

/// Least information of an estimate that counts as determined.
constexpr double no_information = 0.3;

Json as_json(const Estimate& estimate, bool logarithm) {
  const auto value = [&](double x) { return logarithm ? std::exp(x) : x; };
  return {{"median", value(estimate.median)},
          {"low_68", value(estimate.low)},
          {"high_68", value(estimate.high)},
          {"told", estimate.information >= no_information}};
}

Json as_json(const uses::ReadPhotograph& photograph, const std::string& file,
             const std::string& instant) {
  Json all{{"file", file},
           {"instant", instant},
           {"numbers", photograph.measurements},
           {"exposure_known", photograph.exposure_known},
           {"coding", photograph.curved ? "camera" : "known"}};
  if (photograph.clipped_at)
    all["clipped_at"] = {{"number", photograph.clipped_at->number},
                         {"from", photograph.clipped_at->of_header ? "DATAMAX" : "greatest"}};
  if (photograph.left_out.empty()) {
    all["mirrored"] = photograph.registration.render_to_photo.mirrored;
    all["correlation"] = photograph.registration.correlation;
  } else {
    all["left_out"] = photograph.left_out;
  }
  return all;
}

constexpr std::array channel_names{"red", "green", "blue"};

Json as_json(const uses::Suspicion& suspicion, const Input& input) {
  constexpr std::array names{"instant", "exposure", "colours", "clock", "tone curve", "air"};
  return {{"file", input.request.photographs[suspicion.worst.photograph].file},
          {"channel", channel_names[suspicion.worst.channel]},
          {"place", uses::part_of_shadow(suspicion.worst.worst_km)},
          {"suspect", names[static_cast<std::size_t>(suspicion.suspect)]}};
}

/// Zone of a night's clock; empty: unknown.
std::string zone_of(const uses::FittedNight& night, const Input& input) {
  return input.zones.empty() ? "" : input.zones[night.photographs.front()];
}

Json as_json(const uses::FittedNight& night, const Input& input) {
  Json all{{"photographs", Json::array()},
           {"response", Json()},
           {"clock", Json()},
           {"tone_curve", Json()},
           {"misfits", Json::array()}};
  if (night.response) all["response"] = *night.response;
  for (const auto i : night.photographs)
    all["photographs"].push_back(input.request.photographs[i].file);
  if (night.clock) {
    all["clock"] = {{"add_s", night.clock->seconds}, {"standard_error_s", night.clock->error_s}};
    if (const auto zone = zone_of(night, input); !zone.empty()) all["clock"]["zone"] = zone;
  }
  if (night.curve) all["tone_curve"] = components_of(*night.curve);
  for (const auto& misfit : night.misfits)
    all["misfits"].push_back({{"file", input.request.photographs[misfit.photograph].file},
                              {"channel", channel_names[misfit.channel]},
                              {"numbers", misfit.count},
                              {"chi_squared", misfit.chi_squared},
                              {"mean_log_ratio", misfit.mean},
                              {"worst_km", misfit.worst_km},
                              {"worst_log_ratio", misfit.worst}});
  return all;
}

void print_json(const Input& input, const uses::FitReport& found) {
  const auto& [fit, photographs, nights] = found;
  const auto& p = fit.posterior;
  Json all;
  for (std::size_t a = 0; a < p.estimates.size(); ++a) {
    const auto& unknown = uses::unknowns_of(fit.unknowns)[a];
    all[std::string(unknown.key)] = as_json(p.estimates[a], unknown.logarithmic);
  }
  all["correlation"] = {{"aerosol_cloud", p.correlation[0][1]},
                        {"aerosol_ozone", p.correlation[0][2]},
                        {"cloud_ozone", p.correlation[1][2]}};
  all["chi_squared"] = p.least_chi_squared;
  all["explained"] = explains(fit);
  all["numbers"] = fit.measurements;
  all["photographs"] = all["nights"] = Json::array();
  for (std::size_t i = 0; i < photographs.size(); ++i)
    all["photographs"].push_back(
        as_json(photographs[i], input.request.photographs[i].file, input.instants[i]));
  for (const auto& [file, why] : input.undated)
    all["photographs"].push_back({{"file", file}, {"instant", Json()}, {"left_out", why}});
  for (const auto& night : nights) all["nights"].push_back(as_json(night, input));
  const auto suspicion = suspicion_of(found);
  all["misfit"] = suspicion ? as_json(*suspicion, input) : Json();
  fmt::print("{}\n", all.dump(2));
}

void print_photograph(const ReadPhotograph& photograph, const std::string& file) {
  if (!photograph.left_out.empty()) {
    fmt::print("{}: left out: {}\n", one_line(file), one_line(photograph.left_out));
    return;
  }
  const auto& clipped_at = photograph.clipped_at;
  fmt::print("{}: {} numbers{}, exposure {}{}{}, correlation {:.3f}\n", one_line(file),
             photograph.measurements,
             photograph.registration.render_to_photo.mirrored ? ", mirrored" : "",
             photograph.exposure_known ? "known" : "free",
             photograph.curved ? ", by its camera's tone curve" : "",
             clipped_at ? fmt::format(", clipped at {:g}, {}", clipped_at->number,
                                      clipped_at->of_header ? "its DATAMAX" : "its greatest number")
                        : "",
             photograph.registration.correlation);
}

void print_night(const uses::FittedNight& night, const Input& input) {
  const auto& first = input.request.photographs[night.photographs.front()].file;
  const auto camera = uses::camera_of(first).value_or("camera of " + first);
  if (night.curve) fmt::print("tone curve   {} ({})\n", in_words(*night.curve), one_line(camera));
  if (night.response) fmt::print("response     {} ({})\n", *night.response, one_line(camera));
  if (!night.clock) return;
  const auto& [seconds, error_s] = *night.clock;
  const auto zone = zone_of(night, input);
  fmt::print("clock        {:+.1f} min to be added, {:.1f} to {:.1f} ({}){}\n", seconds / 60,
             (seconds - error_s) / 60, (seconds + error_s) / 60, one_line(camera),
             zone.empty()
                 ? ""
                 : fmt::format(": {:.0f} minutes from {}", std::abs(seconds) / 60, one_line(zone)));
}

void print_table(const Input& input, const uses::FitReport& found) {
  const auto& [fit, photographs, nights] = found;
  const auto& p = fit.posterior;
  for (std::size_t i = 0; i < photographs.size(); ++i)
    print_photograph(photographs[i], input.request.photographs[i].file);
  for (const auto& [file, why] : input.undated)
    fmt::print("{}: left out: {}\n", one_line(file), one_line(why));
  std::string flags;
  for (std::size_t a = 0; a < p.estimates.size(); ++a) {
    const auto& unknown = uses::unknowns_of(fit.unknowns)[a];
    const auto& estimate = p.estimates[a];
    fmt::print("{:<22} {:>9.3g}  {:.3g} to {:.3g} {}{}\n", unknown.title,
               unknown.from_axis(estimate.median), unknown.from_axis(estimate.low),
               unknown.from_axis(estimate.high), unknown.unit,
               estimate.information < no_information ? " (not determined)" : "");
    flags += fmt::format(" --{} {:.3g}", unknown.parameter, unknown.from_axis(estimate.median));
  }
  for (const auto& night : nights) print_night(night, input);
  fmt::print(
      "correlation  aerosol and cloud {:+.2f}, aerosol and ozone {:+.2f}, cloud and ozone "
      "{:+.2f}\n",
      p.correlation[0][1], p.correlation[0][2], p.correlation[1][2]);
  fmt::print("chi squared  {:.1f} of {} numbers\n", p.least_chi_squared, fit.measurements);
  fmt::print("to bake it  {}\n", flags);
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

/// Light over other light, by its logarithm: "+12 %", or "-1.3 stops" where the two differ much.
std::string ratio_in_words(double logarithm) {
  return std::abs(logarithm) < 0.5 ? fmt::format("{:+.1f} %", 100 * std::expm1(logarithm))
                                   : fmt::format("{:+.1f} stops", logarithm / std::log(2));
}

/// Options to try against a suspected reason of a misfit.
const char* remedy(uses::Suspect suspect) {
  using enum uses::Suspect;
  switch (suspect) {
    case instant:
      return "its instant (--instants), or leave it out";
    case exposure:
      return "its exposure (--times, --isos), or leave it out";
    case colours:
      return "the camera's filters (--response), its white balance (--white-balance-error), the "
             "tone "
             "curve (--coding)";
    case clock:
      return "the clock (--zone, --clock-error), the place (--at)";
    case tone_curve:
      return "the tone curve (--coding), the exposures";
    case air:
      return "another air (--atmosphere), another eclipse";
  }
  return "";
}

/// Photograph and channel that misfit most, what to try, and mirrored photographs.
std::string misfit_of(const uses::Suspicion& suspicion, const uses::FitRequest& request) {
  const auto& worst = suspicion.worst;
  auto text =
      fmt::format("worst: {} in {}, {} in the {}, {:.0f} km from the shadow's axis; try: {}",
                  request.photographs[worst.photograph].file, channel_names[worst.channel],
                  ratio_in_words(worst.worst), uses::part_of_shadow(worst.worst_km), worst.worst_km,
                  remedy(suspicion.suspect));
  for (const auto i : suspicion.mirrored)
    text += fmt::format("; mirrored: {}", request.photographs[i].file);
  return text;
}

void print_misfits(const Input& input, const uses::FitReport& found) {
  if (found.nights.empty()) return;
  if (const auto suspicion = suspicion_of(found))
    fmt::print("misfit       {}\n", one_line(misfit_of(*suspicion, input.request)));
  fmt::print("misfits      light over that of the air found; chi squared and its numbers\n");
  for (const auto& night : found.nights)
    for (const auto& misfit : night.misfits)
      fmt::print("{} {:<5} {:>11}, {} at {:.0f} km from the axis; {:.1f} of {}\n",
                 one_line(input.request.photographs[misfit.photograph].file),
                 channel_names[misfit.channel], ratio_in_words(misfit.mean),
                 ratio_in_words(misfit.worst), misfit.worst_km, misfit.chi_squared, misfit.count);
}

/// Message, in one line, for air that explains nothing.
std::string misfit_of(const uses::FitReport& found, const uses::FitRequest& request) {
  const auto& fit = found.fit;
  const auto suspicion = suspicion_of(found);
  return fmt::format(
      "no air explains this: chi squared = {:.1f} of {} numbers, allowed up to {:.1f}; {}",
      fit.posterior.least_chi_squared, fit.measurements, most_chi_squared(fit),
      suspicion ? misfit_of(*suspicion, request)
                : "likely: a list of another eclipse or of other bands, or standard errors that "
                  "are too small");
}

void run(const Options& options) {
  require_sound(options);
  const auto input = input_of(options);
  const auto found = [&] {
    ProgressBar bar("fit");
    return uses::fitted_air(input.request, bar.progress());
  }();
  if (!explains(found.fit)) {
    const auto why = misfit_of(found, input.request);
    if (!options.despite_misfit) {
      if (!options.json) print_misfits(input, found);
      throw algebra::Error(why + "; --despite-misfit answers all the same");
    }
    fmt::print(stderr, "coppermoon: {}\n", one_line(why));
  }
  std::vector<std::vector<uses::MeasuredLight>> nights;
  for (const auto& night : found.nights) nights.push_back(night.light);
  for (const auto& file : options.outputs) uses::write_measured_light(file, nights);
  std::vector<std::string> as_told;
  for (std::size_t i = 0; i < found.photographs.size(); ++i)
    if (const auto& read = found.photographs[i]; read.left_out.empty() && !read.curved)
      as_told.push_back(input.request.photographs[i].file);
  warn_of_developers(as_told, options.coding);
  for (const auto& night : found.nights)
    if (const auto doubt = night.curve ? doubt_of(*night.curve) : ""; !doubt.empty())
      fmt::print(stderr, "coppermoon: {}\n", doubt);
  if (options.json) return print_json(input, found);
  print_table(input, found);
  if (options.misfits || !explains(found.fit)) print_misfits(input, found);
}

void add_photograph_options(Verb& verb, Options& options) {
  const std::string group = "How the photographs were taken";
  const auto add = [&](const char* flag, auto& value, const char* text) -> request::Parameter& {
    return add_flag(verb, flag, value, text).in(group).only_with({{"photos"}});
  };
  add("--instants", options.instants,
      "moments of the photographs in UTC, one for all or one for each, with commas between; "
      "from-header: as the cameras' clocks say, whose errors are then found");
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
      "standard error of the logarithm of one exposure beside the night's others, 0.001 to 10")
      .within(1e-3, 10);
  add("--white-balance-error", options.request.white_balance_error,
      "standard error of red and blue over green, 0.001 to 10; default: 0.03, with a camera's own "
      "tone curve 0.3")
      .within(1e-3, 10);
  add("--weather-error", options.request.weather_error,
      "standard error of the light of 30 degrees of the Earth's limb by weather, in red in usual "
      "air, 0 to 1; "
      "default: 0.1 for a camera's own JPEGs and raw files, else 0")
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
  add_run_switch(verb, "--json", options->json, "prints one JSON document");
  on_run(verb, [options] { run(*options); });
}

}  // namespace coppermoon::verbs
