// SPDX-License-Identifier: MIT
#include "shadow/by_quadrature.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <numbers>

#include "algebra/error.h"
#include "algebra/quadrature.h"
#include "photons/limb.h"

namespace coppermoon::shadow {
namespace {

using algebra::Grid;
using atmosphere::Atmosphere;
using std::numbers::pi;

constexpr double spacing_m = 2e3;  // of C(r)
constexpr int nodes_a_piece = 12;

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

/// C(r) of one part of the limb on one plane, by wavelength.
class Landed {
 public:
  Landed(const photons::WholeLimb::Part& limb, double sun_distance_m, double depth_m) {
    const std::size_t waves = limb.fans.size();
    std::vector<std::vector<double>> radii(waves);
    double least = std::numeric_limits<double>::max(), greatest = -least;
    for (std::size_t w = 0; w < waves; ++w) {
      const auto& fan = limb.fans[w];
      for (std::size_t i = 0; i < fan.bending_rad.size(); ++i)
        radii[w].push_back(landing_m(limb.radius_m + fan.impact_height_m[i], fan.bending_rad[i],
                                     sun_distance_m, depth_m));
      const auto [low, high] = std::ranges::minmax(radii[w]);
      least = std::min(least, low), greatest = std::max(greatest, high);
    }
    first_m_ = least, last_m_ = greatest;
    cumulative_ = Grid<double>(static_cast<std::size_t>((greatest - least) / spacing_m) + 3, waves);
    for (std::size_t w = 0; w < waves; ++w) add_fan(limb.fans[w], limb.radius_m, radii[w], w);
  }

  /// Where the lowest and the highest ray land: beyond, C is constant.
  std::array<double, 2> ends_m() const { return {first_m_, last_m_}; }

  /// sums[w] += factor C(r)
  void add(double r_m, double factor, std::span<double> sums) const {
    const double last = static_cast<double>(cumulative_.rows() - 1);
    const double at = std::clamp((r_m - first_m_) / spacing_m, 0., last);
    const auto node = std::min(static_cast<std::size_t>(at), cumulative_.rows() - 2);
    const double part = at - static_cast<double>(node);
    const auto low = cumulative_.row(node), high = cumulative_.row(node + 1);
    const double f0 = factor * (1 - part), f1 = factor * part;
    for (std::size_t w = 0; w < sums.size(); ++w) sums[w] += f0 * low[w] + f1 * high[w];
  }

 private:
  void add_fan(const photons::Fan& fan, double radius_m, std::span<const double> r,
               std::size_t wave) {
    std::vector<double> bins(cumulative_.rows());
    for (std::size_t i = 0; i + 1 < r.size(); ++i) {
      const double b0 = radius_m + fan.impact_height_m[i],
                   b1 = radius_m + fan.impact_height_m[i + 1];
      const double g0 = std::log(b0) - fan.optical_depth[i],
                   g1 = std::log(b1) - fan.optical_depth[i + 1];
      const double light = fan.filter[i] * (b1 - b0) * exponential_mean(g0, g1);
      if (r[i] <= r[i + 1])
        add_cell(bins, r[i], r[i + 1], light, g1 - g0);
      else
        add_cell(bins, r[i + 1], r[i], light, g0 - g1);
    }
    double sum = 0;
    for (std::size_t n = 0; n < bins.size(); ++n) cumulative_(n, wave) = sum += bins[n];
  }

  /// Light that lands between two places: bins[n] takes what lies between node n − 1 and node n.
  void add_cell(std::vector<double>& bins, double from_m, double to_m, double light,
                double steepness) const {
    const double from = (from_m - first_m_) / spacing_m, to = (to_m - first_m_) / spacing_m;
    auto node = static_cast<std::size_t>(from) + 1;
    double before = 0;
    for (; static_cast<double>(node) < to; ++node) {
      const double share =
          exponential_share(steepness, (static_cast<double>(node) - from) / (to - from));
      bins[node] += light * (share - before);
      before = share;
    }
    bins[node] += light * (1 - before);
  }

  double first_m_, last_m_;
  Grid<double> cumulative_;  // (node, wavelength)
};

/// A line through the axis that the disc about a place cuts, and how much of φ it stands for.
struct Chord {
  double psi, dpsi, from_m, to_m;
};

/// One smooth range of ψ, by Gauss–Legendre in t: ψ itself, or where the disc lies off the axis
/// sin ψ = (a/γ) sin t, about 0 or about π.
void add_chords(double gamma, double a, double t0, double t1, double about,
                std::vector<Chord>& chords) {
  const bool off_axis = gamma > a;
  for (const auto& [x, weight] : algebra::gauss_legendre(nodes_a_piece)) {
    const double t = (t0 + t1) / 2 + (t1 - t0) / 2 * x;
    const double sine = off_axis ? a / gamma * std::sin(t) : std::sin(t);
    const double cosine = off_axis ? std::sqrt(1 - sine * sine) * std::cos(about) : std::cos(t);
    const double stretch = off_axis ? a / gamma * std::cos(t) / std::abs(cosine) : 1;
    const double half =
        off_axis ? a * std::cos(t) : std::sqrt(std::max(0., a * a - gamma * gamma * sine * sine));
    chords.push_back({std::atan2(sine * (off_axis ? std::cos(about) : 1), cosine),
                      weight * (t1 - t0) / 2 * stretch, gamma * cosine - half,
                      gamma * cosine + half});
  }
}

/// All chords of the disc of radius a about a place γ off the axis.
///
/// Given  borders  angles ψ where the limb's air changes, −π to π
std::vector<Chord> chords_of(double gamma, double a, std::span<const double> borders) {
  std::vector<Chord> chords;
  const auto pieces = [&](double about, std::vector<double> ends) {
    std::sort(ends.begin(), ends.end());
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
      if (ends[i + 1] - ends[i] > 1e-12) add_chords(gamma, a, ends[i], ends[i + 1], about, chords);
  };
  if (gamma <= a) {
    std::vector<double> ends{-pi, -pi / 2, 0, pi / 2, pi};
    ends.insert(ends.end(), borders.begin(), borders.end());
    pieces(0, ends);
    return chords;
  }
  for (const double about : {0., pi}) {
    std::vector<double> ends{-pi / 2, 0, pi / 2};
    for (const double psi : borders) {
      const double off = std::remainder(psi - about, 2 * pi);
      if (std::abs(off) < pi / 2 && std::abs(gamma * std::sin(off)) < a)
        ends.push_back(std::asin(gamma * std::sin(off) / a));
    }
    pieces(about, ends);
  }
  return chords;
}

/// All light on one plane.
class Plane {
 public:
  Plane(const photons::WholeLimb& limb, const photons::DiscLayers& sun,
        const Arrangement& arrangement, double depth_m)
      : limb_(limb), sun_(sun) {
    const double spread = 1 + depth_m / arrangement.sun_distance_m;
    a_ = projected_solar_radius_m(arrangement, depth_m);
    factor_ = spread * spread / (pi * a_ * a_);
    landed_.reserve(limb.parts().size());
    for (const auto& part : limb.parts())
      landed_.emplace_back(part, arrangement.sun_distance_m, depth_m);
  }

  void light(double gamma, double theta, std::span<double> ratio) const {
    std::vector<double> borders, sums(ratio.size());
    for (const double border : limb_.borders_rad())
      borders.push_back(std::remainder(border - theta, 2 * pi));
    for (std::size_t k = 0; k < sun_.radius.size(); ++k) {
      std::fill(sums.begin(), sums.end(), 0);
      const double a = a_ * sun_.radius[k];
      auto ends = borders;
      add_ends_of_light(gamma, a, ends);
      for (const auto& chord : chords_of(gamma, a, ends)) add(chord, theta + chord.psi, sums);
      for (std::size_t w = 0; w < ratio.size(); ++w)
        ratio[w] += factor_ * sun_.brightness(k, w) * sums[w];
    }
    for (double& value : ratio) value = std::max(value, 0.);  // rounding
  }

 private:
  void add(const Chord& chord, double phi, std::span<double> sums) const {
    for (const auto& [part, share] : limb_.at(phi)) {
      if (share == 0) continue;
      landed_[part].add(chord.to_m, chord.dpsi * share, sums);
      landed_[part].add(chord.from_m, -chord.dpsi * share, sums);
    }
  }

  /// Where the disc's edge crosses the circles on which light ends.
  void add_ends_of_light(double gamma, double a, std::vector<double>& borders) const {
    for (const auto& landed : landed_)
      for (const double r : landed.ends_m()) {
        const double cosine = (gamma * gamma + r * r - a * a) / (2 * gamma * r);
        if (!(std::abs(cosine) < 1)) continue;
        borders.push_back(std::acos(cosine));
        borders.push_back(-std::acos(cosine));
      }
  }

  const photons::WholeLimb& limb_;
  const photons::DiscLayers& sun_;
  double a_, factor_;
  std::vector<Landed> landed_;  // by the limb's part
};

/// The sector in the first quarter that has the same light, where only the ellipsoid tells sectors
/// apart.
std::size_t mirrored(std::size_t sector, std::size_t sectors) {
  const std::size_t half = sector % (sectors / 2);
  return std::min(half, sectors / 2 - half);
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
  RefractedLight light{arrangement,
                       {wavelengths_nm.begin(), wavelengths_nm.end()},
                       {axis_distances_m.begin(), axis_distances_m.end()},
                       sectors,
                       {planes * sectors, Grid<double>(distances, waves)},
                       {planes * sectors, Grid<double>(distances, waves)}};
  if (atmosphere.top_m() <= 0 || waves == 0) return light;
  const auto sun = photons::disc_layers(wavelengths_nm, arrangement.limb_darkening);
  const photons::WholeLimb limb(atmosphere, optics_of(atmosphere, wavelengths_nm), rays);
  const bool quarters = atmosphere.regions.empty() && sectors > 1;
  std::atomic<std::size_t> done = 0;
  for (std::size_t k = 0; k < planes; ++k) {
    const Plane plane(limb, sun, arrangement, arrangement.depths_m[k]);
    tbb::parallel_for(std::size_t{0}, distances, [&](std::size_t d) {
      for (std::size_t s = 0; s < sectors; ++s) {
        auto ratio = light.ratio[k * sectors + s].row(d);
        const std::size_t same = quarters ? mirrored(s, sectors) : s;
        const auto source = light.ratio[k * sectors + same].row(d);
        if (same < s)
          std::copy(source.begin(), source.end(), ratio.begin());
        else
          plane.light(axis_distances_m[d],
                      2 * pi * static_cast<double>(s) / static_cast<double>(sectors), ratio);
      }
      if (progress) progress(static_cast<double>(++done) / static_cast<double>(distances * planes));
    });
  }
  return light;
}

}  // namespace coppermoon::shadow
