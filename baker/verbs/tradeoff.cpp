// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

#include "algebra/error.h"
#include "almanac/instant.h"
#include "almanac/sky.h"
#include "files/own_file.h"
#include "files/whole_file.h"
#include "result/as_json.h"
#include "uses/light/light_parameters.h"
#include "uses/plot/plot.h"
#include "uses/tradeoff/runs.h"
#include "uses/tradeoff/sweeps.h"
#include "uses/tradeoff/tradeoff_files.h"
#include "uses/tradeoff/yardstick.h"
#include "verbs/command_line.h"
#include "verbs/reports/one_line.h"
#include "verbs/reports/progress_bar.h"

namespace coppermoon::verbs {
namespace of_tradeoff {
namespace {

using uses::Measured, uses::ReferenceSettings;

struct Options {
  std::string instant = "2008-02-21T03:26:05Z", output;
  uses::MoonRequest moon;
  std::vector<std::string> only;
  std::optional<double> longest_s;
  int repeat = 1;
  bool quick = false, json = false;
};

uses::MeasuredScene scene_of(const Options& options) {
  return measured_scene(options.moon, almanac::sky_at(almanac::instant_from_utc(options.instant)));
}

std::vector<uses::Sweep> sweeps_for(const Options& options, const atmosphere::Atmosphere& air) {
  const double replicas = air.symmetric() ? uses::most_replicas : uses::most_replicas / 2;
  return sweeps_of(options.only, uses::sweeps(options.quick, replicas));
}

uses::RunLimits limits_of(const Options& options) {
  auto limits = options.quick ? uses::quick_limits : uses::RunLimits{};
  limits.longest_s = options.longest_s.value_or(limits.longest_s);
  limits.repeat = options.repeat;
  return limits;
}

constexpr std::string_view left_out_by_quick =
    "With `--quick` settings are few and small, every run of 0.1 s or more is timed once, and the "
    "reference is coarser: its\nown error is a ninth of that of 300 rays, and a twentieth of that "
    "of 40 bands, or less.\n\n";

std::string document(const Options& options, const ReferenceSettings& reference,
                     std::span<const Measured> all) {
  return fmt::format(
      "Made by `coppermoon tradeoff {}{}`: what each method takes at each setting, and how far its "
      "light is from the\nreference, the quadrature of {} rays and {} bands every {:g} km.\n\n"
      "Irradiance counts as the eye sees it, errors relative to all light at the place, refracted "
      "and direct: root mean square\nover the area, and the worst place, within 4500 km of the "
      "axis "
      "(umbra) and beyond (penumbra). Photons are gathered in rings\nof 50 km and 1000 / replicas "
      "sectors, and each such cell is compared. The picture: CIEDE2000 over the Moon's disc,\n"
      "developed at the exposure that suits the reference's.\n\n"
      "Steps are in km; their own error hides under the noise of so few photons. Seconds include "
      "the "
      "making of tables; those of\na texture's width are the bake's alone, and its ΔE that against "
      "the widest texture. Extrapolated: time on a straight line\nover the number of photons and "
      "of "
      "steps, errors as "
      "N^(−1/2); a ΔE extrapolated from more than 10 is too small, by up to two times.\n\n{}{}",
      options.instant, options.quick ? " --quick" : "", reference.rays, reference.bands,
      reference.spacing_m / 1e3, options.quick ? left_out_by_quick : "", as_markdown(all));
}

void write_files(const std::filesystem::path& folder, const Options& options,
                 const ReferenceSettings& reference, std::span<const Measured> all) {
  files::write_whole(folder / "tradeoff.csv", result::as_csv(all));
  files::write_whole(folder / "tradeoff.md", document(options, reference, all));
  uses::write_plot(folder / "tradeoff.svg", as_plot(all));
}

/// Writes the results into the output folder. A missing folder is created, and removed again if writing fails.
void write_folder(const Options& options, const ReferenceSettings& reference,
                  std::span<const Measured> all) {
  std::error_code ignored;
  const bool made = std::filesystem::create_directory(options.output, ignored);
  try {
    write_files(options.output, options, reference, all);
  } catch (...) {
    if (made) std::filesystem::remove(options.output, ignored);
    throw;
  }
}

/// Throws if writing into the folder would follow a link or replace a file that this command did not make.
void require_own_files(const std::filesystem::path& folder) {
  const auto text = folder / "tradeoff.md";
  const bool ours = std::filesystem::exists(text) &&
                    files::beginning_of(text, 64).starts_with("Made by `coppermoon tradeoff");
  for (const char* name : {"tradeoff.csv", "tradeoff.md", "tradeoff.svg"}) {
    files::require_no_link(folder / name);
    if (!ours && std::filesystem::exists(folder / name))
      throw algebra::Error(files::not_as_written(folder / name));
  }
}

void require_sound(const Options& options) {
  if (options.longest_s) algebra::require_within("longest run [s]", *options.longest_s, 0, 1e6);
  algebra::require_within("repeat", options.repeat, 1, 100);
  if (std::filesystem::is_directory(options.output)) return require_own_files(options.output);
  files::require_place_for(options.output);
  if (std::filesystem::exists(options.output))
    throw algebra::Error(fmt::format("{}: is not a directory", options.output));
}

void run(const Options& options) {
  require_sound(options);
  const auto scene = scene_of(options);
  const auto chosen = sweeps_for(options, scene.air);
  const auto reference = options.quick ? uses::quick_reference : ReferenceSettings{};
  auto yardstick = [&] {
    ProgressBar bar("reference");
    return uses::Yardstick(scene, reference, bar.progress());
  }();
  const auto all = [&] {
    ProgressBar bar("tradeoff");
    return uses::measured_trials(chosen, yardstick, limits_of(options), bar.progress());
  }();
  write_folder(options, reference, all);
  if (options.json)
    fmt::print("{}\n", result::json_of(all, {}).dump(2));
  else
    fmt::print("{}: tradeoff.csv, tradeoff.md, tradeoff.svg, {} rows\n", one_line(options.output),
               all.size());
}

}  // namespace
}  // namespace of_tradeoff

void add_tradeoff(Program& program) {
  using namespace of_tradeoff;
  auto& verb =
      add_verb(program, "tradeoff", "measures speed against accuracy for every method and setting");
  const auto options = std::make_shared<Options>();
  add_flag(verb, "instant,--instant", options->instant, "moment in UTC of the scene that is lit");
  add_flag(verb, "-o,--output", options->output,
           "folder for tradeoff.csv, tradeoff.md and tradeoff.svg")
      .writes_folder()
      .required();
  add_flag(verb, "--only", options->only, "method to measure alone. May be given again")
      .one_of(uses::solver_names());
  add_flag(
      verb, "--longest", options->longest_s,
      "longest time of one run [s], 0 to 1e6, usually 20, with --quick 3; a row that would take "
      "longer is extrapolated")
      .within(0, 1e6);
  add_flag(
      verb, "--repeat", options->repeat,
      "number of runs, 1 to 100; the shortest counts. Runs under a second, with --quick under 0.1 "
      "s, are made three times or more")
      .within(1, 100);
  add_switch(verb, "--quick", options->quick,
             "measures few and small settings, against a coarser reference: ten seconds of one "
             "processor");
  add_flag(verb, "--albedo-map", options->moon.albedo_map,
           "albedo map: an image of 2:1 with longitude 0 in the middle, or built-in")
      .reads_file();
  add_json_switch(verb, options->json, {result::fields_of_each<Measured>});
  add_described(verb, options->moon.light.air);
  on_run(verb, [options] { run(*options); });
}

}  // namespace coppermoon::verbs
