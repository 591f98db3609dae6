// SPDX-License-Identifier: MIT
#include "shadow/by_quadrature.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>
#include <numbers>
#include <optional>

#include "algebra/error.h"
#include "algebra/interpolation.h"
#include "photons/limb.h"
#include "shadow/landed_plane.h"

namespace coppermoon::shadow {
namespace {

using algebra::Grid;
using atmosphere::Atmosphere;
using std::numbers::pi;

double sector_angle(std::size_t sector, std::size_t sectors) {
  return 2 * pi * static_cast<double>(sector) / static_cast<double>(sectors);
}

/// The highest harmonic of the position angle that the limb's parts are taken to. Measured at 400 to
/// 700 nm up to 6000 km from the axis, worst and mean: of 13 belts against 192 harmonics, 1e-4 and
/// 3e-6, every other one dusty 4e-4 and 2e-5; of regions against arcs cut at their borders, aerosol
/// of a great eruption 6e-3 and 5e-5, dust that leaves a hundredth 2e-2 and 1e-4.
int highest_harmonic(const Atmosphere& atmosphere) {
  if (atmosphere.one_column()) return 2;  // an ellipsoid's
  return atmosphere.regions.empty() ? 48 : 160;
}

/// Width of the bins that light is gathered in, of distance from the axis: finer as rays are.
double bin_width_m(int rays) { return std::clamp(1.2e6 / rays, 100., 50e3); }

/// The position angles that are computed, and which of them each sector has the light of: its own, or
/// of belts that of its mirror image. Sectors that nobody asked for have none. On an ellipsoid
/// without regions light is computed towards its pole and its equator alone.
struct Directions {
  std::vector<double> angles_rad;
  std::vector<std::optional<std::size_t>> of_sector = {};
};

Directions directions(const Atmosphere& atmosphere, const QuadratureSettings& settings) {
  if (atmosphere.symmetric()) return {{0}};
  if (atmosphere.one_column()) return {{0, pi / 2}};
  Directions all{{}, std::vector<std::optional<std::size_t>>(settings.around)};
  std::vector<std::optional<std::size_t>> computed(settings.around);
  for (std::size_t i = 0; i < std::min(settings.sectors, settings.around); ++i) {
    const std::size_t sector = (settings.first_sector + i) % settings.around,
                      mirrored = (settings.around - sector) % settings.around,
                      like = atmosphere.regions.empty() ? std::min(sector, mirrored) : sector;
    if (!computed[like]) {
      computed[like] = all.angles_rad.size();
      all.angles_rad.push_back(sector_angle(like, settings.around));
    }
    all.of_sector[sector] = computed[like];
  }
  return all;
}

/// All that was computed at one axis distance: (plane × angles + angle, wavelength).
struct Ring {
  double gamma_m;
  Grid<double> ratio;
};

/// Computes rings.
class Solver {
 public:
  explicit Solver(const LandedPlane::Sunlit& sunlit)
      : angles_(sunlit.around.angles()), waves_(sunlit.optics.size()) {
    for (const double depth : sunlit.arrangement.depths_m) planes_.emplace_back(sunlit, depth);
  }

  /// Whether what they are computed from is kept from one time to the next, or made anew.
  bool keeps_light() const { return std::ranges::all_of(planes_, &LandedPlane::keeps_light); }

  std::vector<Ring> rings(std::span<const double> gammas_m, const algebra::Progress& progress) {
    std::vector<Ring> all;
    for (const double gamma : gammas_m) all.push_back({gamma, {planes_.size() * angles_, waves_}});
    std::mutex told;
    double done = 0;
    for (std::size_t k = 0; k < planes_.size(); ++k) {
      std::vector<LandedPlane::Place> places;
      for (auto& ring : all)
        places.push_back(
            {ring.gamma_m, ring.ratio.values().subspan(k * angles_ * waves_, angles_ * waves_)});
      planes_[k].light(places, [&](double more) {
        if (!progress) return;
        const std::lock_guard lock(told);
        progress(std::min(1., done += more / static_cast<double>(planes_.size())));
      });
    }
    return all;
  }

 private:
  std::size_t angles_, waves_;
  std::vector<LandedPlane> planes_;
};

/// Direct light of a ring, over unshaded sunlight.
double direct_light(const Atmosphere& atmosphere, const Arrangement& arrangement, double gamma_m) {
  return 1 - covered_part(gamma_m, arrangement.depths_m.front(), arrangement.sun_distance_m,
                          atmosphere.top_radius_m());
}

/// Largest relative error of a cubic through the four rings about a middle: of refracted light over
/// all wavelengths, against all light there, with direct light taken as darkness_ratio where there
/// is less.
double surprise(std::span<const Ring> about, const Ring& middle, double direct) {
  std::vector<double> gammas_m;
  for (const auto& ring : about) gammas_m.push_back(ring.gamma_m);
  const auto shares = algebra::on_polynomial(gammas_m, middle.gamma_m);
  double worst = 0;
  for (std::size_t row = 0; row < middle.ratio.rows(); ++row) {
    double foretold = 0, found = 0;
    for (std::size_t w = 0; w < middle.ratio.columns(); ++w) {
      found += middle.ratio(row, w);
      for (std::size_t i = 0; i < about.size(); ++i) foretold += shares[i] * about[i].ratio(row, w);
    }
    const double whole =
        found + std::max(direct, darkness_ratio) * static_cast<double>(middle.ratio.columns());
    worst = std::max(worst, std::abs(foretold - found) / whole);
  }
  return worst;
}

/// The rings asked for, and between them as many more as it takes.
class Refinement {
 public:
  Refinement(Solver& solver, const Atmosphere& atmosphere, const Arrangement& arrangement)
      : solver_(solver), atmosphere_(atmosphere), arrangement_(arrangement) {}

  std::vector<Ring> rings(std::span<const double> gammas_m, double error,
                          const algebra::Progress& progress) const {
    auto all = solver_.rings(gammas_m, progress);
    std::vector<bool> open(all.size(), error > 0);  // the interval above each
    while (std::ranges::count(open, true) > 0 && all.size() >= 4) halve(error, all, open);
    return all;
  }

 private:
  /// Halves the open intervals; those half as good as foretold stay open.
  void halve(double error, std::vector<Ring>& all, std::vector<bool>& open) const {
    constexpr double narrowest_m = 3e3;
    std::vector<double> middles;
    for (std::size_t i = 0; i + 1 < all.size(); ++i) {
      open[i] = open[i] && all[i + 1].gamma_m - all[i].gamma_m > 2 * narrowest_m;
      if (open[i]) middles.push_back((all[i].gamma_m + all[i + 1].gamma_m) / 2);
    }
    open.back() = false;
    auto found = solver_.rings(middles, {});
    std::vector<bool> still(all.size());
    for (std::size_t i = 0, next = 0; i < all.size(); ++i) {
      if (!open[i]) continue;
      const std::size_t first = std::clamp<std::size_t>(i, 1, all.size() - 3) - 1;
      const auto& middle = found[next++];
      still[i] = surprise(std::span(all).subspan(first, 4), middle,
                          direct_light(atmosphere_, arrangement_, middle.gamma_m)) > error;
    }
    std::vector<Ring> finer;
    std::vector<bool> finer_open;
    for (std::size_t i = 0, next = 0; i < all.size(); ++i) {
      finer.push_back(std::move(all[i]));
      finer_open.push_back(still[i]);
      if (!open[i]) continue;
      finer.push_back(std::move(found[next++]));
      finer_open.push_back(still[i]);
    }
    all = std::move(finer);
    open = std::move(finer_open);
  }

  Solver& solver_;
  const Atmosphere& atmosphere_;
  const Arrangement& arrangement_;
};

/// Rings of angles become sectors. On an ellipsoid all light is between that towards the pole and that
/// towards the equator: the limb is their mean by cos², so a disc's arcs of it know no more than
/// cos 2θ.
void fill(std::span<const Ring> rings, const Atmosphere& atmosphere, const Directions& directions,
          RefractedLight& light) {
  const bool ellipse_alone = atmosphere.one_column() && !atmosphere.symmetric();
  const std::size_t waves = light.wavelengths_nm.size(), a_plane = directions.angles_rad.size();
  tbb::parallel_for(std::size_t{0}, light.ratio.size(), [&](std::size_t g) {
    const std::size_t plane = g / light.sectors, s = g % light.sectors;
    const auto computed = directions.of_sector.empty() ? std::size_t{0} : directions.of_sector[s];
    if (!computed) return;
    const double along = std::cos(2 * sector_angle(s, light.sectors));
    for (std::size_t d = 0; d < rings.size(); ++d) {
      const auto to = light.ratio[g].row(d);
      const std::span<const double> row = rings[d].ratio.row(plane * a_plane + *computed);
      if (!ellipse_alone) {
        std::ranges::copy(row, to.begin());
        continue;
      }
      const auto equator = rings[d].ratio.row(plane * a_plane + 1);
      for (std::size_t w = 0; w < waves; ++w)
        to[w] = (row[w] + equator[w]) / 2 + (row[w] - equator[w]) / 2 * along;
    }
  });
}

/// Some of the wavelengths, evenly chosen.
struct Wavelengths {
  std::vector<atmosphere::Optics> optics;
  photons::DiscTerms sun;
};

Wavelengths fewer(const Wavelengths& all, std::size_t count) {
  Wavelengths some{{}, {all.sun.functions, {all.sun.functions.size(), count}}};
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t w = (2 * i + 1) * all.optics.size() / (2 * count);
    some.optics.push_back(all.optics[w]);
    for (std::size_t term = 0; term < all.sun.functions.size(); ++term)
      some.sun.brightness(term, i) = all.sun.brightness(term, w);
  }
  return some;
}

/// The rings asked for and those put between them. Where light of all wavelengths does not fit into
/// memory, some of these say where rings are put.
std::vector<Ring> rings_of(const Atmosphere& atmosphere, const Arrangement& arrangement,
                           std::span<const double> wavelengths_nm,
                           std::span<const double> axis_distances_m, const Directions& directions,
                           const QuadratureSettings& settings, const algebra::Progress& progress) {
  constexpr std::size_t telling = 32;
  const Wavelengths all{
      optics_of(atmosphere, wavelengths_nm),
      photons::disc_terms(wavelengths_nm, arrangement.limb_darkening, settings.sun_terms)};
  const photons::WholeLimb limb(atmosphere, all.optics, settings.rays,
                                photons::WholeLimb::Fans::when_asked);
  const Around around(limb, highest_harmonic(atmosphere), directions.angles_rad);
  const auto sunlit = [&](const Wavelengths& waves) {
    return LandedPlane::Sunlit{limb,         around,      waves.sun,
                               waves.optics, arrangement, bin_width_m(settings.rays)};
  };
  Solver solver(sunlit(all));
  if (settings.place_error == 0 || solver.keeps_light() || all.optics.size() <= telling)
    return Refinement(solver, atmosphere, arrangement)
        .rings(axis_distances_m, settings.place_error, progress);
  const auto some = fewer(all, telling);
  Solver quick(sunlit(some));
  std::vector<double> distances_m;
  for (const auto& ring :
       Refinement(quick, atmosphere, arrangement).rings(axis_distances_m, settings.place_error, {}))
    distances_m.push_back(ring.gamma_m);
  return solver.rings(distances_m, progress);
}

void require_valid(const QuadratureSettings& settings) {
  algebra::require_within("rays", settings.rays, 2, 1e7);
  algebra::require_within("first sector", static_cast<double>(settings.first_sector), 0,
                          static_cast<double>(settings.around) - 1);
  algebra::require_within("sectors around", static_cast<double>(settings.around), 4, 360);
  algebra::require_within("sectors", static_cast<double>(settings.sectors), 1, 360);
  algebra::require_within("error between places", settings.place_error, 0, 1);
}

}  // namespace

RefractedLight by_quadrature(const Atmosphere& atmosphere, const Arrangement& arrangement,
                             std::span<const double> wavelengths_nm,
                             std::span<const double> axis_distances_m,
                             const QuadratureSettings& settings,
                             const algebra::Progress& progress) {
  require_valid(atmosphere);
  require_valid(arrangement);
  require_valid(settings);
  const std::size_t sectors = atmosphere.symmetric() ? 1 : settings.around;
  if (atmosphere.top_m() <= 0 || wavelengths_nm.empty() || axis_distances_m.empty())
    return darkness(arrangement, wavelengths_nm, axis_distances_m, sectors);
  RefractedLight light;
  // an error in a loop that this is part of ends that loop's others: theirs here would be skipped, and what they
  // fill be missing
  tbb::task_group_context alone(tbb::task_group_context::isolated);
  tbb::parallel_for(
      0, 1,
      [&](int) {
        const auto around = directions(atmosphere, settings);
        const auto rings = rings_of(atmosphere, arrangement, wavelengths_nm, axis_distances_m,
                                    around, settings, progress);
        std::vector<double> distances_m;
        for (const auto& ring : rings) distances_m.push_back(ring.gamma_m);
        light = darkness(arrangement, wavelengths_nm, distances_m, sectors);
        fill(rings, atmosphere, around, light);
      },
      alone);
  return light;
}

}  // namespace coppermoon::shadow
