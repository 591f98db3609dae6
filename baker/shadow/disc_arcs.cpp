// SPDX-License-Identifier: MIT
#include "shadow/disc_arcs.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "algebra/quadrature.h"

namespace coppermoon::shadow {
namespace {

using algebra::Grid;
using std::numbers::pi;

constexpr int nodes_an_edge = 4;
const double gauss_node = std::sqrt(0.6);  // of the outer two, the third is 0

/// Number of Gauss's nodes for an arc between borders, by its reach either way in the variable of
/// add_arc; a whole arc reaches π/2.
int nodes_over(double reach) { return 4 + static_cast<int>(std::ceil(6 * reach / (pi / 2))); }

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
  ends.insert(ends.end(), upper.begin(), upper.end());
}

void sort_out(std::vector<int>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

}  // namespace

std::array<double, 3> square_through(double from, double to, const std::array<double, 3>& values) {
  const double middle = (from + to) / 2, half = (to - from) / 2;
  const double slope = (values[2] - values[0]) / (2 * gauss_node * half),
               square = (values[0] - 2 * values[1] + values[2]) /
                        (2 * gauss_node * gauss_node * half * half);
  return {values[1] - slope * middle + square * middle * middle, slope - 2 * square * middle,
          square};
}

DiscArcs::DiscArcs(const photons::WholeLimb& limb, const photons::DiscTerms& sun, double gamma,
                   double a, double theta_rad)
    : limb_(limb), sun_(sun), gamma_(gamma), a_(a), theta_rad_(theta_rad), marks_(marks()) {
  std::vector<int> cuts;
  for (const double mark : marks_)
    for (const double whole : {std::floor(mark), std::ceil(mark)})
      cuts.push_back(static_cast<int>(whole));
  if (gamma < a) cuts.push_back(0);  // circles whole inside
  sort_out(cuts);
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) add_graded(cuts[i], cuts[i + 1], ends_);
  sort_out(ends_);
}

/// The disc's edges, and where its edge crosses the borders of regions, on this side of the axis and
/// across it.
std::vector<double> DiscArcs::marks() const {
  std::vector<double> distances{std::abs(gamma_ - a_), gamma_ + a_};
  for (const double border : limb_.borders_rad()) {
    const double along = gamma_ * std::cos(border - theta_rad_),
                 across = gamma_ * std::sin(border - theta_rad_);
    const double half_squared = a_ * a_ - across * across;
    if (half_squared <= 0) continue;
    for (const double r : {along - std::sqrt(half_squared), along + std::sqrt(half_squared)})
      distances.push_back(std::abs(r));
  }
  std::sort(distances.begin(), distances.end());
  return distances;
}

double DiscArcs::half_arc(double r) const {
  if (r + gamma_ <= a_) return pi;
  return std::acos(std::clamp((gamma_ * gamma_ + r * r - a_ * a_) / (2 * gamma_ * r), -1., 1.));
}

/// ∫ f(μ) dψ along the arc of radius r, μ² = 1 − (r² + γ² − 2 r γ cos ψ)/a², in the variable
/// asin(ψ/half arc), in which μ is smooth to its ends; from one border of the regions to the next.
void DiscArcs::add_arc(double r, double middle_rad, double weight, Grid<double>& light) const {
  const double half = half_arc(r);
  if (half == 0) return;
  const bool alike = limb_.parts().size() == 1;
  if (alike && sun_.functions.size() == 1 && sun_.functions[0] == photons::DiscFunction{1}) {
    light(0, 0) += 2 * half * weight;
    return;
  }
  std::vector<double> ends{-pi / 2, pi / 2};
  for (const double border : limb_.borders_rad()) {
    const double away = std::remainder(border - middle_rad, 2 * pi);
    if (std::abs(away) < half) ends.push_back(std::asin(away / half));
  }
  std::sort(ends.begin(), ends.end());
  if (alike) ends.front() = 0;  // both halves at once
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const double middle = (ends[i] + ends[i + 1]) / 2, reach = (ends[i + 1] - ends[i]) / 2;
    for (const auto& node : algebra::gauss_legendre(nodes_over(reach))) {
      const double t = middle + reach * node.x, psi = half * std::sin(t);
      const double length = (alike ? 2 : 1) * node.weight * reach * half * std::cos(t) * weight;
      const double cos_psi = std::cos(psi);
      const double out = (r * r + gamma_ * gamma_ - 2 * r * gamma_ * cos_psi) / (a_ * a_);
      const double mu = std::sqrt(std::max(0., 1 - out));
      const auto shares = limb_.at(middle_rad + psi);
      for (std::size_t k = 0; k < sun_.functions.size(); ++k) {
        const double shed = length * photons::value(sun_.functions[k], mu);
        for (const auto& [part, share] : shares) light(k, part) += share * shed;
      }
    }
  }
}

/// From mark to mark, in the root of the distance from the nearer.
Grid<double> DiscArcs::mean_over(int from, int to, double middle_rad) const {
  Grid<double> mean(sun_.functions.size(), limb_.parts().size());
  std::vector<double> ends{static_cast<double>(from), static_cast<double>(to)};
  for (const double mark : marks_)
    if (mark > from && mark < to) ends.insert(ends.end() - 1, mark);
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const bool edge_below = std::ranges::count(marks_, ends[i]) > 0;
    const double length = ends[i + 1] - ends[i];
    for (const auto& node : algebra::gauss_legendre(nodes_an_edge)) {
      const double t = (1 + node.x) / 2, away = length * t * t;
      add_arc(edge_below ? ends[i] + away : ends[i + 1] - away, middle_rad,
              node.weight * t * length / (to - from), mean);
    }
  }
  return mean;
}

std::vector<Stretch> DiscArcs::stretches(bool opposite, int from, int to) const {
  const double middle_rad = opposite ? theta_rad_ + pi : theta_rad_;
  std::vector<Stretch> all;
  for (std::size_t i = 0; i + 1 < ends_.size(); ++i) {
    const int low = ends_[i], high = ends_[i + 1];
    if (high <= from || low >= to) continue;
    if (high - low == 1) {
      const auto mean = mean_over(low, high, middle_rad);
      all.push_back({low, high, {mean, mean, mean}});
      continue;
    }
    Stretch stretch{low, high, {}};
    for (int n = 0; n < 3; ++n) {
      auto& light = stretch.light[static_cast<std::size_t>(n)];
      light = Grid<double>(sun_.functions.size(), limb_.parts().size());
      add_arc((low + high) / 2. + (n - 1) * gauss_node * (high - low) / 2., middle_rad, 1, light);
    }
    all.push_back(std::move(stretch));
  }
  return all;
}

}  // namespace coppermoon::shadow
