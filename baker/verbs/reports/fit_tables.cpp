// SPDX-License-Identifier: MIT
#include "verbs/reports/fit_tables.h"

#include <fmt/format.h>

#include <cmath>

#include "uses/picture/photo_file.h"
#include "verbs/reports/in_words.h"
#include "verbs/reports/one_line.h"

namespace coppermoon::verbs {
namespace {

void print_photograph(const uses::ReadPhotograph& photograph) {
  const auto& file = photograph.file;
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

void print_night(const uses::FittedNight& night) {
  const auto camera =
      one_line(uses::camera_of(night.files.front()).value_or("camera of " + night.files.front()));
  if (night.curve) fmt::print("tone curve   {} ({})\n", in_words(*night.curve), camera);
  if (night.response) fmt::print("response     {} ({})\n", *night.response, camera);
  if (!night.clock) return;
  const auto& [seconds, error_s, zone] = *night.clock;
  fmt::print("clock        {:+.1f} min to be added, {:.1f} to {:.1f} ({}){}\n", seconds / 60,
             (seconds - error_s) / 60, (seconds + error_s) / 60, camera,
             zone.empty()
                 ? ""
                 : fmt::format(": {:.0f} minutes from {}", std::abs(seconds) / 60, one_line(zone)));
}

/// Describes a ratio of light, given its natural logarithm, as "+12 %" or, if it is large, as "-1.3 stops".
std::string ratio_in_words(double logarithm) {
  return std::abs(logarithm) < 0.5 ? fmt::format("{:+.1f} %", 100 * std::expm1(logarithm))
                                   : fmt::format("{:+.1f} stops", logarithm / std::log(2));
}

/// Advice on what to change, and with which options, if `suspect` is the likely reason for a misfit.
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

/// States the photograph and channel with the largest misfit, what to try, and which photographs are mirrored.
std::string suspicion_in_words(const uses::Suspicion& suspicion, const uses::FitReport& found) {
  const auto& worst = suspicion.worst;
  auto text =
      fmt::format("worst: {} in {}, {} in the {}, {:.0f} km from the shadow's axis; try: {}",
                  worst.file, uses::channel_named(worst.channel).word, ratio_in_words(worst.worst),
                  uses::part_of_shadow(worst.worst_km), worst.worst_km, remedy(suspicion.suspect));
  for (const auto i : suspicion.mirrored)
    text += fmt::format("; mirrored: {}", found.photographs[i].file);
  return text;
}

}  // namespace

void print_fit(const uses::FitReport& found) {
  for (const auto& photograph : found.photographs) print_photograph(photograph);
  const auto& p = found.fit.posterior;
  std::string flags;
  for (std::size_t a = 0; a < p.estimates.size(); ++a) {
    const auto& unknown = uses::unknowns_of(found.fit.unknowns)[a];
    const auto& [median, low, high, information] = in_its_unit(unknown, p.estimates[a]);
    fmt::print("{:<22} {:>9.3g}  {:.3g} to {:.3g} {}{}\n", unknown.title, median, low, high,
               unknown.unit, information < uses::told_information ? " (not determined)" : "");
    flags += fmt::format(" --{} {:.3g}", unknown.parameter, median);
  }
  for (const auto& night : found.nights) print_night(night);
  fmt::print(
      "correlation  aerosol and cloud {:+.2f}, aerosol and ozone {:+.2f}, cloud and ozone "
      "{:+.2f}\n",
      p.correlation[0][1], p.correlation[0][2], p.correlation[1][2]);
  fmt::print("chi squared  {:.1f} of {} numbers\n", p.least_chi_squared, found.fit.measurements);
  fmt::print("to bake it  {}\n", flags);
}

void print_misfits(const uses::FitReport& found) {
  if (found.nights.empty()) return;
  if (const auto suspicion = suspicion_of(found))
    fmt::print("misfit       {}\n", one_line(suspicion_in_words(*suspicion, found)));
  fmt::print("misfits      light over that of the air found; chi squared and its numbers\n");
  for (const auto& night : found.nights)
    for (const auto& misfit : night.misfits)
      fmt::print("{} {:<5} {:>11}, {} at {:.0f} km from the axis; {:.1f} of {}\n",
                 one_line(misfit.file), uses::channel_named(misfit.channel).word,
                 ratio_in_words(misfit.mean), ratio_in_words(misfit.worst), misfit.worst_km,
                 misfit.chi_squared, misfit.count);
}

std::string misfit_in_words(const uses::FitReport& found) {
  const auto& fit = found.fit;
  const auto suspicion = suspicion_of(found);
  return fmt::format(
      "no air explains this: chi squared = {:.1f} of {} numbers, allowed up to {:.1f}; {}",
      fit.posterior.least_chi_squared, fit.measurements, most_chi_squared(fit),
      suspicion ? suspicion_in_words(*suspicion, found)
                : "likely: a list of another eclipse or of other bands, or standard errors that "
                  "are too small");
}

}  // namespace coppermoon::verbs
