// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <list>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

#include "algebra/error.h"
#include "verbs/camera_options.h"
#include "verbs/fit_magnitudes.h"
#include "verbs/fit_witness.h"
#include "verbs/number_list.h"
#include "verbs/one_line.h"
#include "verbs/photo_file.h"
#include "verbs/recipe.h"
#include "verbs/verbs.h"

namespace coppermoon::verbs {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::vector<std::string> photos;
  std::string instants, times, isos, magnitudes, coding = "as-file-says";
  std::optional<double> f_number;
  double exposure_error = 0.1, white_balance_error = 0.03;
  std::string camera;
  MoonOptions moon;
  ViewOptions view;
  bool despite_misfit = false, json = false;
};

/// One for each photograph, or one for all.
template <class Value>
const Value& one_of(const std::vector<Value>& values, std::size_t i) {
  return values[values.size() == 1 ? 0 : i];
}

void require_one_or(std::size_t photos, std::size_t count, const char* what) {
  if (count != 1 && count != photos)
    throw algebra::Error(fmt::format("{} {}, allowed one for all or {}, one for each photograph",
                                     count, what, photos));
}

std::vector<std::string> instants_of(const Options& options) {
  std::vector<std::string> all;
  std::istringstream parts(options.instants);
  for (std::string part; std::getline(parts, part, ',');) all.push_back(part);
  require_one_or(options.photos.size(), all.size(), "instants");
  return all;
}

/// A number that is told for each photograph; nothing when none is.
std::optional<double> told(const std::string& list, std::size_t i, std::size_t photos,
                           const char* what) {
  const auto numbers = number_list(list);
  if (!numbers)
    throw algebra::Error(fmt::format("{} = {}, allowed numbers with commas", what, list));
  if (numbers->empty()) return std::nullopt;
  require_one_or(photos, numbers->size(), what);
  return one_of(*numbers, i);
}

/// As told, else as the header says; nothing unless all of it is known.
std::optional<colour::Exposure> exposure_of(const Options& options, std::size_t i) {
  const auto exif = exif_of(options.photos[i]);
  const auto time_s = told(options.times, i, options.photos.size(), "times"),
             iso = told(options.isos, i, options.photos.size(), "ISO speeds");
  if (!exif && !(time_s && iso && options.f_number)) return std::nullopt;
  auto exposure = exif.value_or(colour::Exposure{});
  exposure.time_s = time_s.value_or(exposure.time_s);
  exposure.iso = iso.value_or(exposure.iso);
  exposure.f_number = options.f_number.value_or(exposure.f_number);
  return exposure;
}

Belief belief_of(const Options& options, std::size_t i) {
  Belief belief{{}, options.exposure_error, options.white_balance_error};
  const auto exposure = exposure_of(options, i);
  if (!exposure) return belief;
  belief.value_per_cd_m2 = colour::exposure_scale(*exposure);
  if (!options.camera.empty())
    belief.value_per_cd_m2 =
        1 / colour::saturation_cd_m2(colour::camera_named(options.camera), *exposure);
  return belief;
}

/// A photograph, as it was read.
struct Seen {
  std::string file, instant;
  colour::Registration registration;
  bool exposure_known;
  std::size_t numbers;
};

/// All that speaks of the air, for as long as it is asked.
struct Evidence {
  std::map<std::string, FitScene> scenes;  ///< by instant
  std::list<MagnitudeWitness> magnitudes;
  std::vector<Witness> witnesses;
  std::vector<Seen> seen;
};

void add_photograph(const Options& options, const std::string& instant, std::size_t i,
                    Evidence& evidence) {
  const auto& file = options.photos[i];
  const auto photo = read_photo(file, options.coding);
  const auto belief = belief_of(options, i);
  auto scene = evidence.scenes.find(instant);
  if (scene == evidence.scenes.end()) {
    auto moon = options.moon;
    moon.instant = instant;
    scene = evidence.scenes.emplace(instant, fit_scene(moon, options.view)).first;
  }
  try {
    const auto photograph = binned(scene->second, photo);
    evidence.witnesses.push_back(witness_of(scene->second, photograph, belief));
    evidence.seen.push_back({file, instant, photograph.registration,
                             belief.value_per_cd_m2.has_value(), evidence.witnesses.back().count});
  } catch (const algebra::Error& error) {
    throw algebra::Error(fmt::format("{}: {}", file, error.what()));
  }
}

void add_magnitudes(const Options& options, Evidence& evidence) {
  std::map<std::string, std::vector<MeasuredMagnitude>> by_instant;
  for (const auto& measured : read_magnitudes(options.magnitudes))
    by_instant[measured.instant].push_back(measured);
  for (const auto& [instant, measured] : by_instant) {
    auto moon = options.moon;
    moon.instant = instant;
    evidence.magnitudes.push_back(witness_of(moon, measured));
    evidence.witnesses.push_back(evidence.magnitudes.back().witness);
  }
}

Evidence evidence_of(const Options& options) {
  Evidence evidence;
  if (!options.photos.empty()) {
    const auto instants = instants_of(options);
    for (std::size_t i = 0; i < options.photos.size(); ++i)
      add_photograph(options, one_of(instants, i), i, evidence);
  }
  if (!options.magnitudes.empty()) add_magnitudes(options, evidence);
  if (evidence.witnesses.empty())
    throw algebra::Error("nothing to explain, allowed photographs or --magnitudes");
  return evidence;
}

/// Below this nothing was learnt: the interval is what was allowed from the start.
constexpr double told_nothing = 0.3;

Json as_json(const Estimate& estimate, bool logarithm) {
  const auto value = [&](double x) { return logarithm ? std::exp(x) : x; };
  return {{"median", value(estimate.median)},
          {"low_68", value(estimate.low)},
          {"high_68", value(estimate.high)},
          {"told", estimate.told >= told_nothing}};
}

void print_json(const Evidence& evidence, const AirFit& fit) {
  const auto& p = fit.posterior;
  Json all{{"dust_extinction_per_m", as_json(p.estimates[0], true)},
           {"cloud_cover", as_json(p.estimates[1], false)},
           {"ozone_du", as_json(p.estimates[2], false)},
           {"correlation",
            {{"dust_cloud", p.correlation[0][1]},
             {"dust_ozone", p.correlation[0][2]},
             {"cloud_ozone", p.correlation[1][2]}}},
           {"chi_squared", p.least_chi_squared},
           {"explained", explains(fit)},
           {"numbers", fit.numbers},
           {"photographs", Json::array()}};
  for (const auto& seen : evidence.seen) {
    const auto& is = seen.registration.render_to_photo;
    all["photographs"].push_back({{"file", seen.file},
                                  {"instant", seen.instant},
                                  {"numbers", seen.numbers},
                                  {"exposure_known", seen.exposure_known},
                                  {"mirrored", is.mirrored},
                                  {"correlation", seen.registration.correlation}});
  }
  fmt::print("{}\n", all.dump(2));
}

void print_table(const Evidence& evidence, const AirFit& fit) {
  const auto& p = fit.posterior;
  for (const auto& seen : evidence.seen)
    fmt::print("{}: {} numbers{}, exposure {}, correlation {:.3f}\n", one_line(seen.file),
               seen.numbers, seen.registration.render_to_photo.mirrored ? ", mirrored" : "",
               seen.exposure_known ? "known" : "free", seen.registration.correlation);
  const auto print = [](const char* name, const Estimate& e, bool logarithm, const char* unit) {
    const auto value = [&](double x) { return logarithm ? std::exp(x) : x; };
    fmt::print("{:<12} {:>9.3g}  {:.3g} to {:.3g} {}{}\n", name, value(e.median), value(e.low),
               value(e.high), unit, e.told < told_nothing ? " (nothing told)" : "");
  };
  print("dust", p.estimates[0], true, "1/m");
  print("cloud cover", p.estimates[1], false, "");
  print("ozone", p.estimates[2], false, "DU");
  fmt::print(
      "correlation  dust and cloud {:+.2f}, dust and ozone {:+.2f}, cloud and ozone {:+.2f}\n",
      p.correlation[0][1], p.correlation[0][2], p.correlation[1][2]);
  fmt::print("chi squared  {:.1f} of {} numbers\n", p.least_chi_squared, fit.numbers);
}

void require_sound(const Options& options) {
  algebra::require_within("exposure error", options.exposure_error, 1e-3, 10);
  algebra::require_within("white balance error", options.white_balance_error, 1e-3, 10);
  if (!options.camera.empty()) colour::camera_named(options.camera);
  if (!options.photos.empty() && options.instants.empty())
    throw algebra::Error("photographs: allowed with --instants, when they were taken (UTC)");
}

/// In one line.
std::string misfit_of(const Evidence& evidence, const AirFit& fit) {
  std::string why = "a list of another eclipse or of other bands, or errors told too small";
  if (!evidence.seen.empty()) {
    why = "a tone curve (--coding), another instant, another eclipse or place";
    if (std::ranges::any_of(evidence.seen, [](const Seen& seen) {
          return seen.registration.render_to_photo.mirrored;
        }))
      why += ", a mirrored photograph";
  }
  return fmt::format(
      "no air explains this: chi squared = {:.1f} of {} numbers, allowed up to {:.1f}; likely: {}",
      fit.posterior.least_chi_squared, fit.numbers, most_chi_squared(fit), why);
}

void run(const Options& options) {
  require_sound(options);
  const auto evidence = evidence_of(options);
  const auto fit = fitted_air(evidence.witnesses);
  if (!explains(fit)) {
    if (!options.despite_misfit)
      throw algebra::Error(misfit_of(evidence, fit) + "; --despite-misfit answers all the same");
    fmt::print(stderr, "coppermoon: {}\n", one_line(misfit_of(evidence, fit)));
  }
  options.json ? print_json(evidence, fit) : print_table(evidence, fit);
}

void add_belief_options(CLI::App& verb, Options& options) {
  const std::string group = "How the photographs were taken";
  const auto add = [&](const char* flag, auto& value, const char* text) {
    return add_flag(verb, flag, value, text).in(group);
  };
  add("--instants", options.instants, "UTC, one for all or one for each, with commas between");
  add("--times", options.times, "exposure times [s], the same; without: the header's");
  add("--isos", options.isos, "ISO speeds, the same; without: the header's");
  add("--f-number", options.f_number, "without: the header's");
  add("--camera", options.camera, "whose saturation is meant; without: as ISO 12232 has it");
  add("--exposure-error", options.exposure_error, "standard, of its logarithm");
  add("--white-balance-error", options.white_balance_error, "standard, of red and blue over green");
  add("--coding", options.coding, "as-file-says, srgb or linear")
      .one_of({"as-file-says", "srgb", "linear"});
}

}  // namespace

void add_fit(CLI::App& program) {
  auto* verb =
      add_verb(program, "fit",
               "The dust, cloud and ozone that photographs or magnitudes of an eclipse tell of");
  const auto options = std::make_shared<Options>();
  add_flag(*verb, "photos,--photos", options->photos, "any images of eclipsed Moons").reads_file();
  add_flag(*verb, "--magnitudes", options->magnitudes,
           "a list of the whole Moon's, .csv: instant,band,magnitude,error")
      .reads_file();
  add_belief_options(*verb, *options);
  add_film_moon_options(*verb, options->moon);
  add_view_options(*verb, options->view);
  for (const char* not_asked :
       {"--dust-extinction", "--cloud-cover", "--ozone-du",   "--danjon", "--region",
        "--unshadowed",      "--width",       "--height",     "--field",  "--focal-length",
        "--sensor-width",    "--up",          "--flattening", "--solver", "--trace",
        "--photons",         "--shard",       "--keep",       "--add",    "--texture-width"})
    remove_flag(*verb, not_asked);
  add_switch(*verb, "--despite-misfit", options->despite_misfit,
             "answer although no air explains what was seen: a warning, no error");
  add_switch(*verb, "--json", options->json, "one JSON document on stdout");
  add_recipe_option(*verb);
  on_run(*verb, [options] { run(*options); });
}

}  // namespace coppermoon::verbs
