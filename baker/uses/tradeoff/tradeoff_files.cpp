// SPDX-License-Identifier: MIT
#include "uses/tradeoff/tradeoff_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace coppermoon::uses {
namespace {

/// A number as text. Numbers from 10000 on are written in the form 1e4.
std::string number(double value) {
  if (value < 1e4) return fmt::format("{:g}", value);
  const double power = std::floor(std::log10(value));
  return fmt::format("{:.3g}e{:g}", value / std::pow(10, power), power);
}

/// A trial's settings in words, except for the one that its sweep varies.
std::string settings_in_words(const Measured& one) {
  std::string text;
  for (auto [name, value] : settings_of(one.trial)) {
    std::ranges::replace(name, '_', ' ');
    if (!value || name.starts_with(one.varied)) continue;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name, number(*value));
  }
  return text;
}

std::string percent(double part) {
  return part < 1 ? fmt::format("{:.3g} %", 100 * part) : fmt::format("{:.0f} %", 100 * part);
}

/// The trials that belong to the first sweep.
std::span<const Measured> first_sweep(std::span<const Measured> all) {
  const auto end = std::ranges::find_if(all, [&](const Measured& one) {
    return one.varied != all[0].varied || one.trial.solver != all[0].trial.solver;
  });
  return all.first(static_cast<std::size_t>(end - all.begin()));
}

constexpr std::string_view colour_of(plan::Solver solver) {
  constexpr std::array<std::string_view, plan::solvers.size()> colours{"#0072b2", "#d55e00",
                                                                       "#6a3d9a"};
  return colours[static_cast<std::size_t>(solver)];
}

/// gnuplot's number for the filled symbol that marks a sweep. The number of the matching open symbol is one less.
int symbol_of(std::string_view varied) {
  constexpr std::array<std::string_view, 5> filled{"rays", "photons", "wavelengths", "replicas",
                                                   "step"};
  return 5 + 2 * static_cast<int>(std::ranges::find(filled, varied) - filled.begin());
}

bool is_the_papers(const Trial& trial) {
  return trial.solver == plan::Solver::literal && trial.photons == 1e7 && trial.step_km == 1 &&
         trial.wavelengths == 200 && trial.replicas == 100;
}

using Which = bool (*)(const Measured&);

/// The trials that `which` selects, as rows of three numbers: seconds, error, and value of the varied setting.
std::string rows_of(std::span<const Measured> all, Which which) {
  std::string rows;
  for (const auto& one : all)
    if (which(one) && one.seconds > 0 && one.errors.umbra.rms > 0)
      rows +=
          fmt::format("{:.4g},{:.4g},{}\n", one.seconds, one.errors.umbra.rms, number(one.value));
  return rows;
}

/// Whether two points are far enough apart on the plot to label both.
bool apart(const Measured& one, const Measured& other) {
  const auto differ = [](double a, double b) { return std::max(a, b) > 4 * std::min(a, b); };
  return differ(one.seconds, other.seconds) || differ(one.errors.umbra.rms, other.errors.umbra.rms);
}

/// Adds a curve to a plot's curves unless it has no rows.
void add(std::vector<PlotCurve>& curves, PlotCurve curve) {
  if (!curve.rows.empty()) curves.push_back(std::move(curve));
}

void add_sweep(std::vector<PlotCurve>& curves, std::span<const Measured> sweep) {
  const auto& one = sweep[0];
  const auto look = [&](std::string_view as) {
    return fmt::format("{} lc rgb '{}'", as, colour_of(one.trial.solver));
  };
  const int symbol = symbol_of(one.varied);
  const Which every = [](const Measured&) { return true; };
  add(curves, {rows_of(sweep, every), look("lines")});
  add(curves, {rows_of(sweep, [](const Measured& of) { return !of.extrapolated; }),
               look(fmt::format("points ps 0.9 pt {}", symbol)),
               fmt::format("{}: {}", name(one.trial.solver), one.varied)});
  add(curves, {rows_of(sweep, [](const Measured& of) { return of.extrapolated; }),
               look(fmt::format("points ps 0.9 pt {}", symbol - 1))});
  if (apart(sweep.front(), sweep.back()))
    add(curves,
        {rows_of(std::array{sweep.front(), sweep.back()}, every),
         fmt::format("labels offset 0,0.8 font ',9' tc rgb '{}'", colour_of(one.trial.solver))});
}

}  // namespace

std::string as_markdown(std::span<const Measured> all) {
  std::string text =
      "| solver | varied | value | settings | seconds | umbra, RMS | worst | penumbra, RMS | worst "
      "| "
      "ΔE mean | 99 % | |\n"
      "| --- | --- | ---: | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | --- |\n";
  for (const auto& one : all)
    text +=
        fmt::format("| {} | {} | {} | {} | {:.3g} | {} | {} | {} | {} | {:.3g} | {:.3g} | {} |\n",
                    name(one.trial.solver), one.varied, number(one.value), settings_in_words(one),
                    one.seconds, percent(one.errors.umbra.rms), percent(one.errors.umbra.worst),
                    percent(one.errors.penumbra.rms), percent(one.errors.penumbra.worst),
                    one.errors.picture.mean, one.errors.picture.percentile_99,
                    one.extrapolated ? "extrapolated" : "");
  return text;
}

Plot as_plot(std::span<const Measured> all) {
  std::vector<PlotCurve> curves;
  while (!all.empty()) {
    const auto sweep = first_sweep(all);
    if (sweep[0].varied != texture_sweep) add_sweep(curves, sweep);
    if (sweep[0].varied == "photons")
      add(curves, {rows_of(sweep, [](const Measured& one) { return is_the_papers(one.trial); }),
                   "points pt 3 ps 2 lc rgb 'black'", "Yapo and Cutler (2009)"});
    all = all.subspan(sweep.size());
  }
  curves.push_back({"", "points pt 6 ps 0.9 lc rgb 'black'", "open: extrapolated"});
  const char* error = "relative error of irradiance in the umbra, RMS";
  return {.width = 1100,
          .height = 680,
          .x = {.label = "seconds", .logarithmic = true},
          .panels = {{{.label = error, .logarithmic = true}, std::move(curves)}},
          .key = "outside right top Left reverse",
          .grid = "lt 1 lc rgb '#dddddd'",
          .margin = 0.03};
}

}  // namespace coppermoon::uses
