// SPDX-License-Identifier: MIT
#include "shadow/by_photons.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <optional>

#include "algebra/error.h"
#include "photons/limb.h"
#include "photons/photon.h"
#include "photons/solar_disc.h"

namespace coppermoon::shadow {
namespace {

using algebra::Grid;
using atmosphere::Atmosphere;

/// Sums over photons, cell by cell.
struct Tally {
  std::vector<Grid<double>> sum, sum_of_squares;  // [plane × sectors + sector](ring, wavelength)

  Tally(std::size_t grids, std::size_t rings, std::size_t waves)
      : sum(grids, Grid<double>(rings, waves)), sum_of_squares(sum) {}

  Tally& operator+=(const Tally& other) {
    for (std::size_t g = 0; g < sum.size(); ++g)
      for (std::size_t i = 0; i < sum[g].values().size(); ++i) {
        sum[g].values()[i] += other.sum[g].values()[i];
        sum_of_squares[g].values()[i] += other.sum_of_squares[g].values()[i];
      }
    return *this;
  }
};

/// All that one photon needs to know.
struct Simulation {
  const Atmosphere& atmosphere;
  const Arrangement& arrangement;
  const PhotonSettings& settings;
  std::vector<atmosphere::Optics> optics;
  std::size_t rings;
  std::optional<photons::WholeLimb> limb;  ///< where photons go by the table

  std::size_t sector_of(const glm::dvec3& at) const {
    const double turn = std::atan2(at.x, at.y) / (2 * std::numbers::pi);
    const double sectors = static_cast<double>(settings.sectors);
    const auto nearest = static_cast<std::int64_t>(std::floor((turn + 1) * sectors + 0.5));
    return static_cast<std::size_t>(nearest) % settings.sectors;
  }

  /// Of the Sun's disc over its mean, at a place of it.
  double brightness_at(const glm::dvec3& source_m, std::size_t wave) const {
    if (!arrangement.limb_darkening) return 1;
    const double rho = std::hypot(source_m.x, source_m.y) / photons::solar_radius_m;
    return photons::limb_darkening(algebra::nanometres(optics[wave].wavelength_nm),
                                   std::sqrt(std::max(0., 1 - rho * rho)));
  }

  /// Through the air and out again.
  std::optional<photons::Traced> followed(const photons::Ray& ray, std::size_t wave) const {
    if (limb) return limb->passed(ray, wave);
    const auto entering = photons::entered(ray, atmosphere.top_radius_m());
    if (!entering) return std::nullopt;  // a graze lost to rounding
    return photons::trace(*entering, atmosphere, optics[wave], settings.stepping);
  }

  void add_photon(std::uint64_t index, Tally& tally) const {
    algebra::Random random(settings.seed, index);
    const auto wave =
        static_cast<std::size_t>(random.uniform() * static_cast<double>(optics.size()));
    const auto ray = photons::aimed_at_the_ring(random, arrangement.sun_distance_m, atmosphere);
    const auto traced = followed(ray, wave);
    if (!traced) return;
    const double weight = traced->transmittance * brightness_at(ray.position_m, wave);
    for (std::size_t k = 0; k < arrangement.depths_m.size(); ++k) {
      const auto landed = photons::at_depth(traced->leaving, arrangement.depths_m[k]);
      const auto ring =
          static_cast<std::size_t>(std::hypot(landed.x, landed.y) / settings.ring_width_m);
      if (ring >= rings) continue;
      const std::size_t grid = k * settings.sectors + sector_of(landed);
      tally.sum[grid](ring, wave) += weight;
      tally.sum_of_squares[grid](ring, wave) += weight * weight;
    }
  }
};

/// Blocks of fixed size, merged in a fixed order: the same sums whatever the number of threads.
Tally simulated(const Simulation& simulation, const Tally& none,
                const algebra::Progress& progress) {
  constexpr std::uint64_t block = 4096;
  const std::uint64_t photons = simulation.settings.photons, blocks = (photons + block - 1) / block;
  std::atomic<std::uint64_t> done = 0;
  const auto add_blocks = [&](const tbb::blocked_range<std::uint64_t>& range, Tally tally) {
    for (auto b = range.begin(); b != range.end(); ++b) {
      for (auto i = b * block; i < std::min(photons, (b + 1) * block); ++i)
        simulation.add_photon(i, tally);
      if (progress) progress(static_cast<double>(++done) / static_cast<double>(blocks));
    }
    return tally;
  };
  const auto merge = [](Tally a, const Tally& b) { return std::move(a += b); };
  const auto grain = std::max<std::uint64_t>(1, blocks / 64);
  return tbb::parallel_deterministic_reduce(tbb::blocked_range<std::uint64_t>(0, blocks, grain),
                                            none, add_blocks, merge);
}

void require_valid(const PhotonSettings& settings, const Atmosphere& atmosphere) {
  algebra::require_within("photons", static_cast<double>(settings.photons), 1, 1e12);
  algebra::require_within("step [km]", settings.stepping.step_m / 1e3, 1e-3, 100);
  algebra::require_within("rays", settings.rays, 2, 1e7);
  algebra::require_within("ring width [km]", settings.ring_width_m / 1e3, 1, 2000);
  algebra::require_within("sectors", static_cast<double>(settings.sectors), 1, 360);
  if (settings.sectors == 1 && !atmosphere.symmetric())
    throw algebra::Error("sectors = 1, allowed 2 to 360 for air that differs by region");
}

/// Irradiance ratio that one photon of full weight makes in a cell of ring r, times all photons.
double cell_weight(const Simulation& simulation, double depth_m, std::size_t r) {
  const double spread = 1 + depth_m / simulation.arrangement.sun_distance_m;
  const double inner = photons::innermost_radius_m(simulation.atmosphere);
  const double outer = simulation.atmosphere.top_radius_m();
  const double width = simulation.settings.ring_width_m;
  const double ring_area_over_pi = width * width * (2 * static_cast<double>(r) + 1);
  return spread * spread * (outer * outer - inner * inner) / ring_area_over_pi *
         static_cast<double>(simulation.settings.sectors * simulation.optics.size());
}

/// Sums of weights and of their squares become a mean and its standard error.
void become_estimates(std::span<double> sums, std::span<double> squares, double weight,
                      double photons) {
  for (std::size_t w = 0; w < sums.size(); ++w) {
    const double mean = sums[w] / photons, variance = squares[w] / photons - mean * mean;
    sums[w] = weight * mean;
    squares[w] = weight * std::sqrt(std::max(0., variance) / photons);
  }
}

}  // namespace

RefractedLight by_photons(const Atmosphere& atmosphere, const Arrangement& arrangement,
                          std::span<const double> wavelengths_nm, const PhotonSettings& settings,
                          const algebra::Progress& progress) {
  require_valid(atmosphere);
  require_valid(arrangement);
  require_valid(settings, atmosphere);
  const double reach = refracted_reach_m(arrangement, atmosphere, arrangement.depths_m.back());
  const auto rings = static_cast<std::size_t>(std::ceil(reach / settings.ring_width_m));
  Simulation simulation{atmosphere, arrangement, settings, optics_of(atmosphere, wavelengths_nm),
                        rings,      {}};
  if (settings.trace == Trace::table)
    simulation.limb.emplace(atmosphere, simulation.optics, settings.rays);
  const Tally none(arrangement.depths_m.size() * settings.sectors, rings, wavelengths_nm.size());
  Tally tally = atmosphere.top_m() > 0 ? simulated(simulation, none, progress) : none;

  RefractedLight light{arrangement,
                       {wavelengths_nm.begin(), wavelengths_nm.end()},
                       {},
                       settings.sectors,
                       std::move(tally.sum),
                       std::move(tally.sum_of_squares)};
  for (std::size_t r = 0; r < rings; ++r)
    light.axis_distances_m.push_back((static_cast<double>(r) + 0.5) * settings.ring_width_m);
  for (std::size_t g = 0; g < light.ratio.size(); ++g)
    for (std::size_t r = 0; r < rings; ++r)
      become_estimates(light.ratio[g].row(r), light.standard_error[g].row(r),
                       cell_weight(simulation, arrangement.depths_m[g / settings.sectors], r),
                       static_cast<double>(settings.photons));
  return light;
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
