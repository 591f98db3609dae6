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
#include <utility>

#include "algebra/error.h"
#include "algebra/interpolation.h"
#include "photons/earth_limb.h"
#include "shadow/landed_plane.h"

namespace coppermoon::shadow {
namespace {

using algebra::Grid;
using atmosphere::Atmosphere;
using std::numbers::pi;

/// Highest harmonic of the position angle in the limb parts' Fourier series; it grows with the number of rays. Omitted
/// harmonics cause these largest (and mean) errors at 400 to 700 nm, up to 6000 km from the axis. For 13 belts of
/// latitude, 48 harmonics differ from 192 by 1e-4 (3e-6), or by 4e-4 (2e-5) if every other belt has dust. For regions,
/// 160 harmonics differ from integrals that end at the regions' borders by 6e-3 (5e-5) if a region has the aerosol of a
/// great eruption, by 2e-2 (1e-4) if it has dust that transmits a hundredth. With 300 rays, the luminance differs from
/// that of 160 harmonics by 5e-4 (3e-5) if 24 are used for belts, and by 7e-4 (7e-6) if 75 are used for regions.
int highest_harmonic(const Atmosphere& atmosphere, int rays) {
  if (atmosphere.one_column()) return 2;  // an ellipsoid needs no higher harmonic
  return atmosphere.regions.empty() ? std::clamp(rays / 16, 24, 48) : std::clamp(rays / 4, 75, 160);
}

/// Width of the bins of landing distance in which light is gathered, inversely proportional to the number of rays.
double bin_width_m(int rays) { return std::clamp(1.2e6 / rays, 100., 50e3); }

/// Position angles at which light is computed, and for each sector the index of the angle whose light it uses. If the
/// air in the west mirrors that in the east, a sector and its mirror image use the same angle. Sectors that were not
/// requested have no index. For an ellipsoid with one column of air, light is computed only towards pole and equator.
struct Directions {
  std::vector<double> angles_rad;
  std::vector<std::optional<std::size_t>> of_sector = {};
};

Directions directions(const Atmosphere& atmosphere, const QuadratureSettings& settings) {
  if (atmosphere.symmetric()) return {{0}};
  if (atmosphere.one_column()) return {{0, pi / 2}};
  const auto& sectors = settings.sectors;
  Directions all{{}, std::vector<std::optional<std::size_t>>(sectors.around)};
  std::vector<std::optional<std::size_t>> computed(sectors.around);
  for (std::size_t i = 0; i < sectors.count; ++i) {
    const std::size_t sector = sectors[i], mirrored = sectors.mirrored(sector),
                      like = atmosphere.mirrored() ? std::min(sector, mirrored) : sector;
    if (!computed[like]) {
      computed[like] = all.angles_rad.size();
      all.angles_rad.push_back(sectors.angle_rad(like));
    }
    all.of_sector[sector] = computed[like];
  }
  return all;
}

/// Light at one axis distance, indexed by (plane × angles + angle, wavelength).
struct Ring {
  double gamma_m;
  Grid<double> ratio;
};

/// Computes light at given axis distances, on all planes.
class Solver {
 public:
  explicit Solver(const LandedPlane::Sunlit& sunlit)
      : angles_(sunlit.around.angles()), waves_(sunlit.waves.size()) {
    for (const double depth : sunlit.arrangement.depths_m) planes_.emplace_back(sunlit, depth);
  }

  /// Whether all planes keep the limb's light between calls (LandedPlane::keeps_light).
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

/// Direct light at an axis distance, as a ratio to unshaded sunlight.
double direct_light(const Atmosphere& atmosphere, const Arrangement& arrangement, double gamma_m) {
  return 1 - covered_part(gamma_m, arrangement.depths_m.front(), arrangement.sun_distance_m,
                          atmosphere.top_radius_m());
}

/// Error of cubic interpolation from four rings to the ring between them, relative to refracted plus direct light
/// there, with light summed over wavelengths. The result is the largest error in any atmosphere and at any angle.
///
/// Given  direct  direct light, or dark_ratio if that is larger
///        airs    number of atmospheres, whose wavelengths follow one another in a ring's columns
double surprise(std::span<const Ring> about, const Ring& middle, double direct, std::size_t airs) {
  std::vector<double> gammas_m;
  for (const auto& ring : about) gammas_m.push_back(ring.gamma_m);
  const auto shares = algebra::on_polynomial(gammas_m, middle.gamma_m);
  const std::size_t waves = middle.ratio.columns() / airs;
  double worst = 0;
  for (std::size_t row = 0; row < middle.ratio.rows(); ++row)
    for (std::size_t air = 0; air < airs; ++air) {
      double foretold = 0, found = 0;
      for (std::size_t w = air * waves; w < (air + 1) * waves; ++w) {
        found += middle.ratio(row, w);
        for (std::size_t i = 0; i < about.size(); ++i)
          foretold += shares[i] * about[i].ratio(row, w);
      }
      const double whole = found + direct * static_cast<double>(waves);
      worst = std::max(worst, std::abs(foretold - found) / whole);
    }
  return worst;
}

/// Inserts a ring in the middle of each open interval between two rings. If cubic interpolation from the other rings
/// errs by more than the tolerance there, both halves of the interval stay open.
///
/// Given  open  for each ring, whether the interval above it is open
void halve(Solver& solver, std::span<const Atmosphere> airs, const Arrangement& arrangement,
           const QuadratureSettings& settings, std::vector<Ring>& all, std::vector<bool>& open) {
  constexpr double narrowest_m = 3e3;
  std::vector<double> middles;
  for (std::size_t i = 0; i + 1 < all.size(); ++i) {
    open[i] = open[i] && all[i + 1].gamma_m - all[i].gamma_m > 2 * narrowest_m;
    if (open[i]) middles.push_back((all[i].gamma_m + all[i + 1].gamma_m) / 2);
  }
  open.back() = false;
  auto found = solver.rings(middles, {});
  std::vector<bool> still(all.size());
  for (std::size_t i = 0, next = 0; i < all.size(); ++i) {
    if (!open[i]) continue;
    const std::size_t first = std::clamp<std::size_t>(i, 1, all.size() - 3) - 1;
    const auto& middle = found[next++];
    const double direct = direct_light(airs.front(), arrangement, middle.gamma_m);
    still[i] = surprise(std::span(all).subspan(first, 4), middle,
                        std::max(settings.dark_ratio, direct), airs.size()) > settings.place_error;
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

/// Rings at the requested axis distances, with further rings inserted between them.
std::vector<Ring> refined(Solver& solver, std::span<const Atmosphere> airs,
                          const Arrangement& arrangement, std::span<const double> gammas_m,
                          const QuadratureSettings& settings, const algebra::Progress& progress) {
  auto all = solver.rings(gammas_m, progress);
  std::vector<bool> open(all.size(), settings.place_error > 0);
  while (std::ranges::count(open, true) > 0 && all.size() >= 4)
    halve(solver, airs, arrangement, settings, all, open);
  return all;
}

/// Copies the rings' light to the sectors. For an ellipsoid with one column of air, light is interpolated between pole
/// and equator, linearly in cos 2θ. This is exact, because the weights of the limb's parts are cos² θ and sin² θ.
///
/// Given  first_wave  column of the rings that holds the light's first wavelength
void fill(std::span<const Ring> rings, std::size_t first_wave, const Atmosphere& atmosphere,
          const Directions& directions, RefractedLight& light) {
  const bool ellipse_alone = atmosphere.one_column() && !atmosphere.symmetric();
  const std::size_t waves = light.wavelengths_nm.size(), a_plane = directions.angles_rad.size();
  tbb::parallel_for(std::size_t{0}, light.ratio.size(), [&](std::size_t g) {
    const std::size_t plane = g / light.sectors, s = g % light.sectors;
    const auto computed = directions.of_sector.empty() ? std::size_t{0} : directions.of_sector[s];
    if (!computed) return;
    // FAULT light of an ellipsoid once around the axis: 2 * Sectors => Sectors
    const double along = std::cos(2 * Sectors{light.sectors}.angle_rad(s));
    for (std::size_t d = 0; d < rings.size(); ++d) {
      const auto to = light.ratio[g].row(d);
      const auto row = rings[d].ratio.row(plane * a_plane + *computed).subspan(first_wave, waves);
      if (!ellipse_alone) {
        std::ranges::copy(row, to.begin());
        continue;
      }
      const auto equator = rings[d].ratio.row(plane * a_plane + 1).subspan(first_wave, waves);
      for (std::size_t w = 0; w < waves; ++w)
        to[w] = (row[w] + equator[w]) / 2 + (row[w] - equator[w]) / 2 * along;
    }
  });
}

/// Wavelengths, the same ones listed once for each atmosphere, and the brightness of the Sun's disc at each.
struct Wavelengths {
  std::vector<Wave> waves;
  photons::DiscTerms sun;
};

/// Chooses evenly spaced wavelengths, the same ones in each atmosphere.
///
/// Given  count  number of wavelengths to choose, at most as many as there are
Wavelengths chosen(std::span<const Atmosphere> airs, std::span<const atmosphere::Optics> optics,
                   const photons::DiscTerms& sun, std::size_t count) {
  Wavelengths some{{}, {sun.functions, {sun.functions.size(), airs.size() * count}}};
  for (const auto& air : airs)
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t w = (2 * i + 1) * optics.size() / (2 * count);
      for (std::size_t term = 0; term < sun.functions.size(); ++term)
        some.sun.brightness(term, some.waves.size()) = sun.brightness(term, w);
      some.waves.push_back({optics[w], &air});
    }
  return some;
}

/// Rings at the requested axis distances, and further rings inserted between them. If light at all wavelengths does not
/// fit into memory, only a few wavelengths are used to decide where to insert rings.
std::vector<Ring> rings_of(std::span<const Atmosphere> airs, const Arrangement& arrangement,
                           std::span<const double> wavelengths_nm,
                           std::span<const double> axis_distances_m, const Directions& directions,
                           const QuadratureSettings& settings, const algebra::Progress& progress) {
  constexpr std::size_t telling = 32;
  const auto optics = optics_of(airs.front(), wavelengths_nm);
  const auto sun =
      photons::disc_terms(wavelengths_nm, arrangement.limb_darkening, settings.sun_terms);
  const auto rich = atmosphere::richest(airs);
  const photons::WholeLimb limb(rich, optics, settings.rays, photons::WholeLimb::Fans::when_asked);
  const Around around(limb, std::min(highest_harmonic(rich, settings.rays), settings.harmonics),
                      directions.angles_rad);
  const auto sunlit = [&](const Wavelengths& wavelengths) {
    return LandedPlane::Sunlit{limb,
                               around,
                               wavelengths.sun,
                               wavelengths.waves,
                               arrangement,
                               bin_width_m(settings.rays),
                               axis_distances_m.back()};
  };
  const auto all = chosen(airs, optics, sun, optics.size());
  Solver solver(sunlit(all));
  if (settings.place_error == 0 || solver.keeps_light() || optics.size() <= telling)
    return refined(solver, airs, arrangement, axis_distances_m, settings, progress);
  const auto some = chosen(airs, optics, sun, telling);
  Solver quick(sunlit(some));
  std::vector<double> distances_m;
  for (const auto& ring : refined(quick, airs, arrangement, axis_distances_m, settings, {}))
    distances_m.push_back(ring.gamma_m);
  return solver.rings(distances_m, progress);
}

void require_valid(const QuadratureSettings& settings) {
  algebra::require_within("rays", settings.rays, 2, 1e7);
  const auto around = static_cast<double>(settings.sectors.around);
  algebra::require_within("sectors around", around, 4, 360);
  algebra::require_within("first sector", static_cast<double>(settings.sectors.first), 0,
                          around - 1);
  algebra::require_within("sectors", static_cast<double>(settings.sectors.count), 1, around);
  algebra::require_within("harmonics", settings.harmonics, 2, 160);
  algebra::require_within("error between places", settings.place_error, 0, 1);
  algebra::require_within("ratio of darkness", settings.dark_ratio, darkness_ratio, 1);
}

}  // namespace

std::vector<RefractedLight> by_quadrature_in(std::span<const Atmosphere> airs,
                                             const Arrangement& arrangement,
                                             std::span<const double> wavelengths_nm,
                                             std::span<const double> axis_distances_m,
                                             const QuadratureSettings& settings,
                                             const algebra::Progress& progress) {
  for (const auto& air : airs) require_valid(air);
  require_valid(arrangement);
  require_valid(settings);
  const auto& first = airs.front();
  const std::size_t sectors = first.symmetric() ? 1 : settings.sectors.around;
  if (first.top_m() <= 0 || wavelengths_nm.empty() || axis_distances_m.empty())
    return {airs.size(), darkness(arrangement, wavelengths_nm, axis_distances_m, sectors)};
  std::vector<RefractedLight> all(airs.size());
  // isolated, because an error elsewhere may cancel an enclosing parallel loop and thus silently skip iterations here
  tbb::task_group_context alone(tbb::task_group_context::isolated);
  tbb::parallel_for(
      0, 1,
      [&](int) {
        const auto around = directions(first, settings);
        const auto rings = rings_of(airs, arrangement, wavelengths_nm, axis_distances_m, around,
                                    settings, progress);
        std::vector<double> distances_m;
        for (const auto& ring : rings) distances_m.push_back(ring.gamma_m);
        tbb::parallel_for(std::size_t{0}, airs.size(), [&](std::size_t i) {
          all[i] = darkness(arrangement, wavelengths_nm, distances_m, sectors);
          fill(rings, i * wavelengths_nm.size(), first, around, all[i]);
        });
      },
      alone);
  return all;
}

RefractedLight by_quadrature(const Atmosphere& atmosphere, const Arrangement& arrangement,
                             std::span<const double> wavelengths_nm,
                             std::span<const double> axis_distances_m,
                             const QuadratureSettings& settings,
                             const algebra::Progress& progress) {
  return std::move(by_quadrature_in(std::span(&atmosphere, 1), arrangement, wavelengths_nm,
                                    axis_distances_m, settings, progress)
                       .front());
}

}  // namespace coppermoon::shadow
