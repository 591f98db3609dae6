// SPDX-License-Identifier: MIT
#include "shadow/by_quadrature.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numbers>

#include "algebra/error.h"
#include "photons/limb.h"

namespace coppermoon::shadow {
namespace {

using algebra::Grid;
using atmosphere::Atmosphere;
using std::numbers::pi;

/// Width of the bins that light is gathered in, of distance from the axis: finer as rays are.
double bin_width_m(int rays) { return std::clamp(3e6 / rays, 100., 50e3); }

/// ∫ exp(k t) dt from 0 to `part`, over that from 0 to 1.
double exponential_share(double k, double part) {
  if (std::abs(k) < 1e-6) return part;
  if (k < 0) return std::expm1(k * part) / std::expm1(k);
  return std::exp(k * (part - 1)) * std::expm1(-k * part) / std::expm1(-k);
}

/// The mean between two ends of what runs exponentially from exp(x) to exp(y).
double exponential_mean(double x, double y) {
  const double k = y - x;
  return std::abs(k) < 1e-6 ? std::exp((x + y) / 2) : (std::exp(y) - std::exp(x)) / k;
}

/// ∫ T b db over the rays of one part of the limb that land in each bin of signed distance from the
/// axis, on one plane, by wavelength.
class Landed {
 public:
  Landed(const photons::WholeLimb::Part& limb, double sun_distance_m, double depth_m,
         double bin_m) {
    const std::size_t waves = limb.fans.size();
    std::vector<std::vector<double>> places(waves);  // [wavelength][ray], in bins
    double least = std::numeric_limits<double>::max(), greatest = -least;
    for (std::size_t w = 0; w < waves; ++w) {
      const auto& fan = limb.fans[w];
      for (std::size_t i = 0; i < fan.bending_rad.size(); ++i)
        places[w].push_back(landing_m(limb.radius_m + fan.impact_height_m[i], fan.bending_rad[i],
                                      sun_distance_m, depth_m) /
                            bin_m);
      const auto [low, high] = std::ranges::minmax(places[w]);
      least = std::min(least, low), greatest = std::max(greatest, high);
    }
    first_ = static_cast<int>(std::floor(least));
    light_ = Grid<double>(static_cast<std::size_t>(std::floor(greatest) - first_) + 1, waves);
    for (std::size_t w = 0; w < waves; ++w) add_fan(limb.fans[w], limb.radius_m, places[w], w);
  }

  /// The light in a bin, by wavelength; null where no ray lands.
  const double* light(int bin) const {
    if (bin < first_ || bin >= first_ + static_cast<int>(light_.rows())) return nullptr;
    return light_.row(static_cast<std::size_t>(bin - first_)).data();
  }

 private:
  void add_fan(const photons::Fan& fan, double radius_m, std::span<const double> place,
               std::size_t wave) {
    for (std::size_t i = 0; i + 1 < place.size(); ++i) {
      const double b0 = radius_m + fan.impact_height_m[i],
                   b1 = radius_m + fan.impact_height_m[i + 1];
      const double g0 = std::log(b0) - fan.optical_depth[i],
                   g1 = std::log(b1) - fan.optical_depth[i + 1];
      const double light = fan.filter[i] * (b1 - b0) * exponential_mean(g0, g1);
      if (place[i] <= place[i + 1])
        add_cell(wave, place[i], place[i + 1], light, g1 - g0);
      else
        add_cell(wave, place[i + 1], place[i], light, g0 - g1);
    }
  }

  /// Light that lands between two places and runs exponentially from one to the other.
  void add_cell(std::size_t wave, double from, double to, double light, double steepness) {
    auto bin = static_cast<int>(std::floor(from));
    double before = 0;
    for (; bin + 1 < to; ++bin) {
      const double share = exponential_share(steepness, (bin + 1 - from) / (to - from));
      light_(static_cast<std::size_t>(bin - first_), wave) += light * (share - before);
      before = share;
    }
    light_(static_cast<std::size_t>(bin - first_), wave) += light * (1 - before);
  }

  int first_;
  Grid<double> light_;  // (bin, wavelength)
};

/// A row of numbers, one a wavelength, and how often it counts.
struct Term {
  double factor;
  const double* row;
};

/// sums[w] += Σ factor row[w], four rows at a time.
void add_terms(std::vector<Term>& terms, std::span<double> sums) {
  while (terms.size() % 4 != 0) terms.push_back({0, terms.back().row});
  for (std::size_t i = 0; i < terms.size(); i += 4) {
    const auto [f0, a] = terms[i];
    const auto [f1, b] = terms[i + 1];
    const auto [f2, c] = terms[i + 2];
    const auto [f3, d] = terms[i + 3];
    for (std::size_t w = 0; w < sums.size(); ++w)
      sums[w] += (f0 * a[w] + f1 * b[w]) + (f2 * c[w] + f3 * d[w]);
  }
}

/// Half the angle, from the axis, of the part of each ring about it that lies in the disc of radius
/// a about a place: the mean over a bin of |r|, exact by the area the disc shares with circles.
std::vector<double> half_arcs(double gamma, double a, double bin_m) {
  std::vector<double> arcs;
  double below = 0;
  for (int bin = 0; bin * bin_m < gamma + a; ++bin) {
    const double r0 = bin * bin_m, r1 = r0 + bin_m, above = lens_area(gamma, r1, a);
    arcs.push_back(std::clamp((above - below) / (r1 * r1 - r0 * r0), 0., pi));
    below = above;
  }
  return arcs;
}

/// All light on one plane.
class Plane {
 public:
  Plane(const photons::WholeLimb& limb, const photons::DiscLayers& sun,
        const Arrangement& arrangement, double depth_m, double bin_m)
      : limb_(limb), sun_(sun), bin_m_(bin_m) {
    const double spread = 1 + depth_m / arrangement.sun_distance_m;
    a_ = projected_solar_radius_m(arrangement, depth_m);
    factor_ = spread * spread / (pi * a_ * a_);
    landed_.reserve(limb.parts().size());
    for (const auto& part : limb.parts())
      landed_.emplace_back(part, arrangement.sun_distance_m, depth_m, bin_m_);
  }

  /// [layer of the Sun's disc][bin]
  std::vector<std::vector<double>> arcs(double gamma) const {
    std::vector<std::vector<double>> all;
    for (const double radius : sun_.radius) all.push_back(half_arcs(gamma, a_ * radius, bin_m_));
    return all;
  }

  /// Given  arcs  of the place's axis distance; theta: its position angle
  void light(const std::vector<std::vector<double>>& arcs, double theta,
             std::span<double> ratio) const {
    std::vector<double> sums(ratio.size()), lengths(landed_.size());
    std::vector<Term> terms;
    for (std::size_t k = 0; k < arcs.size(); ++k) {
      std::fill(sums.begin(), sums.end(), 0);
      terms.clear();
      for (std::size_t bin = 0; bin < arcs[k].size(); ++bin)
        if (arcs[k][bin] > 0) {
          collect(static_cast<int>(bin), theta, arcs[k][bin], lengths, terms);
          collect(-static_cast<int>(bin) - 1, theta + pi, arcs[k][bin], lengths, terms);
        }
      add_terms(terms, sums);
      for (std::size_t w = 0; w < ratio.size(); ++w)
        ratio[w] += factor_ * sun_.brightness(k, w) * sums[w];
    }
  }

 private:
  /// What an arc of the limb sends into a bin.
  void collect(int bin, double phi, double half_arc, std::vector<double>& lengths,
               std::vector<Term>& terms) const {
    limb_.arc(phi, half_arc, lengths);
    for (std::size_t part = 0; part < lengths.size(); ++part)
      if (const auto* row = landed_[part].light(bin); row != nullptr && lengths[part] > 0)
        terms.push_back({lengths[part], row});
  }

  const photons::WholeLimb& limb_;
  const photons::DiscLayers& sun_;
  double bin_m_, a_, factor_;
  std::vector<Landed> landed_;  // by the limb's part
};

/// Light at all position angles from that towards the pole, the equator, and half way: an ellipse
/// knows no more than cos 2θ and cos 4θ.
struct Harmonics {
  std::vector<double> pole, between, equator;

  double at(std::size_t w, double theta) const {
    const double sum = pole[w] + equator[w];
    return (sum + 2 * between[w]) / 4 + (pole[w] - equator[w]) / 2 * std::cos(2 * theta) +
           (sum - 2 * between[w]) / 4 * std::cos(4 * theta);
  }
};

/// Writes one distance's light on one plane, sector by sector.
///
/// Given  rows  of each sector
void light_all_around(const Plane& plane, double gamma, bool ellipse_alone,
                      std::span<const std::span<double>> rows) {
  const auto arcs = plane.arcs(gamma);
  const double sector = 2 * pi / static_cast<double>(rows.size());
  if (!ellipse_alone) {
    for (std::size_t s = 0; s < rows.size(); ++s)
      plane.light(arcs, static_cast<double>(s) * sector, rows[s]);
    return;
  }
  const std::vector<double> none(rows[0].size());
  Harmonics harmonics{none, none, none};
  plane.light(arcs, 0, harmonics.pole);
  plane.light(arcs, pi / 4, harmonics.between);
  plane.light(arcs, pi / 2, harmonics.equator);
  for (std::size_t s = 0; s < rows.size(); ++s)
    for (std::size_t w = 0; w < none.size(); ++w)
      rows[s][w] = std::max(0., harmonics.at(w, static_cast<double>(s) * sector));  // at its rim
}

}  // namespace

RefractedLight by_quadrature(const Atmosphere& atmosphere, const Arrangement& arrangement,
                             std::span<const double> wavelengths_nm,
                             std::span<const double> axis_distances_m, int rays,
                             const algebra::Progress& progress) {
  require_valid(atmosphere);
  require_valid(arrangement);
  algebra::require_within("rays", rays, 2, 1e7);
  const std::size_t planes = arrangement.depths_m.size(), distances = axis_distances_m.size(),
                    waves = wavelengths_nm.size();
  const std::size_t sectors = atmosphere.symmetric() ? 1 : sectors_around;
  auto light = darkness(arrangement, wavelengths_nm, axis_distances_m, sectors);
  if (atmosphere.top_m() <= 0 || waves == 0) return light;
  const auto sun = photons::disc_layers(wavelengths_nm, arrangement.limb_darkening);
  const photons::WholeLimb limb(atmosphere, optics_of(atmosphere, wavelengths_nm), rays);
  const bool ellipse_alone = atmosphere.regions.empty() && sectors > 1;
  std::atomic<std::size_t> done = 0;
  for (std::size_t k = 0; k < planes; ++k) {
    const Plane plane(limb, sun, arrangement, arrangement.depths_m[k], bin_width_m(rays));
    tbb::parallel_for(std::size_t{0}, distances, [&](std::size_t d) {
      std::vector<std::span<double>> rows;
      for (std::size_t s = 0; s < sectors; ++s) rows.push_back(light.ratio[k * sectors + s].row(d));
      light_all_around(plane, axis_distances_m[d], ellipse_alone, rows);
      if (progress) progress(static_cast<double>(++done) / static_cast<double>(distances * planes));
    });
  }
  return light;
}

}  // namespace coppermoon::shadow
