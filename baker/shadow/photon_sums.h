// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "algebra/grid.h"
#include "shadow/irradiance.h"

namespace coppermoon::shadow {

inline constexpr std::uint64_t photons_a_block = 1024;

/// Smallest number of blocks for an estimate of the standard error.
inline constexpr std::uint64_t blocks_for_an_error = 8;

/// Half-open range of block numbers: from `from` up to but excluding `to`.
struct BlockRange {
  std::uint64_t from = 0, to = 0;

  bool operator==(const BlockRange&) const = default;
};

/// Blocks that hold the given number of photons, rounded up to whole blocks.
BlockRange blocks_of(std::uint64_t photons);

/// One of the equal parts into which a range of blocks is divided.
///
/// Given   part   number of the part, 1 to `parts`
/// Throws  Error  if a number is outside its range
BlockRange shard(BlockRange blocks, std::uint64_t part, std::uint64_t parts);

/// Sums of the light that blocks of photons brought to each cell of the shadow planes. They are partial results of one
/// simulation, which can be traced in several runs and merged.
struct PhotonSums {
  /// identifies the simulation: air, arrangement, seed and every other input. Only sums with equal keys can be merged
  std::string key;
  Arrangement arrangement{};
  std::vector<double> wavelengths_nm;
  double ring_width_m = 0;
  std::size_t rings = 0, sectors = 1;
  bool all_wavelengths = true;   ///< whether a photon carries all wavelengths, or only one
  std::vector<BlockRange> done;  ///< ranges of traced blocks, in order, with gaps between them
  /// [plane × sectors + sector](ring, wavelength): sum over blocks of each block's light, and of its square. Light is
  /// expressed as the area [m²] that receives as much light in unshaded sunlight
  std::vector<algebra::Grid<double>> sum, sum_of_squares;
  /// remainders of compensated summation that arise in merging; if empty, they are 0
  std::vector<algebra::Grid<double>> sum_rest{}, sum_of_squares_rest{};
};

std::uint64_t blocks_in(const std::vector<BlockRange>& ranges);

/// Blocks of a range that have not been traced yet.
std::vector<BlockRange> missing(const PhotonSums& sums, BlockRange blocks);

/// Merges the sums of two runs.
///
/// Accuracy  equal to a single run up to rounding, 1e-12, however many sums are merged one after another
/// Throws    Error  if the keys differ, or both hold the same block
PhotonSums merged(PhotonSums a, const PhotonSums& b);

/// Mean and standard error of the light in each cell, assigned to the ring's middle. Blocks are independent and
/// identically distributed. The mean is therefore unbiased, and its standard error follows from the scatter of blocks.
///
///     E/E₀ = (1 + z/D)² Σ / (n A)    Σ, A: sum and area of the cell; n: photons; z, D: distances of plane and Sun
///
/// Returned  light with axis_distances_m at the rings' middles; the standard error equals the ratio (100 %) if there
///           are fewer blocks than blocks_for_an_error
RefractedLight means_over_rings(const PhotonSums& sums);

/// Light estimated from photons. Its standard error combines noise and unresolved structure within rings, as the
/// root of the sum of squares.
struct PhotonLight : RefractedLight {
  /// standard error due to noise, which more photons reduce; indexed like ratio
  std::vector<algebra::Grid<double>> noise;
};

/// Light at the rings' middles, deconvolved so that its means over the rings are the photons' means. The logarithm g of
/// the light is assumed to be a parabola through a ring and its two neighbours (across the axis, those of the opposite
/// sector); s is the distance from the ring's middle in ring widths h, and r the axis distance of the middle.
///
///     E = M / ∫ (1 + s h/r) exp(g′ s + g″ s²/2) ds      −½ < s < ½, M = the ring's mean
///
/// Between the middles, light is interpolated with a cubic in its logarithm (BetweenPlaces). The relative error due to
/// structure that rings do not resolve is estimated as 3/32 of the fourth difference of ln M, which is four times the
/// error of a cubic for a smooth curve. Half the squares of this error at the two neighbouring rings are added to its
/// square, and the squares that noise alone would cause are subtracted. Rings whose noise exceeds a third of their
/// mean, including empty ones, keep their mean. They are not used as neighbours, nor are rings that are 50 times
/// brighter or darker. If one neighbour is missing, g is a straight line, and the whole correction counts as an error.
///
/// Returned  light with the same axis distances as from means_over_rings
/// Accuracy  2e-5 for light that falls by a factor e in two ring widths or more; noise is 9 % above that of the means
PhotonLight estimated(const PhotonSums& sums);

/// Stopping rule: enough photons are traced when light, weighted over wavelengths, is known to a tolerance in
/// every ring and sector between two axis distances.
struct StoppingRule {
  std::vector<double> weights;  ///< weight of each wavelength
  double tolerance;     ///< largest allowed value of two relative standard errors, 1e-6 to 1
  double from_m, to_m;  ///< range of axis distances
};

/// Largest relative error of the weighted light, at two standard errors of noise; 1 if a ring has received no light, or
/// the noise is not known. Unresolved structure does not count, because more photons would not reduce it.
double worst_error(const PhotonLight& light, const StoppingRule& rule);

/// Largest relative error of the weighted light, at two standard errors, with unresolved structure included.
double worst_error(const RefractedLight& light, const StoppingRule& rule);

}  // namespace coppermoon::shadow
