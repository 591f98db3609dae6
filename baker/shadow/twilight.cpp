// SPDX-License-Identifier: MIT
#include "shadow/twilight.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

#include "algebra/interpolation.h"
#include "photons/bending.h"
#include "shadow/padding.h"
#include "shadow/scattered_row.h"
#include "shadow/sights.h"

namespace coppermoon::shadow {
namespace {

using algebra::Grid;
using atmosphere::Amounts;
using atmosphere::Atmosphere;
using atmosphere::Column;
using std::numbers::pi;

constexpr std::size_t angles_around = 12;  // number of angles at which a ring's light is computed

double squared(double x) { return x * x; }

/// View of the limb from a place in the shadow, at one position angle around the Earth.
class View {
 public:
  View(double axis_distance_m, double depth_m, double around_rad)
      : distance_m_(std::hypot(axis_distance_m, depth_m)) {
    outwards_ = glm::dvec3(axis_distance_m, 0, depth_m) / distance_m_;
    const glm::dvec3 across(outwards_.z, 0, -outwards_.x);
    aside_ = std::cos(around_rad) * across + std::sin(around_rad) * glm::dvec3(0, 1, 0);
  }

  double distance_m() const { return distance_m_; }

  /// Unit vector along which light travels from the limb to the viewpoint in the shadow.
  glm::dvec3 direction(double impact_m) const {
    const double sine = impact_m / distance_m_;
    return std::sqrt(1 - sine * sine) * outwards_ - sine * aside_;
  }

  glm::dvec3 at(const SightPoint& point) const {
    const double sine = point.impact_m / distance_m_;
    const auto lowest = std::sqrt(1 - sine * sine) * aside_ + sine * outwards_;
    return point.impact_m * lowest + point.along_m * direction(point.impact_m);
  }

 private:
  double distance_m_;
  glm::dvec3 outwards_, aside_;
};

/// Twilight from one column of air, in several atmospheres whose columns differ only in amounts of absorbers.
class Ring {
 public:
  /// Given  richest  column with the largest amounts of absorbers in any atmosphere (atmosphere::richest)
  ///        columns  the column in each atmosphere
  Ring(const Column& richest, std::span<const Column* const> columns, double radius_m,
       std::span<const atmosphere::Optics> optics)
      : column_(richest),
        radius_m_(radius_m),
        slants_(richest, photons::ProfileTable(richest), radius_m),
        points_(points_on_sights(richest, slants_, radius_m)) {
    for (const auto* column : columns) airs_.push_back(in_air(*column, optics));
  }

  /// Adds this ring's light per radian of position angle around the Earth. `ratio` holds the padded wavelengths of the
  /// first atmosphere, then of the second, and so on.
  void add(const View& view, std::span<double> ratio) const {
    const auto phase = scattering(column_, view.direction(radius_m_).z);
    const std::size_t waves = ratio.size() / airs_.size();
    for (const auto& point : points_) {
      const auto here = view.at(point);
      const double lowest = std::hypot(here.x, here.y) - radius_m_;
      // FAULT dust behind the Earth is in sunlight: here.z > 0 => false
      if (lowest < 0 && here.z > 0) continue;
      const double lit_from = here.z < 0 ? point.altitude_m : lowest;
      const bool above = std::min(lit_from, point.lowest_m) >= column_.cloud_top_m;
      if (std::ranges::all_of(airs_, [&](const InAir& air) { return air.dark[above]; })) continue;
      Amounts scattered = point.profile;
      for (std::size_t k = 0; k < phase.size(); ++k) scattered[k] *= phase[k];
      auto passed = slants_.up_to(lowest, here.z);
      for (std::size_t k = 0; k < passed.size(); ++k) passed[k] += point.onward[k];
      for (std::size_t i = 0; i < airs_.size(); ++i)
        if (!airs_[i].dark[above])
          add_scattered(scattered, passed, airs_[i].spectra, airs_[i].filters.row(above),
                        ratio.subspan(i * waves, waves));
    }
    for (double& value : ratio) value /= squared(view.distance_m());
  }

 private:
  struct InAir {
    Grid<double> spectra;        ///< (absorber, wavelength)
    Grid<double> filters;        ///< (layer, wavelength); layer 0 is below the cloud's top
    std::array<bool, 2> dark{};  ///< [layer] whether its filter is 0 at all wavelengths
  };

  static InAir in_air(const Column& column, std::span<const atmosphere::Optics> optics) {
    const std::size_t waves = padded(optics.size(), waves_together);
    InAir air{{atmosphere::absorbers, waves}, {2, waves}};
    for (std::size_t w = 0; w < optics.size(); ++w) {
      const auto spectra = atmosphere::spectra(column, optics[w]);
      for (std::size_t k = 0; k < spectra.size(); ++k) air.spectra(k, w) = spectra[k];
      air.filters(0, w) = limb_filter(column, optics[w], column.cloud_top_m - 1);
      air.filters(1, w) = limb_filter(column, optics[w], column.cloud_top_m);
    }
    for (const std::size_t above : {0, 1})
      air.dark[above] =
          std::ranges::all_of(air.filters.row(above), [](double share) { return share == 0; });
    return air;
  }

  Column column_;
  double radius_m_;
  Slants slants_;
  std::vector<SightPoint> points_;
  std::vector<InAir> airs_;
};

/// Light of a ring, indexed by [angle][wavelength]. Angles are counted from the direction of the place, and cover
/// half a circle, which the other half mirrors. The atmospheres' padded wavelengths follow one after another.
using AroundTheRing = std::vector<std::vector<double>>;

/// Weights (angle, node) with which an even function is interpolated trigonometrically, from nodes over a half circle
/// to `angles` angles around the full circle.
Grid<double> between_angles(std::size_t angles) {
  constexpr std::size_t half = angles_around / 2;
  Grid<double> shares(angles / 2 + 1, half + 1);
  for (std::size_t a = 0; a < shares.rows(); ++a)
    for (std::size_t node = 0; node <= half; ++node) {
      const double of_both_sides = node == 0 || node == half ? 1 : 2;
      for (std::size_t m = 0; m <= half; ++m) {
        const double harmonic = (m == 0 || m == half ? 1 : 2) / static_cast<double>(angles_around);
        shares(a, node) +=
            of_both_sides * harmonic *
            std::cos(2 * pi * static_cast<double>(m * node) / angles_around) *
            std::cos(2 * pi * static_cast<double>(m * a) / static_cast<double>(angles));
      }
    }
  return shares;
}

/// Light that a place in the shadow receives from a ring, by angle around the ring.
///
/// Given  shares  weights from `between_angles`
///        waves   padded number of wavelengths, in all atmospheres together
AroundTheRing around(const Ring& ring, double axis_distance_m, double depth_m,
                     const Grid<double>& shares, std::size_t waves) {
  AroundTheRing nodes(shares.columns(), std::vector<double>(waves)),
      light(shares.rows(), std::vector<double>(waves));
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    const double psi = 2 * pi * static_cast<double>(a) / angles_around;
    if (a > 0 && axis_distance_m == 0)
      nodes[a] = nodes[0];
    else
      ring.add(View(axis_distance_m, depth_m, psi), nodes[a]);
  }
  for (std::size_t a = 0; a < light.size(); ++a)
    for (std::size_t node = 0; node < nodes.size(); ++node)
      for (std::size_t w = 0; w < waves; ++w) light[a][w] += shares(a, node) * nodes[node][w];
  return light;
}

/// One Ring for each column of air; nothing for columns that do not occur at the limb.
std::vector<std::optional<Ring>> rings_of(std::span<const Atmosphere> airs,
                                          std::span<const double> wavelengths_nm) {
  const auto rich = atmosphere::richest(airs);
  const double radius = (atmosphere::limb_at(rich.earth, 0).radius_m +
                         atmosphere::limb_at(rich.earth, pi / 2).radius_m) /
                        2;
  const auto optics = optics_of(rich, wavelengths_nm);
  const auto richest = rich.columns();
  const auto used = rich.columns_in_use();
  std::vector<std::optional<Ring>> rings(richest.size());
  tbb::parallel_for(std::size_t{0}, richest.size(), [&](std::size_t c) {
    if (!used[c]) return;
    std::vector<const Column*> columns;
    for (const auto& air : airs) columns.push_back(air.columns()[c]);
    rings[c].emplace(*richest[c], columns, radius, optics);
  });
  return rings;
}

/// Adds the twilight that one sector receives from the whole ring, each part of which has its own air.
///
/// Given  first_wave  index of this atmosphere's first wavelength in the rings' light
void gather(const Atmosphere& atmosphere, const std::vector<AroundTheRing>& rings,
            std::size_t sector, std::size_t angles, double factor, std::size_t first_wave,
            std::span<double> ratio) {
  for (std::size_t a = 0; a < angles; ++a) {
    const double phi = 2 * pi * static_cast<double>(a + sector) / static_cast<double>(angles);
    for (const auto& [column, share] : atmosphere.shares_at(phi)) {
      if (share == 0) continue;
      const auto& light = rings[column][std::min(a, angles - a)];
      for (std::size_t w = 0; w < ratio.size(); ++w)
        ratio[w] += share * factor * light[first_wave + w];
    }
  }
}

/// Increasing multiples of a step that enclose a list of values, or the sorted list itself if that is not longer.
std::vector<double> coarser(std::vector<double> list, double step) {
  std::ranges::sort(list);
  const double first = std::floor(list.front() / step), last = std::ceil(list.back() / step);
  if (last - first + 1 >= static_cast<double>(list.size())) return list;
  std::vector<double> coarse;
  for (double i = first; i <= last; ++i) coarse.push_back(i * step);
  return coarse;
}

std::vector<algebra::OnLine> all_on_line(std::span<const double> x,
                                         std::span<const double> values) {
  std::vector<algebra::OnLine> all;
  for (const double value : values) all.push_back(algebra::on_line(x, value));
  return all;
}

}  // namespace

std::vector<RefractedLight> twilight_in(std::span<const Atmosphere> airs,
                                        const Arrangement& arrangement,
                                        std::span<const double> wavelengths_nm,
                                        std::span<const double> axis_distances_m) {
  require_valid(arrangement);
  std::vector<Atmosphere> all;
  for (const auto& air : airs) {
    require_valid(air);
    all.push_back(with_fewer_belts(air));
  }
  const std::size_t planes = arrangement.depths_m.size(), distances = axis_distances_m.size(),
                    waves = wavelengths_nm.size(), waves_apart = padded(waves, waves_together);
  const std::size_t sectors = all.front().one_column() ? 1 : sectors_around;
  const std::size_t angles = std::max(angles_around, sectors);
  std::vector<RefractedLight> lights(
      all.size(), darkness(arrangement, wavelengths_nm, axis_distances_m, sectors));
  if (all.front().top_m() <= 0 || waves == 0) return lights;
  const auto rings = rings_of(all, wavelengths_nm);
  const auto shares = between_angles(angles);
  tbb::parallel_for(std::size_t{0}, planes * distances, [&](std::size_t i) {
    const std::size_t k = i / distances, d = i % distances;
    const double depth = arrangement.depths_m[k];
    std::vector<AroundTheRing> around_rings(rings.size());
    tbb::parallel_for(std::size_t{0}, rings.size(), [&](std::size_t r) {
      if (rings[r])
        around_rings[r] =
            around(*rings[r], axis_distances_m[d], depth, shares, all.size() * waves_apart);
    });
    const double factor =
        squared(1 + depth / arrangement.sun_distance_m) * 2 * pi / static_cast<double>(angles);
    for (std::size_t air = 0; air < all.size(); ++air)
      for (std::size_t s = 0; s < sectors; ++s)
        gather(all[air], around_rings, s, angles, factor, air * waves_apart,
               lights[air].ratio[k * sectors + s].row(d));
  });
  return lights;
}

RefractedLight twilight(const Atmosphere& atmosphere, const Arrangement& arrangement,
                        std::span<const double> wavelengths_nm,
                        std::span<const double> axis_distances_m) {
  return std::move(
      twilight_in(std::span(&atmosphere, 1), arrangement, wavelengths_nm, axis_distances_m)
          .front());
}

std::vector<RefractedLight> twilight_about(const RefractedLight& light,
                                           std::span<const Atmosphere> airs) {
  constexpr double step_nm = 5;  // step of the table of ozone's cross-sections
  constexpr double step_m = 1000e3;
  const auto& depths_m = light.arrangement.depths_m;
  auto on_one_plane = light.arrangement;
  on_one_plane.depths_m = {std::midpoint(depths_m.front(), depths_m.back())};
  return twilight_in(airs, on_one_plane, coarser(light.wavelengths_nm, step_nm),
                     coarser(light.axis_distances_m, step_m));
}

void add_between(const RefractedLight& more, RefractedLight& light) {
  const double sun_m = light.arrangement.sun_distance_m, from_m = more.arrangement.depths_m.front();
  const auto waves = all_on_line(more.wavelengths_nm, light.wavelengths_nm);
  std::vector<double> there(more.wavelengths_nm.size());
  for (std::size_t plane = 0; plane < light.arrangement.depths_m.size(); ++plane) {
    const double depth_m = light.arrangement.depths_m[plane], nearer = from_m / depth_m,
                 brighter = squared(nearer * (1 + depth_m / sun_m) / (1 + from_m / sun_m));
    std::vector<double> distances_m;
    for (const double distance_m : light.axis_distances_m)
      distances_m.push_back(nearer * distance_m);
    const auto distances = all_on_line(more.axis_distances_m, distances_m);
    for (std::size_t sector = 0; sector < light.sectors; ++sector) {
      const std::size_t before = sector * more.sectors / light.sectors;
      const double further = static_cast<double>(sector * more.sectors % light.sectors) /
                             static_cast<double>(light.sectors);
      const auto &coarse = more.ratio[before], &next = more.ratio[(before + 1) % more.sectors];
      auto& ratio = light.ratio[plane * light.sectors + sector];
      for (std::size_t d = 0; d < distances.size(); ++d) {
        const auto& [below, above, farther] = distances[d];
        for (std::size_t w = 0; w < there.size(); ++w)
          there[w] =
              brighter * std::lerp(std::lerp(coarse(below, w), next(below, w), further),
                                   std::lerp(coarse(above, w), next(above, w), further), farther);
        for (std::size_t w = 0; w < waves.size(); ++w)
          // FAULT scattered light in the place of refracted: += std::lerp => = std::lerp
          ratio(d, w) += std::lerp(there[waves[w].below], there[waves[w].above], waves[w].further);
      }
    }
  }
}

void add_twilight_in(std::span<RefractedLight> lights, std::span<const Atmosphere> airs) {
  const auto& first = lights.front();
  if (first.wavelengths_nm.empty() || first.axis_distances_m.empty()) return;
  const auto more = twilight_about(first, airs);
  tbb::parallel_for(std::size_t{0}, lights.size(),
                    [&](std::size_t i) { add_between(more[i], lights[i]); });
}

void add_twilight(RefractedLight& light, const Atmosphere& atmosphere) {
  add_twilight_in(std::span(&light, 1), std::span(&atmosphere, 1));
}

void add_starlight(RefractedLight& light) {
  for (auto& grid : light.ratio)
    for (double& value : grid.values()) value += starlight_ratio;
}

}  // namespace coppermoon::shadow
