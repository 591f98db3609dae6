// SPDX-License-Identifier: MIT
#include "shadow/disc_arcs.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "algebra/quadrature.h"
#include "shadow/landed_rows.h"
#include "shadow/padding.h"

namespace coppermoon::shadow {
namespace {

using algebra::Grid;
using std::numbers::pi;

constexpr int nodes_an_edge = 4;
const double gauss_node = std::sqrt(0.6);  // the Gauss nodes: −gauss_node, 0 and gauss_node

/// Quadrature node t, between 0 and π/2, for half an arc: sin t, and the node's weight times cos t.
struct ArcNode {
  double sine, weight;
};

/// Gauss nodes over half an arc that is divided into equal parts, with `count` nodes in each of them.
std::vector<ArcNode> nodes_in_parts(int count, int parts) {
  std::vector<ArcNode> all;
  const double reach = pi / 4 / parts;
  for (int part = 0; part < parts; ++part)
    for (const auto& node : algebra::gauss_legendre(count)) {
      const double t = reach * (2 * part + 1 + node.x);
      all.push_back({std::sin(t), node.weight * reach * std::cos(t)});
    }
  return all;
}

/// The Gauss nodes for a whole arc that lie in its positive half.
std::vector<ArcNode> nodes_of_a_whole(int count) {
  std::vector<ArcNode> all;
  for (const auto& node : algebra::gauss_legendre(count))
    if (node.x > 0) {
      const double t = pi / 2 * node.x;
      all.push_back({std::sin(t), node.weight * pi / 2 * std::cos(t)});
    }
  return all;
}

/// Nodes over half an arc, as many as are needed for the highest harmonic.
const std::vector<ArcNode>& arc_nodes(int highest, double half_arc_rad) {
  static const auto alike = nodes_in_parts(7, 1), twice_around = nodes_of_a_whole(10);
  if (highest == 0) return alike;
  if (highest <= 2) return twice_around;
  constexpr int a_part = 12, parts = 48;
  // FAULT arcs of high harmonics over too few nodes: phase = 9 => phase = 90
  constexpr double phase = 9;  // largest phase [rad] of a harmonic in one part of an arc
  static const auto finer = [] {
    std::vector<std::vector<ArcNode>> all;
    for (int i = 1; i <= parts; ++i) all.push_back(nodes_in_parts(a_part, i));
    return all;
  }();
  const auto i = static_cast<std::size_t>(highest * half_arc_rad / phase);
  return finer[std::min(i, finer.size() - 1)];
}

/// Greatest width of a Stretch [bins]. Over it, the highest harmonic changes by only a fraction of a period.
int widest(double a, int highest) {
  if (highest <= 2) return 48;
  return static_cast<int>(std::clamp(3 * a / highest, 1., 24.));
}

/// Divides a range of bins into intervals (Stretch) that are narrower towards both ends, and adds their ends to `ends`.
void add_graded(int from, int to, int widest, std::vector<int>& ends) {
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

/// The Sun's disc, projected around a place in the shadow. The unit of length is the width of a bin of axis distance.
struct Disc {
  const photons::DiscTerms& sun;
  double gamma, a;
  int highest;
  std::array<double, 2> edges{std::abs(gamma - a),
                              gamma + a};  ///< axis distances of the disc's nearer and farther edge

  double half_arc(double r) const {
    if (r + gamma <= a) return pi;
    return std::acos(std::clamp((gamma * gamma + r * r - a * a) / (2 * gamma * r), -1., 1.));
  }

  Grid<double> darkness() const {
    return {sun.functions.size(), static_cast<std::size_t>(highest) + 1};
  }

  /// Adds ∫ f(μ) cos mψ dψ along the arc of radius r, where μ² = 1 − (r² + γ² − 2 r γ cos ψ)/a². The variable of
  /// integration is asin(ψ/half arc), because μ is smooth in it up to the arc's ends. cos mψ is found by recurrence.
  void add_arc(double r, double weight, Grid<double>& light) const {
    const double half = half_arc(r);
    if (half == 0) return;
    if (highest == 0 && sun.functions.size() == 1 && sun.functions[0] == photons::DiscFunction{1}) {
      light(0, 0) += 2 * half * weight;
      return;
    }
    const auto& nodes = arc_nodes(highest, half);
    const std::size_t whole = padded(nodes.size(), nodes_together);
    std::vector<double> cosines(whole);
    Grid<double> shed(sun.functions.size(), whole);
    for (std::size_t j = 0; j < nodes.size(); ++j) cosines[j] = half * nodes[j].sine;
    turn_into_cosines(cosines);
    for (std::size_t j = 0; j < nodes.size(); ++j) {
      const double out = (r * r + gamma * gamma - 2 * r * gamma * cosines[j]) / (a * a);
      const double mu = std::sqrt(std::max(0., 1 - out));
      for (std::size_t k = 0; k < sun.functions.size(); ++k)
        shed(k, j) = 2 * half * weight * nodes[j].weight * photons::value(sun.functions[k], mu);
    }
    add_harmonics(cosines, shed, light);
  }

  /// Mean of the integrals along arcs (add_arc) over a bin at the disc's edge, by quadrature in √(distance from it).
  Grid<double> mean_over(int from, int to) const {
    auto mean = darkness();
    std::vector<double> ends{static_cast<double>(from), static_cast<double>(to)};
    for (const double edge : edges)
      if (edge > from && edge < to) ends.insert(ends.end() - 1, edge);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      const bool edge_below = std::ranges::count(edges, ends[i]) > 0;
      const double length = ends[i + 1] - ends[i];
      for (const auto& node : algebra::gauss_legendre(nodes_an_edge)) {
        const double t = (1 + node.x) / 2, away = length * t * t;
        add_arc(edge_below ? ends[i] + away : ends[i + 1] - away,
                node.weight * t * length / (to - from), mean);
      }
    }
    return mean;
  }

  /// Ends of the intervals (Stretch) into which the disc is divided; they are narrower towards the disc's edges.
  std::vector<int> ends() const {
    std::vector<int> cuts, all;
    for (const double edge : edges)
      for (const double whole : {std::floor(edge), std::ceil(edge)})
        cuts.push_back(static_cast<int>(whole));
    if (gamma < a) cuts.push_back(0);  // near the axis, the disc contains whole circles about it
    sort_out(cuts);
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
      add_graded(cuts[i], cuts[i + 1], widest(a, highest), all);
    sort_out(all);
    return all;
  }
};

}  // namespace

std::array<double, 3> square_through(double from, double to, const std::array<double, 3>& values) {
  const double middle = (from + to) / 2, half = (to - from) / 2;
  const double slope = (values[2] - values[0]) / (2 * gauss_node * half),
               square = (values[0] - 2 * values[1] + values[2]) /
                        (2 * gauss_node * gauss_node * half * half);
  return {values[1] - slope * middle + square * middle * middle, slope - 2 * square * middle,
          square};
}

std::vector<Stretch> disc_stretches(const photons::DiscTerms& sun, double gamma, double a,
                                    int highest, int from, int to) {
  const Disc disc{sun, gamma, a, highest};
  const auto ends = disc.ends();
  std::vector<Stretch> all;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const int low = ends[i], high = ends[i + 1];
    if (high <= from || low >= to) continue;
    if (high - low == 1) {
      const auto mean = disc.mean_over(low, high);
      all.push_back({low, high, {mean, mean, mean}});
      continue;
    }
    Stretch stretch{low, high, {disc.darkness(), disc.darkness(), disc.darkness()}};
    for (int n = 0; n < 3; ++n)
      disc.add_arc((low + high) / 2. + (n - 1) * gauss_node * (high - low) / 2., 1,
                   stretch.light[static_cast<std::size_t>(n)]);
    all.push_back(std::move(stretch));
  }
  return all;
}

}  // namespace coppermoon::shadow
