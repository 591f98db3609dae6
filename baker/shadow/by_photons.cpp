// SPDX-License-Identifier: MIT
#include "shadow/by_photons.h"

#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>

#include "algebra/error.h"
#include "photons/photon.h"
#include "photons/solar_disc.h"
#include "shadow/limb_landings.h"
#include "shadow/photon_spectra.h"

namespace coppermoon::shadow {
namespace {

using algebra::Grid;
using atmosphere::Atmosphere;

/// Number of photons that are processed together. Their light at all wavelengths is in memory at once.
constexpr std::size_t batch = 32;

/// Buffers that one thread needs to gather photons.
struct Workplace {
  Tally tally;                   ///< light from one block of photons
  Grid<float> light, landing_m;  ///< indexed by (photon in a batch, wavelength)

  Workplace(std::size_t cells, std::size_t waves)
      : tally(cells, waves), light(batch, padded(waves)), landing_m(light) {}
};

/// Sums over blocks of photons, indexed by (cell of a shadow plane, wavelength), as in a Tally.
struct BlockSums {
  Grid<double> sum, sum_of_squares;

  BlockSums(std::size_t rows, std::size_t waves) : sum(rows, waves), sum_of_squares(sum) {}
};

void add(Grid<double>& sums, const Grid<double>& more) {
  for (std::size_t i = 0; i < sums.values().size(); ++i) sums.values()[i] += more.values()[i];
}

class Simulation {
 public:
  Simulation(const Atmosphere& atmosphere, const Arrangement& arrangement,
             std::span<const double> wavelengths_nm, const PhotonSettings& settings,
             std::size_t rings)
      : atmosphere_(atmosphere),
        arrangement_(arrangement),
        settings_(settings),
        optics_(optics_of(atmosphere, wavelengths_nm)),
        rings_{static_cast<float>(settings.ring_width_m), rings, settings.sectors} {
    if (!settings.literal)
      landings_.emplace(atmosphere, arrangement, wavelengths_nm, settings.rays);
  }

  std::size_t rows() const { return arrangement_.depths_m.size() * rings_.rows(); }
  std::size_t waves() const { return optics_.size(); }

  /// Given  tell  callback for progress, called after each block
  BlockSums simulated(BlockRange blocks, const std::function<void()>& tell) const {
    BlockSums sums(rows(), waves());
    Workplace work(rows(), waves());
    for (auto block = blocks.from; block < blocks.to; ++block) {
      if (landings_)
        add_block(block, work);
      else
        for (std::uint64_t i = 0; i < photons_a_block; ++i)
          add_literal_photon(block * photons_a_block + i, work.tally);
      drain(work.tally, sums.sum, sums.sum_of_squares);
      tell();
    }
    return sums;
  }

 private:
  /// Radiance of a point on the Sun's disc, relative to the disc's mean radiance.
  double brightness_at(const glm::dvec3& source_m, std::size_t wave) const {
    if (!arrangement_.limb_darkening) return 1;
    const double rho = std::hypot(source_m.x, source_m.y) / photons::solar_radius_m;
    return photons::limb_darkening(algebra::nanometres(optics_[wave].wavelength_nm),
                                   std::sqrt(std::max(0., 1 - rho * rho)));
  }

  /// Area of the ring of air at which photons are aimed, times the number of wavelengths (each photon has only one).
  double emitting_area_m2() const {
    const double inner = photons::innermost_radius_m(atmosphere_);
    const double outer = atmosphere_.top_radius_m();
    return std::numbers::pi * (outer * outer - inner * inner) * static_cast<double>(waves());
  }

  void add_literal_photon(std::uint64_t index, Tally& tally) const {
    algebra::Random random(settings_.seed, index);
    const auto wave =
        static_cast<std::size_t>(random.uniform() * static_cast<double>(optics_.size()));
    const auto ray = photons::aimed_at_the_ring(random, arrangement_.sun_distance_m, atmosphere_);
    const auto entering = photons::entered(ray, atmosphere_.top_radius_m());
    if (!entering) return;  // a grazing ray may miss the air because of rounding
    const double chance = !atmosphere_.belted() ? 0 : random.uniform();
    const auto out =
        photons::trace(*entering, atmosphere_, optics_[wave], settings_.stepping, chance);
    if (!out) return;
    const double light =
        emitting_area_m2() * out->transmittance * brightness_at(ray.position_m, wave);
    for (std::size_t k = 0; k < arrangement_.depths_m.size(); ++k) {
      const auto landed = photons::at_depth(out->leaving, arrangement_.depths_m[k]);
      const std::size_t row = k * rings_.rows() + rings_.row(landed.x, landed.y);
      tally.light(row, wave) += static_cast<float>(light);
      tally.touched[row] = 1;
    }
  }

  void add_block(std::uint64_t block, Workplace& work) const {
    const auto aims = landings_->aims(settings_.seed, block, settings_.sectors > 1);
    for (std::size_t first = 0; first < aims.size(); first += batch)
      add_photons(std::span(aims).subspan(first, std::min(batch, aims.size() - first)), work);
  }

  void add_photons(std::span<const Aim> aims, Workplace& work) const {
    landings_->pass(aims, work.light);
    std::vector<Aside> asides(aims.size());
    for (std::size_t k = 0; k < arrangement_.depths_m.size(); ++k) {
      const double sun_m = projected_solar_radius_m(arrangement_, arrangement_.depths_m[k]);
      for (std::size_t i = 0; i < aims.size(); ++i)
        asides[i] = {static_cast<float>(aims[i].toward.x), static_cast<float>(aims[i].toward.y),
                     static_cast<float>(sun_m * aims[i].source.x),
                     static_cast<float>(sun_m * aims[i].source.y)};
      landings_->land(aims, k, work.landing_m);
      gather(asides, work.landing_m, work.light, rings_, k * rings_.rows(), work.tally);
    }
  }

  const Atmosphere& atmosphere_;
  const Arrangement& arrangement_;
  const PhotonSettings& settings_;
  std::vector<atmosphere::Optics> optics_;
  Rings rings_;
  std::optional<LimbLandings> landings_;  ///< absent if photons are traced step by step
};

/// Progress of a simulation, counted in finished blocks of photons.
struct BlockProgress {
  const algebra::Progress& told;
  std::uint64_t all;
  std::atomic<std::uint64_t> done = 0;

  void tell() const {
    if (told) told(static_cast<double>(done) / static_cast<double>(all));
  }
};

/// Traces blocks of photons and adds them to the sums in a fixed order, so that the sums do not depend on the number of
/// threads. Only the memory in use depends on it.
void add_blocks(const Simulation& simulation, BlockRange blocks, BlockSums& sums,
                BlockProgress& progress) {
  constexpr std::uint64_t parts = 64, most = 4096;
  const auto size = std::clamp<std::uint64_t>((blocks.to - blocks.from) / parts, 1, most);
  auto next = blocks.from;
  const auto held = static_cast<std::size_t>(tbb::this_task_arena::max_concurrency()) + 1;
  using Part = std::pair<BlockRange, std::shared_ptr<BlockSums>>;
  const auto cut = [&](tbb::flow_control& flow) -> BlockRange {
    if (next >= blocks.to) return flow.stop(), BlockRange{};
    const auto from = next;
    next = std::min(blocks.to, from + size);
    return {from, next};
  };
  // called after every block, because it may cancel the run, though the reported count grows only by ranges of blocks
  const auto tell = [&] { progress.tell(); };
  const auto trace = [&](BlockRange range) -> Part {
    return {range, std::make_shared<BlockSums>(simulation.simulated(range, tell))};
  };
  const auto merge = [&](const Part& part) {
    add(sums.sum, part.second->sum);
    add(sums.sum_of_squares, part.second->sum_of_squares);
    progress.done += part.first.to - part.first.from;
    progress.tell();
  };
  using tbb::filter_mode;
  tbb::parallel_pipeline(held,
                         tbb::make_filter<void, BlockRange>(filter_mode::serial_in_order, cut) &
                             tbb::make_filter<BlockRange, Part>(filter_mode::parallel, trace) &
                             tbb::make_filter<Part, void>(filter_mode::serial_in_order, merge));
}

void require_valid(const StoppingRule& rule, std::size_t waves) {
  algebra::require_within("tolerance", rule.tolerance, 1e-6, 1);
  if (rule.weights.size() != waves)
    throw algebra::Error(
        fmt::format("weights = {}, allowed {}, one a wavelength", rule.weights.size(), waves));
}

void require_valid(const PhotonSettings& settings, const Atmosphere& atmosphere,
                   std::size_t waves) {
  algebra::require_within("photons", static_cast<double>(settings.photons), 1, 1e12);
  algebra::require_within("step [km]", settings.stepping.step_m / 1e3, 1e-3, 100);
  algebra::require_within("rays", settings.rays, 2, 1e7);
  algebra::require_within("ring width [km]", settings.ring_width_m / 1e3, 1, 2000);
  algebra::require_within("sectors", static_cast<double>(settings.sectors), 1, 1000);
  if (settings.sectors == 1 && !atmosphere.symmetric())
    throw algebra::Error("sectors = 1, allowed 2 to 1000 for air that differs by region");
  if (settings.enough) require_valid(*settings.enough, waves);
}

PhotonSums no_photons(const Atmosphere& atmosphere, const Arrangement& arrangement,
                      std::span<const double> wavelengths_nm, const PhotonSettings& settings) {
  const double reach = refracted_reach_m(arrangement, atmosphere, arrangement.depths_m.back());
  const auto rings = static_cast<std::size_t>(std::ceil(reach / settings.ring_width_m));
  const std::vector<Grid<double>> nothing(arrangement.depths_m.size() * settings.sectors,
                                          Grid<double>(rings, wavelengths_nm.size()));
  return {settings.key,
          arrangement,
          {wavelengths_nm.begin(), wavelengths_nm.end()},
          settings.ring_width_m,
          rings,
          settings.sectors,
          !settings.literal,
          {},
          nothing,
          nothing};
}

/// Adds a Tally's rows to one grid for each plane and sector. The ring for all light farther out is left out.
void add(const Grid<double>& rows, std::vector<Grid<double>>& grids) {
  for (std::size_t g = 0; g < grids.size(); ++g)
    for (std::size_t r = 0; r < grids[g].rows(); ++r)
      for (std::size_t w = 0; w < grids[g].columns(); ++w)
        grids[g](r, w) += rows(g * (grids[g].rows() + 1) + r, w);
}

/// The first `count` blocks of photons in the given ranges.
std::vector<BlockRange> first_of(const std::vector<BlockRange>& ranges, std::uint64_t count) {
  std::vector<BlockRange> first;
  for (const auto& range : ranges) {
    const auto taken = std::min(count, range.to - range.from);
    if (taken > 0) first.push_back({range.from, range.from + taken});
    count -= taken;
  }
  return first;
}

/// Whether there is a stopping rule and the photons traced so far meet it.
bool enough(const PhotonSums& sums, const PhotonSettings& settings) {
  if (!settings.enough || blocks_in(sums.done) < blocks_for_an_error) return false;
  return worst_error(estimated(sums), *settings.enough) <= settings.enough->tolerance;
}

/// Traces the blocks of photons in the given ranges and adds their light to the sums.
void add_ranges(const Simulation& simulation, const std::vector<BlockRange>& ranges,
                PhotonSums& sums, BlockProgress& progress) {
  BlockSums rows(simulation.rows(), simulation.waves());
  PhotonSums more = sums;
  more.done = ranges;
  more.sum_rest.clear();
  more.sum_of_squares_rest.clear();
  for (const auto& range : ranges) add_blocks(simulation, range, rows, progress);
  for (auto* grids : {&more.sum, &more.sum_of_squares})
    for (auto& grid : *grids) std::fill(grid.values().begin(), grid.values().end(), 0.);
  add(rows.sum, more.sum);
  add(rows.sum_of_squares, more.sum_of_squares);
  sums = merged(std::move(sums), more);
}

}  // namespace

PhotonSums traced(const Atmosphere& atmosphere, const Arrangement& arrangement,
                  std::span<const double> wavelengths_nm, const PhotonSettings& settings,
                  const PhotonSums* before, const algebra::Progress& progress) {
  require_valid(atmosphere);
  require_valid(arrangement);
  require_valid(settings, atmosphere, wavelengths_nm.size());
  auto sums = no_photons(atmosphere, arrangement, wavelengths_nm, settings);
  if (before != nullptr) sums = merged(std::move(sums), *before);
  const auto asked = settings.blocks.value_or(blocks_of(settings.photons));
  auto left = missing(sums, asked);
  if (left.empty() || enough(sums, settings)) return sums;
  if (atmosphere.top_m() <= 0 || wavelengths_nm.empty()) {
    auto none = no_photons(atmosphere, arrangement, wavelengths_nm, settings);
    none.done = left;
    return merged(std::move(sums), none);
  }
  const Simulation simulation(atmosphere, arrangement, wavelengths_nm, settings, sums.rings);
  BlockProgress told{progress, blocks_in(left)};
  constexpr std::uint64_t first_batch = 16;
  while (!left.empty() && !enough(sums, settings)) {
    const auto count = settings.enough ? std::max(first_batch, blocks_in(sums.done)) : asked.to;
    add_ranges(simulation, first_of(left, count), sums, told);
    left = missing(sums, asked);
  }
  return sums;
}

RefractedLight by_photons(const Atmosphere& atmosphere, const Arrangement& arrangement,
                          std::span<const double> wavelengths_nm, const PhotonSettings& settings,
                          const algebra::Progress& progress) {
  return estimated(traced(atmosphere, arrangement, wavelengths_nm, settings, nullptr, progress));
}

RefractedLight smoothed(const RefractedLight& light, double sigma_m) {
  algebra::require_within("smoothing [km]", sigma_m / 1e3, 0, 2000);
  if (sigma_m == 0) return light;
  RefractedLight smooth = light;
  const auto& at = light.axis_distances_m;
  for (std::size_t i = 0; i < at.size(); ++i) {
    std::vector<double> kernel(at.size());
    double total = 0;
    for (std::size_t j = 0; j < at.size(); ++j) {
      const double away = (at[i] - at[j]) / sigma_m;
      total += kernel[j] = at[j] * std::exp(-away * away / 2);
    }
    for (std::size_t g = 0; g < light.ratio.size(); ++g)
      for (std::size_t w = 0; w < light.wavelengths_nm.size(); ++w) {
        double mean = 0, variance = 0;
        for (std::size_t j = 0; j < at.size(); ++j) {
          const double k = kernel[j] / total, error = light.standard_error[g](j, w);
          mean += k * light.ratio[g](j, w);
          variance += k * k * error * error;
        }
        smooth.ratio[g](i, w) = mean;
        smooth.standard_error[g](i, w) = std::sqrt(variance);
      }
  }
  return smooth;
}

}  // namespace coppermoon::shadow
