// SPDX-License-Identifier: MIT
#include "shadow/landed_plane.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shadow/weighted_rows.h"

namespace coppermoon::shadow {
namespace {

using photons::WholeLimb;

/// How many of them light has that far from the axis, in radii of the projected Sun: the nearer, the
/// more of the limb a place sees at once.
std::size_t harmonics_at(double solar_radii) {
  return static_cast<std::size_t>(9 + 48 * solar_radii);
}

/// One stretch begins where another ends: a node counts once for both.
int place_of(int node, std::vector<int>& nodes) {
  if (nodes.empty() || nodes.back() != node) nodes.push_back(node);
  return static_cast<int>(nodes.size()) - 1;
}

void add(int node, const std::array<double, moments>& factors, double sign,
         std::vector<NodeTerm>& nodes) {
  if (nodes.empty() || nodes.back().node != node) nodes.push_back({node, {}});
  for (std::size_t m = 0; m < moments; ++m) nodes.back().factors[m] += sign * factors[m];
}

}  // namespace

Around::Around(const photons::WholeLimb& limb, int highest, std::span<const double> angles_rad)
    : parts(limb.series(highest)), turns(angles_rad.size(), 2 * parts[0].cosine.size()) {
  for (std::size_t i = 0; i < angles_rad.size(); ++i)
    for (std::size_t m = 0; m < harmonics(); ++m) {
      turns(i, 2 * m) = std::cos(static_cast<double>(m) * angles_rad[i]);
      turns(i, 2 * m + 1) = std::sin(static_cast<double>(m) * angles_rad[i]);
    }
}

LandedPlane::LandedPlane(const photons::WholeLimb& limb, const Around& around,
                         const photons::DiscTerms& sun, const Arrangement& arrangement,
                         double depth_m, double bin_m)
    : around_(around), sun_(sun), bin_m_(bin_m) {
  const double spread = 1 + depth_m / arrangement.sun_distance_m;
  a_ = projected_solar_radius_m(arrangement, depth_m);
  factor_ = spread * spread / (std::numbers::pi * a_ * a_);
  landed_.reserve(limb.parts().size());
  for (const auto& part : limb.parts())
    landed_.emplace_back(part, arrangement.sun_distance_m, depth_m, bin_m_);
  for (const auto& landed : landed_)
    first_ = std::min(first_, landed.first()), last_ = std::max(last_, landed.last());
}

void LandedPlane::light(std::span<const Place> places) const {
  std::vector<Draws> all;
  for (const auto& place : places) all.push_back(draws(place.gamma_m));
  for (std::size_t first = 0; first < sun_.brightness.columns(); first += lanes)
    for (std::size_t p = 0; p < places.size(); ++p) add_block(all[p], first, places[p].ratio);
  for (const auto& place : places)
    for (double& value : place.ratio) value = std::max(value, 0.);  // rounding
}

void LandedPlane::add_block(const Draws& ring, std::size_t first, std::span<double> ratio) const {
  std::vector<Block> series(2 * ring.draws.back().harmonic + 2);
  std::vector<double> rows(ring.nodes.size() * moments * lanes);
  const std::span<const Draw> all(ring.draws);
  for (std::size_t m = 0, terms = sun_.functions.size(); 2 * m < series.size(); ++m)
    for (const auto part : {&WholeLimb::Series::cosine, &WholeLimb::Series::sine})
      if (gathered(ring.nodes, first / lanes, m, part, rows))
        add_terms(all.subspan(m * terms, terms), rows, first,
                  series[2 * m + (part == &WholeLimb::Series::sine ? 1 : 0)]);
  const std::size_t waves = sun_.brightness.columns(), count = std::min(lanes, waves - first);
  for (std::size_t angle = 0; angle < around_.turns.rows(); ++angle) {
    const auto turns = around_.turns.row(angle);
    Block light{};
    for (std::size_t m = 0; m < series.size(); ++m)
      for (std::size_t i = 0; i < lanes; ++i) light[i] += turns[m] * series[m][i];
    for (std::size_t i = 0; i < count; ++i) ratio[angle * waves + first + i] += light[i];
  }
}

/// Writes the sums of the whole limb up to each node, of one harmonic's cosines or sines.
///
/// Returned  whether it has any
bool LandedPlane::gathered(std::span<const int> nodes, std::size_t block, std::size_t harmonic,
                           Harmonics part, std::vector<double>& rows) const {
  bool any = false;
  for (std::size_t p = 0; p < landed_.size(); ++p) {
    const double weight = (around_.parts[p].*part)[harmonic];
    if (weight == 0) continue;
    if (!any) std::ranges::fill(rows, 0);
    landed_[p].add(nodes, block, weight, rows);
    any = true;
  }
  return any;
}

/// Adds what the terms of the Sun's disc draw of that.
void LandedPlane::add_terms(std::span<const Draw> draws, std::span<const double> rows,
                            std::size_t first, Block& light) const {
  for (const auto& draw : draws) {
    alignas(lanes * sizeof(double)) Block sums{};
    add_weighted_rows(rows.data(), draw.nodes, sums.data());
    for (std::size_t i = 0; i < std::min(lanes, sun_.brightness.columns() - first); ++i)
      light[i] += factor_ * sun_.brightness(draw.term, first + i) * sums[i];
  }
}

LandedPlane::Draws LandedPlane::draws(double gamma) const {
  const std::size_t harmonics = std::min(around_.harmonics(), harmonics_at(gamma / a_));
  Draws all;
  for (std::size_t m = 0; m < harmonics; ++m)
    for (std::size_t term = 0; term < sun_.functions.size(); ++term)
      all.draws.push_back({term, m, {}});
  const DiscArcs arcs(sun_, gamma / bin_m_, a_ / bin_m_, static_cast<int>(harmonics) - 1);
  const auto stretches = arcs.stretches(0, std::max(-first_, last_));
  for (const auto& stretch : stretches)
    if (stretch.from < last_ && stretch.to > first_) collect(stretch, false, all);
  for (const auto& stretch : stretches)
    if (-stretch.to < last_ && -stretch.from > first_) collect(stretch, true, all);
  return all;
}

/// Light that lands on the place's side of the axis, or across it from the limb opposite.
void LandedPlane::collect(const Stretch& stretch, bool across, Draws& all) {
  const int inner = across ? -stretch.from : stretch.from,
            outer = across ? -stretch.to : stretch.to;
  const int at_inner = place_of(inner, all.nodes), at_outer = place_of(outer, all.nodes);
  for (auto& [term, harmonic, nodes] : all.draws) {
    const double sign = across && harmonic % 2 == 1 ? -1 : 1;
    std::array<double, 3> light;
    for (std::size_t n = 0; n < 3; ++n)
      light[n] = sign * stretch.light[across ? 2 - n : n](term, harmonic);
    const auto factors = square_through(std::min(inner, outer), std::max(inner, outer), light);
    add(at_inner, factors, across ? 1 : -1, nodes);
    add(at_outer, factors, across ? -1 : 1, nodes);
  }
}

}  // namespace coppermoon::shadow
