// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "algebra/grid.h"
#include "shadow/irradiance.h"

namespace coppermoon::shadow {

/// Number of photons in a block.
inline constexpr std::uint64_t photons_a_block = 1024;

/// Smallest number of blocks whose standard error is known.
inline constexpr std::uint64_t blocks_for_an_error = 8;

/// Blocks of photons by number, without the last.
struct BlockRange {
  std::uint64_t from = 0, to = 0;

  bool operator==(const BlockRange&) const = default;
};

/// The blocks that hold so many photons; a last one that is not full is filled.
BlockRange blocks_of(std::uint64_t photons);

/// One of some equal parts of them.
///
/// Given   part   1 to parts
/// Throws  Error  when it is not
BlockRange shard(BlockRange blocks, std::uint64_t part, std::uint64_t parts);

/// The light that some blocks of photons brought to each cell: partial results that add up,
/// wherever and whenever each was traced.
struct PhotonSums {
  std::string key;  ///< what they belong to: air, arrangement, seed and all else that changes them
  Arrangement arrangement{};
  std::vector<double> wavelengths_nm;
  double ring_width_m = 0;
  std::size_t rings = 0, sectors = 1;
  bool all_wavelengths = true;   ///< each photon carries them; else one
  std::vector<BlockRange> done;  ///< in order, none touching the next
  /// [plane × sectors + sector](ring, wavelength), over blocks, of the light that a block brought:
  /// the area of unshaded sunlight that has as much [m²], and its square
  std::vector<algebra::Grid<double>> sum, sum_of_squares;
  /// what rounding has kept out of them, as far as they were merged here; empty: nothing
  std::vector<algebra::Grid<double>> sum_rest{}, sum_of_squares_rest{};
};

std::uint64_t blocks_in(const std::vector<BlockRange>& ranges);

/// The blocks of a range that are not done yet.
std::vector<BlockRange> missing(const PhotonSums& sums, BlockRange blocks);

/// The sums of both together.
///
/// Accuracy  as if traced in one run but for rounding, 1e-12, however many are merged one by one
/// Throws    Error  when they belong to different things, or hold the same blocks
PhotonSums merged(PhotonSums a, const PhotonSums& b);

/// Mean and standard error of each cell: of the light over its ring, at the ring's middle. Blocks are
/// independent and alike: the mean has no bias, the error is that of the mean over blocks.
///
///     E/E₀ = (1 + z/D)² Σ / (n A)      A = the cell's area, n = photons
///
/// Returned  axis_distances_m at the rings' middles; the standard error equal to the ratio, 100 %,
///           where there are fewer than blocks_for_an_error
RefractedLight means_over_rings(const PhotonSums& sums);

/// Light that photons estimate. Its standard error is noise and what rings cannot resolve, as the
/// root of the sum of squares.
struct PhotonLight : RefractedLight {
  std::vector<algebra::Grid<double>> noise;  ///< [as ratio]: the part that more photons lessen
};

/// The light at the rings' middles whose means over the rings are those of the photons. Through a
/// ring and its neighbours goes a parabola of the light's logarithm g, in the opposite sector beyond
/// the axis; s is the distance from the middle in ring widths h.
///
///     E = M / ∫ (1 + s h/r) exp(g′ s + g″ s²/2) ds      −½ < s < ½, M = the ring's mean
///
/// Between the middles light is read as a cubic of the logarithm. What that and the parabola miss,
/// where light bends more sharply than rings resolve, counts as an error of 3/32 of the fourth
/// difference of ln M, four times what a cubic misses of a smooth curve, with those of the rings beside
/// it at half their squares; less what noise alone makes of them. Rings whose noise is above a third of their mean, empty ones among them, keep the mean and
/// are no neighbours, nor are rings 50 times as bright; lacking one neighbour, the parabola is a
/// straight line and all that it changes is an error.
///
/// Returned  as means_over_rings
/// Accuracy  2e-5 of light that falls by e in two ring widths or more; noise grows by 9 %
PhotonLight estimated(const PhotonSums& sums);

/// The condition on which enough photons have been traced: light, weighted over wavelengths, is
/// known to a tolerance in every ring and sector between two axis distances.
struct StoppingRule {
  std::vector<double> weights;  ///< by wavelength
  double tolerance;             ///< two standard errors over the light, 1e-6 to 1
  double from_m, to_m;          ///< axis distances
};

/// Twice the noise of the weighted light over that light, at worst; 1 where nothing has landed, or
/// the noise is not known. What rings cannot resolve does not count: no photons would end it.
double worst_error(const PhotonLight& light, const StoppingRule& rule);

/// Twice the whole standard error of the weighted light over that light, at worst.
double worst_error(const RefractedLight& light, const StoppingRule& rule);

}  // namespace coppermoon::shadow
