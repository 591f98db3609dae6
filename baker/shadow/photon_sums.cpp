// SPDX-License-Identifier: MIT
#include "shadow/photon_sums.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>

#include "algebra/error.h"

namespace coppermoon::shadow {
namespace {

bool alike(const PhotonSums& a, const PhotonSums& b) {
  return a.key == b.key && a.arrangement.sun_distance_m == b.arrangement.sun_distance_m &&
         a.arrangement.depths_m == b.arrangement.depths_m &&
         a.arrangement.limb_darkening == b.arrangement.limb_darkening &&
         a.wavelengths_nm == b.wavelengths_nm && a.ring_width_m == b.ring_width_m &&
         a.rings == b.rings && a.all_wavelengths == b.all_wavelengths && a.sectors == b.sectors;
}

/// Union of two lists of ranges of blocks, in order, with adjacent ranges joined.
std::vector<BlockRange> united(std::vector<BlockRange> ranges,
                               const std::vector<BlockRange>& more) {
  ranges.insert(ranges.end(), more.begin(), more.end());
  std::sort(ranges.begin(), ranges.end(), [](auto a, auto b) { return a.from < b.from; });
  std::vector<BlockRange> all;
  for (const auto& range : ranges) {
    if (range.from == range.to) continue;
    if (!all.empty() && range.from < all.back().to)
      throw algebra::Error(fmt::format("photons of blocks {} to {} are in both, allowed in one",
                                       range.from, std::min(range.to, all.back().to) - 1));
    if (!all.empty() && range.from == all.back().to)
      all.back().to = range.to;
    else
      all.push_back(range);
  }
  return all;
}

using Grids = std::vector<algebra::Grid<double>>;

/// Adds y to x + rest with compensated summation, where `rest` holds the digits that do not fit into x.
///
/// Source  Knuth (1998), The Art of Computer Programming 2, 4.2.2, theorem B
void add(double& x, double& rest, double y) {
  const double sum = x + y, of_y = sum - x;
  rest += (x - (sum - of_y)) + (y - of_y);
  x = sum + rest;
  rest -= x - sum;
}

void add(Grids& grids, Grids& rests, const Grids& more, const Grids& more_rests) {
  if (rests.empty())
    for (const auto& grid : grids) rests.emplace_back(grid.rows(), grid.columns());
  for (std::size_t g = 0; g < grids.size(); ++g)
    for (std::size_t i = 0; i < grids[g].values().size(); ++i) {
      double& rest = rests[g].values()[i];
      if (!more_rests.empty()) rest += more_rests[g].values()[i];
      add(grids[g].values()[i], rest, more[g].values()[i]);
    }
}

/// Ratio of a cell's irradiance to unshaded sunlight, if the cell receives as much light as 1 m² in unshaded sunlight.
double ratio_per_m2(const PhotonSums& sums, double depth_m, std::size_t ring) {
  const double spread = 1 + depth_m / sums.arrangement.sun_distance_m;
  const double area_m2 = std::numbers::pi * sums.ring_width_m * sums.ring_width_m *
                         (2 * static_cast<double>(ring) + 1) / static_cast<double>(sums.sectors);
  return spread * spread / area_m2;
}

/// Turns sums over blocks of photons, and the sums of squares, into means and their standard errors, in place.
void become_estimates(std::span<double> sums, std::span<double> squares, double scale,
                      double blocks) {
  for (std::size_t w = 0; w < sums.size(); ++w) {
    // FAULT the variance of photons: - mean * mean; => - mean;
    const double mean = sums[w] / blocks, variance = squares[w] / blocks - mean * mean;
    sums[w] = scale * mean;
    squares[w] = blocks < static_cast<double>(blocks_for_an_error)
                     ? sums[w]
                     : scale * std::sqrt(std::max(0., variance) / (blocks - 1));
  }
}

/// Limits for using a ring as a neighbour: its relative noise, and the logarithm of the ratio of the two rings' light.
constexpr double known_well = 1. / 3, steepest = 4;

/// Mean light of a ring at one wavelength, and its noise.
struct RingLight {
  double log_mean = 0, relative_noise = 0;
  bool known = false;
};

RingLight ring_light(double mean, double noise) {
  if (!(mean > 0 && noise <= known_well * mean)) return {};
  return {std::log(mean), noise / mean, true};
}

/// Number of rings added at either end of a sector's list of rings. Those added before the first ring belong to the
/// opposite sector, across the axis. Those added after the last ring count as unknown.
constexpr std::size_t beyond = 2;

void fill_line(const RefractedLight& means, std::size_t grid, std::size_t wave,
               std::vector<RingLight>& line) {
  const std::size_t sector = grid % means.sectors,
                    across = grid - sector + Sectors{means.sectors}.opposite(sector);
  const auto ring = [&](std::size_t g, std::size_t r) {
    return ring_light(means.ratio[g](r, wave), means.standard_error[g](r, wave));
  };
  const std::size_t rings = means.axis_distances_m.size();
  line.assign(rings + 2 * beyond, {});
  for (std::size_t k = 0; k < std::min(beyond, rings); ++k) line[beyond - 1 - k] = ring(across, k);
  for (std::size_t r = 0; r < rings; ++r) line[beyond + r] = ring(grid, r);
}

/// Whether a fit to ln(light) may join two rings: both are known, and their light differs by a factor of e⁴ at most.
bool linked(const RingLight& a, const RingLight& b) {
  return a.known && b.known && std::abs(a.log_mean - b.log_mean) <= steepest;
}

/// Slope and curvature of the light's logarithm at a ring's middle, in units of the ring's width.
struct LogShape {
  double slope = 0, curvature = 0;
};

LogShape log_shape(std::span<const RingLight> line, std::span<const double> logs, std::size_t i) {
  const bool inner = linked(line[i - 1], line[i]), outer = linked(line[i], line[i + 1]);
  const double inward = logs[i] - logs[i - 1], outward = logs[i + 1] - logs[i];
  if (inner && outer) return {(inward + outward) / 2, outward - inward};
  if (inner) return {inward, 0};
  return {outer ? outward : 0, 0};
}

/// Ratio of the mean over a ring's area to the light at its middle, computed with three Gauss nodes.
///
/// Given  steepening  h/r: the ring's width divided by the axis distance of its middle
double mean_over_middle(LogShape shape, double steepening) {
  const double at = std::sqrt(0.15), rise = std::exp(shape.slope * at),
               bend = std::exp(shape.curvature * at * at / 2);
  return 4. / 9 + 5. / 18 * bend * ((1 + steepening * at) * rise + (1 - steepening * at) / rise);
}

/// Finds the logarithms of the light at the rings' middles by fixed-point iteration.
void deconvolve(std::span<const RingLight> line, std::vector<double>& logs) {
  logs.resize(line.size());
  for (std::size_t i = 0; i < line.size(); ++i) logs[i] = line[i].log_mean;
  constexpr int passes = 4;  // each pass leaves 0.1 of the error, or 0.3 on the steepest slope
  std::vector<double> next = logs;
  for (int pass = 0; pass < passes; ++pass) {
    for (std::size_t i = beyond; i + beyond < line.size(); ++i) {
      const double steepening = 1 / (static_cast<double>(i - beyond) + 0.5);
      next[i] = line[i].log_mean - std::log(mean_over_middle(log_shape(line, logs, i), steepening));
    }
    // Rings on the far side of the axis get the same correction, from mean to middle, as their mirror images.
    for (std::size_t k = 0; k < beyond; ++k)
      next[beyond - 1 - k] =
          line[beyond - 1 - k].log_mean + next[beyond + k] - line[beyond + k].log_mean;
    logs.swap(next);
  }
}

/// Square of the fourth difference of ln(light) about a ring, minus the value expected from noise alone. Empty if the
/// five rings are not all neighbours.
std::optional<double> fourth_difference_squared(std::span<const RingLight> line, std::size_t i) {
  constexpr std::array<double, 5> weights{1, -4, 6, -4, 1};
  double difference = 0, variance = 0;
  for (std::size_t k = 0; k < weights.size(); ++k) {
    const auto& ring = line[i + k - beyond];
    if (k > 0 && !linked(line[i + k - beyond - 1], ring)) return std::nullopt;
    difference += weights[k] * ring.log_mean;
    variance += std::pow(weights[k] * ring.relative_noise, 2);
  }
  return difference * difference - variance;
}

/// Relative error due to unresolved structure of the light at and near a ring's middle. The squares of fourth
/// differences at the neighbouring rings count half, because these differences change sign about a kink.
double unresolved(std::span<const RingLight> line, double log_light, std::size_t i) {
  const auto own = fourth_difference_squared(line, i);
  if (!own) return std::abs(std::expm1(line[i].log_mean - log_light));
  double sum = *own;
  for (const std::size_t k : {i - 1, i + 1})
    if (k >= beyond && k + beyond < line.size())
      sum += fourth_difference_squared(line, k).value_or(0) / 2;
  return 3. / 32 * std::sqrt(std::max(0., sum));
}

/// Relative noise of the light E at a ring's middle: ln E ≈ ln M − (second difference of ln M)/24; M: rings' means.
double noise_at_middle(std::span<const RingLight> line, std::size_t i) {
  const auto of_next = [&](std::size_t k) {
    return linked(line[i], line[k]) ? line[k].relative_noise / 24 : 0;
  };
  return std::hypot(13. / 12 * line[i].relative_noise, of_next(i - 1), of_next(i + 1));
}

/// Turns the means over the rings of a sector into the light at the rings' middles, with its errors.
void become_middles(const RefractedLight& means, std::size_t grid, PhotonLight& light) {
  std::vector<RingLight> line;
  std::vector<double> logs;
  for (std::size_t w = 0; w < means.wavelengths_nm.size(); ++w) {
    fill_line(means, grid, w, line);
    deconvolve(line, logs);
    for (std::size_t r = 0; r < means.axis_distances_m.size(); ++r) {
      const std::size_t i = r + beyond;
      if (!line[i].known) continue;
      const double value = std::exp(logs[i]);
      light.ratio[grid](r, w) = value;
      light.noise[grid](r, w) = value * noise_at_middle(line, i);
      light.standard_error[grid](r, w) =
          std::hypot(light.noise[grid](r, w), value * unresolved(line, logs[i], i));
    }
  }
}

double weighted(std::span<const double> ratio, std::span<const double> weights) {
  return std::inner_product(weights.begin(), weights.end(), ratio.begin(), 0.);
}

/// Largest ratio of two standard errors of the weighted light to this light, over the rings of the rule; 1 at most.
double worst_error(const RefractedLight& light, const Grids& errors, const StoppingRule& rule) {
  double worst = 0;
  for (std::size_t g = 0; g < light.ratio.size(); ++g)
    for (std::size_t r = 0; r < light.axis_distances_m.size(); ++r) {
      const double at_m = light.axis_distances_m[r];
      if (at_m < rule.from_m || at_m > rule.to_m) continue;
      const double value = weighted(light.ratio[g].row(r), rule.weights),
                   error = combined_error(light, errors[g].row(r), rule.weights);
      worst = std::max(worst, value > 0 ? std::min(1., 2 * error / value) : 1);
    }
  return worst;
}

}  // namespace

BlockRange blocks_of(std::uint64_t photons) {
  return {0, (photons + photons_a_block - 1) / photons_a_block};
}

BlockRange shard(BlockRange blocks, std::uint64_t part, std::uint64_t parts) {
  algebra::require_within("parts of the photons", static_cast<double>(parts), 1, 1e6);
  algebra::require_within("part of the photons", static_cast<double>(part), 1,
                          static_cast<double>(parts));
  const std::uint64_t count = blocks.to - blocks.from, each = count / parts, left = count % parts;
  const auto first = [&](std::uint64_t k) { return blocks.from + k * each + std::min(k, left); };
  return {first(part - 1), first(part)};
}

std::uint64_t blocks_in(const std::vector<BlockRange>& ranges) {
  std::uint64_t count = 0;
  for (const auto& range : ranges) count += range.to - range.from;
  return count;
}

std::vector<BlockRange> missing(const PhotonSums& sums, BlockRange blocks) {
  std::vector<BlockRange> gaps;
  std::uint64_t next = blocks.from;
  for (const auto& range : sums.done) {
    if (range.to <= next || range.from >= blocks.to) continue;
    if (range.from > next) gaps.push_back({next, range.from});
    next = range.to;
  }
  if (next < blocks.to) gaps.push_back({next, blocks.to});
  return gaps;
}

PhotonSums merged(PhotonSums a, const PhotonSums& b) {
  if (!alike(a, b))
    throw algebra::Error(
        "photons of different scenes, allowed those of one: the same air, "
        "distances, wavelengths, rings and seed");
  a.done = united(std::move(a.done), b.done);
  add(a.sum, a.sum_rest, b.sum, b.sum_rest);
  add(a.sum_of_squares, a.sum_of_squares_rest, b.sum_of_squares, b.sum_of_squares_rest);
  return a;
}

RefractedLight means_over_rings(const PhotonSums& sums) {
  std::vector<double> middles_m;
  for (std::size_t r = 0; r < sums.rings; ++r)
    middles_m.push_back((static_cast<double>(r) + 0.5) * sums.ring_width_m);
  const std::uint64_t blocks = blocks_in(sums.done);
  auto light = darkness(sums.arrangement, sums.wavelengths_nm, middles_m, sums.sectors);
  light.standard_error = light.ratio;
  light.photons = blocks * photons_a_block;
  light.errors_correlated = sums.all_wavelengths;
  if (blocks == 0) return light;
  light.ratio = sums.sum;
  light.standard_error = sums.sum_of_squares;
  for (std::size_t g = 0; g < light.ratio.size(); ++g)
    for (std::size_t r = 0; r < sums.rings; ++r)
      become_estimates(light.ratio[g].row(r), light.standard_error[g].row(r),
                       ratio_per_m2(sums, sums.arrangement.depths_m[g / sums.sectors], r) /
                           static_cast<double>(photons_a_block),
                       static_cast<double>(blocks));
  return light;
}

PhotonLight estimated(const PhotonSums& sums) {
  const auto means = means_over_rings(sums);
  PhotonLight light{means, means.standard_error};
  tbb::parallel_for(std::size_t{0}, means.ratio.size(),
                    [&](std::size_t grid) { become_middles(means, grid, light); });
  return light;
}

double worst_error(const PhotonLight& light, const StoppingRule& rule) {
  return worst_error(light, light.noise, rule);
}

double worst_error(const RefractedLight& light, const StoppingRule& rule) {
  return worst_error(light, light.standard_error, rule);
}

}  // namespace coppermoon::shadow
