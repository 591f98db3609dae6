// SPDX-License-Identifier: MIT
#include "uses/fit/misfit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>

namespace coppermoon::uses {
namespace {

/// Least shares of the total misfit that count as most of it and as nearly all of it.
constexpr double most_of_it = 0.6, nearly_all = 0.8;

/// Distances from the shadow's axis at which the edge of the umbra begins and ends [km].
constexpr double edge_km = 4000, beyond_km = 4900;

/// Amount by which a misfit's χ² exceeds its expected value, which is the number of measurements.
double excess(const Misfit& misfit) {
  return std::max(0., misfit.chi_squared - static_cast<double>(misfit.count));
}

/// Share of the total excess of χ² that comes from the misfits that meet a condition.
double share_of(const std::vector<Misfit>& all, const std::function<bool(const Misfit&)>& chosen) {
  double sum = 0, whole = 0;
  for (const auto& misfit : all) {
    whole += excess(misfit);
    if (chosen(misfit)) sum += excess(misfit);
  }
  return whole > 0 ? sum / whole : 0;
}

/// Likely fault of the one photograph that does not fit: its exposure if all channels differ alike, else its time.
Suspect of_one_photograph(const std::vector<Misfit>& own) {
  double sum = 0, squares = 0, scatter = 0;
  for (const auto& misfit : own) {
    sum += misfit.mean;
    squares += misfit.mean * misfit.mean;
    scatter += misfit.scatter;
  }
  const auto count = static_cast<double>(own.size());
  const double mean = sum / count, between = std::sqrt(std::max(0., squares / count - mean * mean));
  return std::abs(mean) > 2 * std::hypot(between, scatter / count) ? Suspect::exposure
                                                                   : Suspect::instant;
}

/// Whether misfits vary more between photographs than within one photograph.
bool change_in_time(const std::vector<Misfit>& all) {
  std::array<double, 3> sums{}, squares{}, within{};
  std::array<int, 3> counts{};
  for (const auto& misfit : all) {
    sums[misfit.channel] += misfit.mean;
    squares[misfit.channel] += misfit.mean * misfit.mean;
    within[misfit.channel] += misfit.scatter * misfit.scatter;
    ++counts[misfit.channel];
  }
  double between = 0, of_parts = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (counts[k] == 0) continue;
    between += squares[k] - sums[k] * sums[k] / counts[k];
    of_parts += within[k];
  }
  return between > of_parts;
}

Suspect suspect_of(const std::vector<Misfit>& all, const Misfit& worst) {
  std::vector<Misfit> own;
  std::map<std::size_t, int> photographs;
  for (const auto& misfit : all) {
    ++photographs[misfit.photograph];
    if (misfit.photograph == worst.photograph) own.push_back(misfit);
  }
  const auto of_channel = [&](const Misfit& one) { return one.channel == worst.channel; };
  const auto of_worst = [&](const Misfit& one) { return one.photograph == worst.photograph; };
  if (photographs.size() > 1 && share_of(all, of_worst) > most_of_it) {
    const auto suspect = of_one_photograph(own);
    // a wrong time would change the light in all channels
    return suspect == Suspect::instant && share_of(own, of_channel) > nearly_all ? Suspect::colours
                                                                                 : suspect;
  }
  if (share_of(all, of_channel) > most_of_it) return Suspect::colours;
  const auto worst_within = [&](double from_km, double to_km) {
    return share_of(all, [&](const Misfit& one) {
             return one.worst_km >= from_km && one.worst_km < to_km;
           }) > most_of_it;
  };
  if (worst_within(edge_km, beyond_km)) return Suspect::clock;
  if (!worst_within(0, edge_km)) return Suspect::tone_curve;
  return change_in_time(all) ? Suspect::clock : Suspect::air;
}

}  // namespace

const char* part_of_shadow(double axis_distance_km) {
  if (axis_distance_km < edge_km) return "umbra";
  return axis_distance_km < beyond_km ? "edge of the umbra" : "penumbra";
}

std::optional<Suspicion> suspicion_of(const FitReport& report) {
  std::vector<Misfit> all;
  for (const auto& night : report.nights)
    all.insert(all.end(), night.misfits.begin(), night.misfits.end());
  if (all.empty() ||
      report.fit.posterior.least_chi_squared <= static_cast<double>(report.fit.measurements))
    return std::nullopt;
  const auto worst = *std::ranges::max_element(all, {}, excess);
  Suspicion result{suspect_of(all, worst), worst, {}};
  std::size_t used = 0;
  for (std::size_t i = 0; i < report.photographs.size(); ++i) {
    const auto& photograph = report.photographs[i];
    used += photograph.left_out.empty();
    if (photograph.left_out.empty() && photograph.registration.render_to_photo.mirrored)
      result.mirrored.push_back(i);
  }
  if (result.mirrored.size() == used && used > 1) result.mirrored.clear();
  return result;
}

}  // namespace coppermoon::uses
