// SPDX-License-Identifier: MIT
#include "uses/fit/night.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>

#include "uses/fit/lit_bins.h"

namespace coppermoon::uses {
namespace {

/// The photographs of a night after they have been registered and binned.
struct Look {
  std::vector<Placed> placed;
  std::vector<Binned> binned;
};

/// Goodness of fit and misfits for the air with the least χ² on a coarse grid.
struct CoarseFit {
  GoodnessOfFit goodness{std::numeric_limits<double>::infinity()};
  std::vector<Misfit> misfits{};  ///< misfits for the air with the least χ²
};

/// Computes the light for a night's photographs, with rows in the order of NightRows.
FittedLight light_of(const FitRequest& request, std::span<const Binned> binned, const Clock& clock,
                     FittedAirs airs, const algebra::Progress& progress,
                     const std::optional<AirRange>& range = {}) {
  std::vector<LitBins> parts;
  std::vector<almanac::SkyState> skies;
  for (const auto& one : binned)
    for (const double step_s : clock_steps_s(clock.error_s)) {
      const auto told = almanac::later(request.photographs[one.photograph].instant, clock.added_s);
      skies.push_back(almanac::sky_at(almanac::later(told, step_s)));
      parts.push_back(lit_bins(*one.scene, skies.back()));
    }
  std::ranges::sort(skies, [](const auto& one, const auto& other) {
    return almanac::seconds_between(one.when, other.when) > 0;
  });
  return {request.moon.light, unknowns_of(request), skies, parts, airs, progress, range};
}

CoarseFit coarse_fit(const Stage& stage, std::span<const Binned> binned, const Clock& clock) {
  constexpr int aerosols = 16, clouds = 8;
  const auto& [aerosol, cloud, ozone] = unknowns_of(unknowns_of(stage.request));
  const auto light = light_of(stage.request, binned, clock, FittedAirs::coarse, stage.alive);
  const ComparedNight compared(binned, {clock.error_s, clock.believed_s - clock.added_s});
  const auto part = [](const Unknown& unknown, int i, int of) {
    return unknown.from_axis(std::lerp(unknown.on_axis(unknown.least),
                                       unknown.on_axis(unknown.most), static_cast<double>(i) / of));
  };
  const double mean_ozone = (ozone.least + ozone.most) / 2;
  CoarseFit fit;
  AirNumbers best{};
  for (int i = 0; i <= aerosols; ++i) {
    const double some_aerosol = part(aerosol, i, aerosols);
    const auto at = light.over_cloud(some_aerosol, mean_ozone);
    for (int j = 0; j <= clouds; ++j) {
      const double some_cloud = part(cloud, j, clouds);
      const auto found = compared.goodness(at.under(some_cloud));
      if (found.chi_squared >= fit.goodness.chi_squared) continue;
      fit.goodness = found;
      best = {some_aerosol, some_cloud, mean_ozone};
    }
  }
  fit.misfits = compared.misfits(light.at(best));
  return fit;
}

/// Leaves out the photograph whose light differs most from the others', if it differs too much.
///
/// Returned  whether a photograph was left out
bool leave_out_worst(std::span<const Reading> readings, const CoarseFit& fit, Look& look) {
  constexpr double well = 0.8, stop = std::numbers::ln2, doubtful_stops = 1, any_stops = 3;
  // judge each photograph by the channel that differs least, because a misplaced photograph differs in all channels
  std::map<std::size_t, double> off;
  for (const auto& misfit : fit.misfits) {
    const auto [known, first] = off.try_emplace(misfit.photograph, misfit.mean);
    if (std::abs(misfit.mean) < std::abs(known->second)) known->second = misfit.mean;
  }
  const auto worst =
      std::ranges::max_element(off, {}, [](const auto& one) { return std::abs(one.second); });
  if (worst == off.end()) return false;
  const auto index = look.binned[worst->first].photograph;
  auto& placed = look.placed[index];
  const auto& pose = placed.registration.render_to_photo;
  const auto unlike = std::ranges::count_if(look.binned, [&](const Binned& other) {
    return !are_turned_alike(pose, look.placed[other.photograph].registration.render_to_photo);
  });
  const bool doubtful =
      placed.registration.correlation < well || 2 * unlike > std::ssize(look.binned);
  const double stops = worst->second / stop;
  if (std::abs(stops) < (doubtful ? doubtful_stops : any_stops)) return false;
  placed = {reason_with_shares(
      readings[index].moon,
      fmt::format(
          "light {:+.1f} stops from that of the night's other photographs: a misplaced Moon "
          "(correlation {:.2f}, turned by {:.0f} degrees), or another exposure than the "
          "header's",
          stops, placed.registration.correlation, pose.rotation_rad * 180 / std::numbers::pi))};
  look.binned.erase(look.binned.begin() + static_cast<std::ptrdiff_t>(worst->first));
  return true;
}

void require_any(const FitRequest& request, std::span<const Placed> placed) {
  if (std::ranges::any_of(placed, [](const Placed& one) { return one.left_out.empty(); })) return;
  throw algebra::Error(
      fmt::format("{}: {}", request.photographs.front().file, placed.front().left_out));
}

/// Registers and bins photographs with a given clock correction, and leaves out those that would mislead the fit.
///
/// Given  fit  receives the coarse fit to the remaining photographs, or nothing if fewer than three remain
Look look_at(const Stage& stage, std::span<const Reading> readings, const Clock& clock,
             std::optional<CoarseFit>& fit) {
  constexpr std::size_t least = 3;
  std::vector<std::size_t> all(readings.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  Look look{placed(stage, readings, clock.added_s, all, Registering::of_clipped), {}};
  require_any(stage.request, look.placed);
  leave_out_far(readings, look.placed);
  look.binned = binned(readings, look.placed, {});
  for (fit.reset(); look.binned.size() >= least;) {
    fit = coarse_fit(stage, look.binned, clock);
    if (!leave_out_worst(readings, *fit, look)) break;
    fit.reset();
  }
  return look;
}

/// Improves the clock correction by comparing light, without registering the photographs again. An editor may have
/// changed light so that it leads away from where the photographs show the shadow. Then that place determines the clock.
///
/// Given  fit  coarse fit with the given clock, if known
Clock told_by_light(const Stage& stage, std::span<const Binned> binned, Clock clock,
                    std::optional<CoarseFit> fit) {
  constexpr int most_steps = 8;
  constexpr double linear_s = 60, most_s = 300;  // over linear_s, light changes linearly with time
  for (int step = 0; step < most_steps; ++step) {
    if (!fit) fit = coarse_fit(stage, binned, clock);
    const double further_s = std::clamp(fit->goodness.clock_s, -most_s, most_s);
    fit.reset();
    clock.added_s += further_s;
    if (strays(clock)) return scanned_again(clock);
    if (std::abs(further_s) < linear_s) break;
  }
  return clock;
}

/// Whether the unknown for cloud in a fit is a factor on the chance of cloud. Only then is its logarithm fitted.
bool cloud_is_a_chance(const AirFit& fit) { return unknowns_of(fit.unknowns)[1].logarithmic; }

/// Relative change in cloud that is used to compute the derivative of light.
constexpr double more_cloud = 0.1;

/// Values of the unknowns for air that has more cloud than the best air but is otherwise the same.
AirNumbers clouded_numbers(const AirFit& fit) {
  auto numbers = fit.best;
  numbers[1] = cloud_is_a_chance(fit) ? numbers[1] * (1 + more_cloud)
                                      : numbers[1] + more_cloud * (1 - numbers[1]);
  return numbers;
}

/// Relative change in aerosol that is used to compute the derivative of light.
constexpr double more_aerosol = 0.1;

bool is_curved(const Night& night) {
  return std::ranges::any_of(night.binned,
                             [](const auto& one) { return !one.light.slopes.empty(); });
}

}  // namespace

Night first_look(FitRequest request, const algebra::Progress& progress) {
  const auto groundwork = groundwork_of(request.moon, skies_of(request), request.response_assumed);
  const Stage stage{request, groundwork, [&](double) {
                      if (progress) progress(0);
                    }};
  std::vector<Reading> readings;
  for (const auto& photograph : request.photographs) {
    stage.alive(0);
    readings.push_back(reading_of(request, photograph));
  }
  auto clock = scanned_clock(stage, readings);
  std::optional<CoarseFit> fit;
  auto look = look_at(stage, readings, clock, fit);
  // a wrong clock misplaces the shadow, which shifts registrations by a tenth as much, so they are repeated
  constexpr int most_turns = 3;
  constexpr double near_s = 15;
  for (int turn = 0; clock.error_s > 0 && turn < most_turns; ++turn) {
    const double before_s = clock.added_s;
    clock = told_by_light(stage, look.binned, clock, fit);
    if (std::abs(clock.added_s - before_s) < near_s) break;
    look = look_at(stage, readings, clock, fit);
  }
  auto light = light_of(request, look.binned, clock, FittedAirs::fine, progress);
  ComparedNight compared(look.binned, {clock.error_s, clock.believed_s - clock.added_s});
  return {std::move(request),     std::move(readings),    clock,
          std::move(look.placed), std::move(look.binned), std::move(light),
          std::move(compared)};
}

Again why_again(const Night& night, const AirFit& fit, int turn) {
  constexpr int most_curves_read = 2;
  if (turn == 0) return Again::in_its_air;
  if (is_curved(night)) return turn < most_curves_read ? Again::by_its_curve : Again::no;
  return is_well_within(fit, night.light.range()) ? Again::no : Again::nearby;
}

Night looked_at_again(Night night, Again why, const AirFit& fit, const algebra::Progress& alive) {
  if (alive) alive(0);
  const auto& clock = night.clock;
  NightErrors errors{clock.error_s, clock.believed_s - clock.added_s};
  errors.expected = night.light.at(fit.best);
  errors.clouded = night.light.at(clouded_numbers(fit));
  auto dusty = fit.best;
  dusty[0] *= 1 + more_aerosol;
  errors.dusty = night.light.at(dusty);
  errors.dusty_by = std::log1p(more_aerosol);
  errors.clouded_by = cloud_is_a_chance(fit) ? std::log1p(more_cloud) : 0;
  errors.curve = night.compared.curve(errors.expected);
  errors.mixing = night.compared.mixing(errors.expected);
  const bool curved = is_curved(night);
  if (why == Again::in_its_air) {
    auto request = night.request;
    request.moon.light.air = with_unknowns(request.moon.light.air, fit.unknowns, fit.best);
    const auto groundwork =
        groundwork_of(request.moon, skies_of(request), request.response_assumed);
    night.placed = placed_again({request, groundwork, alive}, night.readings, night.placed);
  }
  night.binned = binned(night.readings, night.placed, errors.curve);
  if (!curved)
    night.light =
        light_of(night.request, night.binned, clock, FittedAirs::fine, alive, range_about(fit));
  night.compared = ComparedNight(night.binned, errors);
  return night;
}

DataSet data_of(const Night& night) {
  constexpr double of_edited = 9;  // factor on variances: editing triples standard errors
  return {night.light,
          [&compared = night.compared](const algebra::Grid<double>& light) {
            return compared.goodness(light);
          },
          night.compared.count(),
          std::ranges::any_of(night.readings, &Reading::edited) ? of_edited : 1};
}

std::vector<ReadPhotograph> photographs_of(const Night& night) {
  std::vector<ReadPhotograph> all;
  for (const auto& placed : night.placed)
    all.push_back({.registration = placed.registration, .left_out = placed.left_out});
  for (std::size_t p = 0; p < night.binned.size(); ++p) {
    const auto& binned = night.binned[p];
    auto& read = all[binned.photograph];
    read.exposure_known = binned.errors.value_per_cd_m2.has_value();
    read.measurements = night.compared.count_of(p);
    read.curved = !binned.light.slopes.empty();
    read.clipped_at = night.readings[binned.photograph].clipped_at;
  }
  return all;
}

FittedNight found_of(const Night& night, const AirFit& fit, const ClockError& clock) {
  const auto light = night.light.at(fit.best);
  FittedNight found;
  found.response = night.request.moon.response;
  found.light = night.compared.measured(light);
  found.misfits = night.compared.misfits(light);
  for (auto& misfit : found.misfits) misfit.photograph = night.binned[misfit.photograph].photograph;
  if (night.request.clock_error_s > 0)
    found.clock = ClockError{night.clock.added_s + clock.seconds, clock.error_s, {}};
  if (is_curved(night)) found.curve = night.compared.curve(light);
  return found;
}

}  // namespace coppermoon::uses
