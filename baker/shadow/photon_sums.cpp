// SPDX-License-Identifier: MIT
#include "shadow/photon_sums.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

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

/// In order, those that touch made one.
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

/// Adds y to x + rest, and keeps what x has no digits for in the rest.
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

/// Irradiance ratio in a cell of a ring that a square metre of sunlight makes.
double ratio_per_m2(const PhotonSums& sums, double depth_m, std::size_t ring) {
  const double spread = 1 + depth_m / sums.arrangement.sun_distance_m;
  const double area_m2 = std::numbers::pi * sums.ring_width_m * sums.ring_width_m *
                         (2 * static_cast<double>(ring) + 1) / static_cast<double>(sums.sectors);
  return spread * spread / area_m2;
}

/// Sums over blocks and of their squares become a mean and its standard error.
void become_estimates(std::span<double> sums, std::span<double> squares, double scale,
                      double blocks) {
  for (std::size_t w = 0; w < sums.size(); ++w) {
    const double mean = sums[w] / blocks, variance = squares[w] / blocks - mean * mean;
    sums[w] = scale * mean;
    squares[w] = blocks < static_cast<double>(blocks_for_an_error)
                     ? sums[w]
                     : scale * std::sqrt(std::max(0., variance) / (blocks - 1));
  }
}

double weighted(std::span<const double> ratio, std::span<const double> weights) {
  return std::inner_product(weights.begin(), weights.end(), ratio.begin(), 0.);
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

RefractedLight estimated(const PhotonSums& sums) {
  std::vector<double> middles_m;
  for (std::size_t r = 0; r < sums.rings; ++r)
    middles_m.push_back((static_cast<double>(r) + 0.5) * sums.ring_width_m);
  const std::uint64_t blocks = blocks_in(sums.done);
  auto light = darkness(sums.arrangement, sums.wavelengths_nm, middles_m, sums.sectors);
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

double worst_error(const RefractedLight& light, const StoppingRule& rule) {
  double worst = 0;
  for (std::size_t g = 0; g < light.ratio.size(); ++g)
    for (std::size_t r = 0; r < light.axis_distances_m.size(); ++r) {
      const double at_m = light.axis_distances_m[r];
      if (at_m < rule.from_m || at_m > rule.to_m) continue;
      const double value = weighted(light.ratio[g].row(r), rule.weights),
                   error = combined_error(light, light.standard_error[g].row(r), rule.weights);
      worst = std::max(worst, value > 0 ? std::min(1., 2 * error / value) : 1);
    }
  return worst;
}

}  // namespace coppermoon::shadow
