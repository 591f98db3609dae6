// SPDX-License-Identifier: MIT
#include "shadow/by_quadrature.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <numbers>

#include "algebra/error.h"
#include "photons/limb.h"
#include "shadow/disc_arcs.h"
#include "shadow/landed_light.h"

namespace coppermoon::shadow {
namespace {

using algebra::Grid;
using atmosphere::Atmosphere;
using std::numbers::pi;

/// Width of the bins that light is gathered in, of distance from the axis: finer as rays are.
double bin_width_m(int rays) { return std::clamp(1.2e6 / rays, 100., 50e3); }

/// What one term of the Sun's disc draws from one part of the limb.
struct Draw {
  std::size_t part, term;
  std::vector<NodeTerm> nodes;
};

/// Where light is asked for on a plane, and where it is written, by wavelength.
struct Place {
  double gamma_m, theta_rad;
  std::span<double> ratio;
};

/// All light on one plane.
class Plane {
 public:
  Plane(const photons::WholeLimb& limb, const photons::DiscTerms& sun,
        const Arrangement& arrangement, double depth_m, double bin_m)
      : limb_(limb), sun_(sun), bin_m_(bin_m) {
    const double spread = 1 + depth_m / arrangement.sun_distance_m;
    a_ = projected_solar_radius_m(arrangement, depth_m);
    factor_ = spread * spread / (pi * a_ * a_);
    landed_.reserve(limb.parts().size());
    for (const auto& part : limb.parts())
      landed_.emplace_back(part, arrangement.sun_distance_m, depth_m, bin_m_);
  }

  /// Adds each place's light to its row.
  void light(std::span<const Place> places) const {
    std::vector<std::vector<Draw>> all;
    for (const auto& place : places) all.push_back(draws(place.gamma_m, place.theta_rad));
    for (std::size_t first = 0; first < sun_.brightness.columns(); first += lanes)
      for (std::size_t p = 0; p < places.size(); ++p) add_block(all[p], first, places[p].ratio);
    for (const auto& place : places)
      for (double& value : place.ratio) value = std::max(value, 0.);  // rounding
  }

 private:
  void add_block(std::span<const Draw> all, std::size_t first, std::span<double> ratio) const {
    const std::size_t count = std::min(lanes, ratio.size() - first);
    for (const auto& [part, term, nodes] : all) {
      alignas(lanes * sizeof(double)) std::array<double, lanes> sums{};
      landed_[part].add(nodes, first / lanes, sums);
      for (std::size_t i = 0; i < count; ++i)
        ratio[first + i] += factor_ * sun_.brightness(term, first + i) * sums[i];
    }
  }

  std::vector<Draw> draws(double gamma, double theta) const {
    const std::size_t parts = landed_.size();
    std::vector<Draw> all;
    for (std::size_t term = 0; term < sun_.functions.size(); ++term)
      for (std::size_t part = 0; part < parts; ++part) all.push_back({part, term, {}});
    const DiscArcs arcs(limb_, sun_, gamma / bin_m_, a_ / bin_m_, theta);
    int first = std::numeric_limits<int>::max(), last = -first;
    for (const auto& landed : landed_)
      first = std::min(first, landed.first()), last = std::max(last, landed.last());
    for (const auto& stretch : arcs.stretches(false, first, last))
      collect(stretch, stretch.from, stretch.to, false, all);
    for (const auto& stretch : arcs.stretches(true, -last, -first))
      collect(stretch, -stretch.to, -stretch.from, true, all);
    std::erase_if(all, [](const Draw& one) { return one.nodes.empty(); });
    return all;
  }

  void collect(const Stretch& stretch, int from, int to, bool mirrored, std::span<Draw> all) const {
    for (auto& [part, term, nodes] : all) {
      std::array<double, 3> light;
      for (std::size_t n = 0; n < 3; ++n)
        light[n] = stretch.light[mirrored ? 2 - n : n](term, part);
      if (light == std::array<double, 3>{}) continue;
      const auto factors = square_through(from, to, light);
      add(landed_[part], to, factors, 1, nodes);
      add(landed_[part], from, factors, -1, nodes);
    }
  }

  /// One stretch begins where another ends: a node counts once for both.
  static void add(const LandedLight& landed, int node, const std::array<double, moments>& factors,
                  double sign, std::vector<NodeTerm>& nodes) {
    if (node <= landed.first()) return;
    const int held = std::min(node, landed.last());
    const auto recent = static_cast<std::ptrdiff_t>(std::min<std::size_t>(nodes.size(), 2));
    auto here = std::find_if(nodes.end() - recent, nodes.end(),
                             [&](const NodeTerm& one) { return one.node == held; });
    if (here == nodes.end()) here = nodes.insert(here, {held, {}});
    for (std::size_t m = 0; m < moments; ++m) here->factors[m] += sign * factors[m];
  }

  const photons::WholeLimb& limb_;
  const photons::DiscTerms& sun_;
  double bin_m_, a_, factor_;
  std::vector<LandedLight> landed_;  // by the limb's part
};

/// Light at all position angles from that towards the pole, the equator, and half way: an ellipse
/// knows no more than cos 2θ and cos 4θ.
struct Harmonics {
  double pole, between, equator;

  double at(double theta) const {
    const double sum = pole + equator;
    return (sum + 2 * between) / 4 + (pole - equator) / 2 * std::cos(2 * theta) +
           (sum - 2 * between) / 4 * std::cos(4 * theta);
  }
};

/// The places that are computed: each sector's; on an ellipsoid without regions only those towards
/// its pole, its equator and half way.
class Places {
 public:
  Places(RefractedLight& light, std::size_t plane, bool ellipse_alone,
         const QuadratureSettings& settings)
      : light_(light), plane_(plane), ellipse_alone_(ellipse_alone) {
    const auto& distances = light.axis_distances_m;
    if (ellipse_alone) {
      harmonics_ = Grid<double>(distances.size() * 3, light.wavelengths_nm.size());
      for (std::size_t i = 0; i < harmonics_.rows(); ++i)
        all_.push_back({distances[i / 3], static_cast<double>(i % 3) * pi / 4, harmonics_.row(i)});
      return;
    }
    for (std::size_t i = 0; i < std::min(light.sectors, settings.sectors); ++i)
      for (std::size_t d = 0; d < distances.size(); ++d) {
        const std::size_t s = (settings.first_sector + i) % light.sectors;
        all_.push_back({distances[d], sector_angle(s), sector(s).row(d)});
      }
  }

  std::span<const Place> all() const { return all_; }

  /// What the sectors between those computed have of them.
  void finish() {
    if (!ellipse_alone_) return;
    for (std::size_t d = 0; d < light_.axis_distances_m.size(); ++d)
      for (std::size_t s = 0; s < light_.sectors; ++s)
        for (std::size_t w = 0; w < harmonics_.columns(); ++w) {
          const Harmonics of{harmonics_(3 * d, w), harmonics_(3 * d + 1, w),
                             harmonics_(3 * d + 2, w)};
          sector(s)(d, w) = std::max(0., of.at(sector_angle(s)));  // at its rim
        }
  }

 private:
  double sector_angle(std::size_t s) const {
    return 2 * pi * static_cast<double>(s) / static_cast<double>(light_.sectors);
  }
  Grid<double>& sector(std::size_t s) { return light_.ratio[plane_ * light_.sectors + s]; }

  RefractedLight& light_;
  std::size_t plane_;
  bool ellipse_alone_;
  Grid<double> harmonics_;  // (distance × 3 + angle, wavelength)
  std::vector<Place> all_;
};

void require_valid(const QuadratureSettings& settings) {
  algebra::require_within("rays", settings.rays, 2, 1e7);
  algebra::require_within("first sector", static_cast<double>(settings.first_sector), 0,
                          sectors_around - 1);
  algebra::require_within("sectors", static_cast<double>(settings.sectors), 1, sectors_around);
}

/// Places computed together, so that a block's sums stay at hand.
constexpr std::size_t together = 64;

}  // namespace

RefractedLight by_quadrature(const Atmosphere& atmosphere, const Arrangement& arrangement,
                             std::span<const double> wavelengths_nm,
                             std::span<const double> axis_distances_m,
                             const QuadratureSettings& settings,
                             const algebra::Progress& progress) {
  require_valid(atmosphere);
  require_valid(arrangement);
  require_valid(settings);
  const std::size_t planes = arrangement.depths_m.size();
  const std::size_t sectors = atmosphere.symmetric() ? 1 : sectors_around;
  auto light = darkness(arrangement, wavelengths_nm, axis_distances_m, sectors);
  if (atmosphere.top_m() <= 0 || wavelengths_nm.empty()) return light;
  const auto sun =
      photons::disc_terms(wavelengths_nm, arrangement.limb_darkening, settings.sun_terms);
  const photons::WholeLimb limb(atmosphere, optics_of(atmosphere, wavelengths_nm), settings.rays);
  const bool ellipse_alone = atmosphere.regions.empty() && sectors > 1;
  std::atomic<std::size_t> done = 0;
  for (std::size_t k = 0; k < planes; ++k) {
    const Plane plane(limb, sun, arrangement, arrangement.depths_m[k], bin_width_m(settings.rays));
    Places places(light, k, ellipse_alone, settings);
    const std::size_t count = places.all().size();
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, together), [&](const auto& range) {
      plane.light(places.all().subspan(range.begin(), range.size()));
      if (progress)
        progress(static_cast<double>(done += range.size()) / static_cast<double>(count * planes));
    });
    places.finish();
  }
  return light;
}

}  // namespace coppermoon::shadow
