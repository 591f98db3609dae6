// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <memory>

#include "algebra/error.h"
#include "result/as_json.h"
#include "uses/fit/fit_results.h"
#include "uses/fit/measured_light.h"
#include "uses/picture/photo_file.h"
#include "uses/picture/picture_parameters.h"
#include "verbs/command_line.h"
#include "verbs/fit_input.h"
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
      "moments of the photographs in UTC, also as 2018-07-27 U1+40min, one for all or one for "
      "each, with commas between; from-header: as GPS says, or else the cameras' clocks, whose "
      "errors are then found");
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
