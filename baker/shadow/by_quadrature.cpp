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
#include "photons/limb.h"

namespace coppermoon::shadow {
namespace {

using algebra::Grid;
using atmosphere::Atmosphere;
using std::numbers::pi;

/// Width of the bins that light is gathered in, of distance from the axis: finer as rays are.
double bin_width_m(int rays) { return std::clamp(1.2e6 / rays, 100., 50e3); }

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

/// What polynomials up to squares are integrated against.
constexpr int moments = 3;

/// ∫ r^m T b db over the rays of one part of the limb that land nearer than each of evenly spaced
/// signed distances r from the axis, on one plane, by wavelength; r in bins.
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
    last_ = static_cast<int>(std::floor(greatest)) + 1;
    sums_ = Grid<double>(static_cast<std::size_t>(last_ - first_ + 1) * moments, waves);
    for (std::size_t w = 0; w < waves; ++w) add_fan(limb.fans[w], limb.radius_m, places[w], w);
    for (std::size_t row = moments; row < sums_.rows(); ++row)
      for (std::size_t w = 0; w < waves; ++w) sums_(row, w) += sums_(row - moments, w);
  }

  /// By wavelength; null where it is nothing.
  const double* up_to(int node, int moment) const {
    if (node <= first_) return nullptr;
    return sums_.row(row_of(std::min(node, last_), moment)).data();
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
    double before = 0, low = from;
    for (auto bin = static_cast<int>(std::floor(from)); bin + 1 < to; ++bin) {
      const double share = exponential_share(steepness, (bin + 1 - from) / (to - from));
      add(wave, bin, low, bin + 1, light * (share - before));
      before = share;
      low = bin + 1;
    }
    add(wave, static_cast<int>(std::floor(low)), low, to, light * (1 - before));
  }

  /// Light spread evenly over a part of a bin, put where the sum up to the bin's end will find it.
  void add(std::size_t wave, int bin, double low, double high, double light) {
    const double middle = (low + high) / 2, width = high - low;
    sums_(row_of(bin + 1, 0), wave) += light;
    sums_(row_of(bin + 1, 1), wave) += light * middle;
    sums_(row_of(bin + 1, 2), wave) += light * (middle * middle + width * width / 12);
  }

  std::size_t row_of(int node, int moment) const {
    return static_cast<std::size_t>((node - first_) * moments + moment);
  }

  int first_, last_;
  Grid<double> sums_;  // (node × moments + moment, wavelength)
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

/// A stretch of distances from the axis, in whole bins, over which the disc about a place takes in
/// arcs whose half width, as seen from the axis, is a square of the distance: through the half arcs
/// at Gauss's three nodes.
struct Stretch {
  int from, to;
  std::array<double, 3> half_arc;
};

const double gauss_node = std::sqrt(0.6);  // of the outer two, the third is 0

/// Ends between two, ever closer towards both.
void add_graded(int from, int to, std::vector<int>& ends) {
  constexpr int widest = 48;
  std::vector<int> upper;
  for (int width = 1; from < to; width = std::min(2 * width, widest)) {
    ends.push_back(from);
    upper.push_back(to);
    from += width;
    to -= width;
  }
  ends.insert(ends.end(), upper.rbegin(), upper.rend());
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
}

/// The arcs that a disc takes in, by stretches from the innermost to the outermost.
class Arcs {
 public:
  /// Given  gamma, a  of the disc, in bins;  more: distances where the limb's air changes along the
  ///                  disc's edge
  Arcs(double gamma, double a, std::span<const double> more) : gamma_(gamma), a_(a) {
    std::vector<double> marks{std::abs(gamma - a), gamma + a};
    marks.insert(marks.end(), more.begin(), more.end());
    std::vector<int> cuts;
    for (const double mark : marks)
      for (const double whole : {std::floor(mark), std::ceil(mark)})
        cuts.push_back(static_cast<int>(whole));
    std::sort(cuts.begin(), cuts.end());
    std::vector<int> ends;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) add_graded(cuts[i], cuts[i + 1], ends);
    if (gamma < a && cuts.front() > 0) ends.insert(ends.begin(), 0);  // circles whole inside
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
      stretches_.push_back(stretch(ends[i], ends[i + 1]));
  }

  const std::vector<Stretch>& stretches() const { return stretches_; }

 private:
  /// One bin has the mean, exact by the area that the disc shares with circles.
  Stretch stretch(int from, int to) const {
    if (to - from == 1) {
      const double ring = lens_area(gamma_, to, a_) - lens_area(gamma_, from, a_);
      const double mean = std::clamp(ring / (to + from), 0., pi);
      return {from, to, {mean, mean, mean}};
    }
    const double middle = (from + to) / 2., half = (to - from) / 2.;
    return {from,
            to,
            {half_arc(middle - half * gauss_node), half_arc(middle),
             half_arc(middle + half * gauss_node)}};
  }

  double half_arc(double r) const {
    if (r + gamma_ <= a_) return pi;
    return std::acos(std::clamp((gamma_ * gamma_ + r * r - a_ * a_) / (2 * gamma_ * r), -1., 1.));
  }

  double gamma_, a_;
  std::vector<Stretch> stretches_;
};

/// The polynomial in r through three values at Gauss's nodes of a stretch.
std::array<double, moments> polynomial(double from, double to,
                                       const std::array<double, 3>& values) {
  const double middle = (from + to) / 2, half = (to - from) / 2;
  const double slope = (values[2] - values[0]) / (2 * gauss_node * half),
               square = (values[0] - 2 * values[1] + values[2]) /
                        (2 * gauss_node * gauss_node * half * half);
  return {values[1] - slope * middle + square * middle * middle, slope - 2 * square * middle,
          square};
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

  void light(double gamma, double theta, std::span<double> ratio) const {
    std::vector<double> sums(ratio.size());
    std::vector<Term> terms;
    for (std::size_t k = 0; k < sun_.radius.size(); ++k) {
      const double a = a_ * sun_.radius[k];
      std::fill(sums.begin(), sums.end(), 0);
      terms.clear();
      const Arcs arcs(gamma / bin_m_, a / bin_m_, crossings(gamma, theta, a));
      for (const auto& stretch : arcs.stretches()) {
        collect(stretch, theta, false, terms);
        collect(stretch, theta + pi, true, terms);
      }
      add_terms(terms, sums);
      for (std::size_t w = 0; w < ratio.size(); ++w)
        ratio[w] += factor_ * sun_.brightness(k, w) * sums[w];
    }
    for (double& value : ratio) value = std::max(value, 0.);  // rounding
  }

 private:
  /// Distances, in bins, at which the edge of the disc crosses the borders of regions, on this side
  /// of the axis and across it.
  std::vector<double> crossings(double gamma, double theta, double a) const {
    std::vector<double> distances;
    for (const double border : limb_.borders_rad()) {
      const double along = gamma * std::cos(border - theta),
                   across = gamma * std::sin(border - theta);
      const double half_squared = a * a - across * across;
      if (half_squared <= 0) continue;
      for (const double r : {along - std::sqrt(half_squared), along + std::sqrt(half_squared)})
        distances.push_back(std::abs(r) / bin_m_);
    }
    return distances;
  }

  /// What arcs of the limb about a position angle send into a stretch; opposite: across the axis.
  void collect(const Stretch& stretch, double phi, bool opposite, std::vector<Term>& terms) const {
    const int from = opposite ? -stretch.to : stretch.from,
              to = opposite ? -stretch.from : stretch.to;
    std::array<std::vector<double>, 3> lengths;  // at each node, by part
    for (std::size_t i = 0; i < 3; ++i) {
      lengths[i].resize(landed_.size());
      limb_.arc(phi, stretch.half_arc[opposite ? 2 - i : i], lengths[i]);
    }
    for (std::size_t part = 0; part < landed_.size(); ++part) {
      const std::array<double, 3> values{lengths[0][part], lengths[1][part], lengths[2][part]};
      if (values[0] == 0 && values[1] == 0 && values[2] == 0) continue;
      const auto factors = polynomial(from, to, values);
      for (int m = 0; m < moments; ++m) {
        add(landed_[part].up_to(to, m), factors[static_cast<std::size_t>(m)], terms);
        add(landed_[part].up_to(from, m), -factors[static_cast<std::size_t>(m)], terms);
      }
    }
  }

  static void add(const double* row, double factor, std::vector<Term>& terms) {
    if (row != nullptr && factor != 0) terms.push_back({factor, row});
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
  const double sector = 2 * pi / static_cast<double>(rows.size());
  if (!ellipse_alone) {
    for (std::size_t s = 0; s < rows.size(); ++s)
      plane.light(gamma, static_cast<double>(s) * sector, rows[s]);
    return;
  }
  const std::vector<double> none(rows[0].size());
  Harmonics harmonics{none, none, none};
  plane.light(gamma, 0, harmonics.pole);
  plane.light(gamma, pi / 4, harmonics.between);
  plane.light(gamma, pi / 2, harmonics.equator);
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
