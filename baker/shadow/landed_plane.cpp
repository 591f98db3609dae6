// SPDX-License-Identifier: MIT
#include "shadow/landed_plane.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "shadow/landed_rows.h"

namespace coppermoon::shadow {
namespace {

using photons::WholeLimb;
using std::numbers::pi;

/// Number of position angles in the table of which parts of the limb lie where (Around::here_).
constexpr int looked_at = 1440;

/// Number of harmonics needed for light at an axis distance, given in radii of the projected Sun. Fewer are needed near
/// the axis, where a place receives light from more of the limb.
std::size_t harmonics_at(double solar_radii) {
  return static_cast<std::size_t>(9 + 48 * solar_radii);
}

/// Adds the nodes of LandedLight at both ends of a Stretch, unless the previous one has already added the first node.
///
/// Returned  index of the first of the two nodes
std::size_t add_ends(int from, int to, std::vector<int>& nodes) {
  if (nodes.empty() || nodes.back() != from) nodes.push_back(from);
  nodes.push_back(to);
  return nodes.size() - 2;
}

}  // namespace

Around::Around(const WholeLimb& limb, int highest, std::span<const double> angles_rad)
    : parts(limb.series(highest)),
      turns(angles_rad.size(), 2 * parts[0].cosine.size()),
      angles_rad_(angles_rad.begin(), angles_rad.end()),
      here_(parts.size(), 2 * looked_at + 1) {
  for (std::size_t i = 0; i < angles_rad.size(); ++i)
    for (std::size_t m = 0; m < harmonics(); ++m) {
      turns(i, 2 * m) = std::cos(static_cast<double>(m) * angles_rad[i]);
      turns(i, 2 * m + 1) = std::sin(static_cast<double>(m) * angles_rad[i]);
    }
  for (std::size_t m = 0; m < harmonics(); ++m)
    for (const bool sine : {false, true}) {
      Harmonic one{m, 2 * m + (sine ? 1 : 0), {}};
      for (const auto& part : parts) one.weights.push_back(sine ? part.sine[m] : part.cosine[m]);
      if (std::ranges::any_of(one.weights, [](double weight) { return weight != 0; }))
        harmonics_.push_back(std::move(one));
    }
  for (int i = 0; i < 2 * looked_at; ++i)
    for (const auto& [part, share] : limb.at(2 * pi * i / looked_at))
      if (share > 0) here_(part, static_cast<std::size_t>(i) + 1) = 1;
  for (std::size_t p = 0; p < parts.size(); ++p)
    for (std::size_t i = 1; i < here_.columns(); ++i) here_(p, i) += here_(p, i - 1);
}

std::span<const Around::Harmonic> Around::some(std::size_t count) const {
  const auto end = std::ranges::find_if(
      harmonics_, [&](const Harmonic& harmonic) { return harmonic.harmonic >= count; });
  return {harmonics_.begin(), end};
}

bool Around::is_mirrored() const {
  return std::ranges::all_of(parts, [](const auto& part) {
    return std::ranges::all_of(part.sine, [](double sine) { return sine == 0; });
  });
}

bool Around::is_near(std::size_t part, std::size_t angle, double half_arc_rad) const {
  constexpr double a_direction = 2 * pi / looked_at;
  const int half = static_cast<int>(std::ceil(half_arc_rad / a_direction)) + 1;
  if (2 * half >= looked_at / 2) return true;
  const int middle = static_cast<int>(std::lround(angles_rad_[angle] / a_direction));
  for (const int about : {middle, middle + looked_at / 2}) {
    const int from = ((about - half) % looked_at + looked_at) % looked_at;
    const auto row = here_.row(part);
    if (row[static_cast<std::size_t>(from + 2 * half + 1)] > row[static_cast<std::size_t>(from)])
      return true;
  }
  return false;
}

LandedPlane::LandedPlane(const Sunlit& sunlit, double depth_m) : sunlit_(sunlit) {
  const double sun_m = sunlit.arrangement.sun_distance_m, spread = 1 + depth_m / sun_m;
  a_ = projected_solar_radius_m(sunlit.arrangement, depth_m);
  plane_ = {sun_m, depth_m, sunlit.bin_m, sunlit.farthest_m + a_};
  factor_ = spread * spread / (pi * a_ * a_);
  const auto [least, most] = std::ranges::minmax(
      sunlit.waves, {}, [](const Wave& wave) { return wave.optics.refractivity; });
  for (std::size_t p = 0; p < sunlit.limb.parts().size(); ++p)
    for (const auto& wave : {least, most}) {
      const auto fan = sunlit.limb.fan(p, wave.optics, *wave.air);
      const double radius_m = sunlit.limb.parts()[p].radius_m;
      const auto [straightest, most_bent] = std::ranges::minmax(fan.bending_rad);
      const auto [lowest, highest] = std::ranges::minmax(fan.impact_height_m);
      const double from = landing_m(radius_m + lowest, most_bent, sun_m, depth_m),
                   to = landing_m(radius_m + highest, straightest, sun_m, depth_m);
      first_ = std::min(first_, static_cast<int>(std::floor(from / sunlit.bin_m)));
      last_ = std::max(last_, plane_.end_of(to / sunlit.bin_m));
    }
  last_ = std::max(first_, last_);
}

/// Number of blocks of wavelengths held in memory at once. All are held if, on all planes together, they take at most
/// 1.25 GB, or 0.5 GB for over 128 wavelengths (of which a few then decide where to insert axis distances). Otherwise,
/// a plane holds as many as fit into 0.5 GB, because the disc must be divided again for every group of blocks.
std::size_t LandedPlane::blocks_at_once() const {
  constexpr std::size_t many = 128, most_bytes = 500'000'000;
  const std::size_t most_kept = sunlit_.waves.size() > many ? 500'000'000 : 1'250'000'000;
  const std::size_t a_block = sunlit_.limb.parts().size() *
                              static_cast<std::size_t>(last_ - first_) * moments * lanes *
                              sizeof(double);
  if (a_block * blocks() * sunlit_.arrangement.depths_m.size() <= most_kept) return blocks();
  return std::max<std::size_t>(1, std::min(most_bytes / a_block, blocks() - 1));
}

LandedPlane::Blocks LandedPlane::landed(std::size_t first) const {
  Blocks some{first, std::min(blocks_at_once(), blocks() - first)};
  const auto& parts = sunlit_.limb.parts();
  std::vector<std::optional<LandedLight>> found(some.count * parts.size());
  tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t i) {
    const std::size_t part = i % parts.size(), wave = (first + i / parts.size()) * lanes;
    std::vector<photons::Fan> fans;
    for (std::size_t w = wave; w < std::min(wave + lanes, sunlit_.waves.size()); ++w)
      fans.push_back(sunlit_.limb.fan(part, sunlit_.waves[w].optics, *sunlit_.waves[w].air));
    found[i].emplace(fans, plane_, parts[part].radius_m);
  });
  for (auto& one : found) some.landed.push_back(std::move(*one));
  return some;
}

/// Whether light is computed as a series of harmonics instead of angle by angle. If the air in the west mirrors
/// that in the east, the estimated cost decides. Otherwise, the axis distance decides, so that light at an angle does
/// not depend on which other angles are requested.
bool LandedPlane::by_series(double gamma_m) const {
  const auto& around = sunlit_.around;
  if (around.harmonics() <= 3) return true;
  if (!around.is_mirrored()) return gamma_m <= a_;
  constexpr double angles_at_once = 1. / 12;  // fraction of the limb that a group of angles spans
  const auto count = [](std::size_t n) { return static_cast<double>(n); };
  const double parts = count(around.parts.size()), terms = count(sunlit_.sun.functions.size()),
               harmonics = count(std::min(around.harmonics(), harmonics_at(gamma_m / a_))),
               groups = std::ceil(count(around.angles()) / angles_together);
  const double near =
      gamma_m > a_ ? std::min(1., 2 * std::asin(a_ / gamma_m) / pi + angles_at_once) : 1;
  return harmonics * (parts + terms) * count(blocks()) <=
         groups * near * parts * terms * (angles_together * count(blocks()) + harmonics);
}

void LandedPlane::light(std::span<const Place> places, const std::function<void(double)>& done) {
  constexpr std::size_t at_once = 64;  // number of places computed together, limited by memory
  const auto pairs_done = [&](std::size_t blocks_by_places) {
    if (done)
      done(static_cast<double>(blocks_by_places) / static_cast<double>(blocks() * places.size()));
  };
  for (std::size_t first = 0; first < blocks();) {
    if (landed_.landed.empty()) landed_ = landed(first);
    for (std::size_t from = 0; from < places.size(); from += at_once)
      add_light(places.subspan(from, std::min(at_once, places.size() - from)), pairs_done);
    first += landed_.count;
    if (!keeps_light()) landed_ = {};  // frees the memory before the next blocks are computed
  }
  for (const auto& place : places)
    for (double& value : place.ratio) value = std::max(value, 0.);  // may be negative by rounding
}

/// Adds the landed light to places in the shadow. The order of the loops suits the cache: for series, all places for
/// one block of wavelengths; for single angles, all blocks for one place.
void LandedPlane::add_light(std::span<const Place> places,
                            const std::function<void(std::size_t)>& pairs_done) const {
  constexpr std::size_t places_a_task = 8;
  const std::size_t groups = (sunlit_.around.angles() + angles_together - 1) / angles_together;
  std::vector<Draws> drawn(places.size());
  tbb::parallel_for(std::size_t{0}, places.size(), [&](std::size_t p) {
    auto here = draws(places[p].gamma_m);
    if (by_series(places[p].gamma_m)) {
      drawn[p] = std::move(here);
      return;
    }
    if (!here.nodes.empty())  // empty if no light lands there
      tbb::parallel_for(tbb::blocked_range<std::size_t>(0, groups), [&](const auto& some) {
        for (std::size_t g = some.begin(); g < some.end(); ++g)
          add_angles(here, landed_, g * angles_together, places[p].ratio);
      });
    pairs_done(landed_.count);
  });
  tbb::parallel_for(std::size_t{0}, landed_.count, [&](std::size_t block) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, places.size(), places_a_task),
                      [&](const auto& some) {
                        for (std::size_t p = some.begin(); p < some.end(); ++p) {
                          if (!by_series(places[p].gamma_m)) continue;
                          if (!drawn[p].nodes.empty())
                            add_series(drawn[p], landed_, block, places[p].ratio);
                          pairs_done(1);
                        }
                      });
  });
}

double LandedPlane::seen(std::size_t term, std::size_t wave) const {
  return factor_ * sunlit_.sun.brightness(term, wave);
}

void LandedPlane::add_series(const Draws& draws, const Blocks& blocks, std::size_t block,
                             std::span<double> ratio) const {
  const auto& around = sunlit_.around;
  const std::size_t waves = sunlit_.waves.size(), wave = (blocks.first + block) * lanes,
                    count = std::min(lanes, waves - wave), terms = sunlit_.sun.functions.size();
  const auto harmonics = around.some(draws.factors.rows());
  algebra::Grid<double> sums(harmonics.size(), terms * lanes);
  std::vector<HarmonicRows> rows;
  for (std::size_t h = 0; h < harmonics.size(); ++h)
    rows.push_back({harmonics[h].weights.data(), draws.factors.row(harmonics[h].harmonic).data(),
                    sums.row(h).data()});
  const std::size_t all = around.parts.size();
  add_landed_rows(std::span(blocks.landed).subspan(block * all, all), draws.nodes, terms, rows);
  std::vector<Block> series(harmonics.size());
  for (std::size_t h = 0; h < harmonics.size(); ++h)
    for (std::size_t term = 0; term < terms; ++term)
      for (std::size_t i = 0; i < count; ++i)
        series[h][i] += seen(term, wave + i) * sums(h, term * lanes + i);
  for (std::size_t angle = 0; angle < around.angles(); ++angle) {
    Block light{};
    for (std::size_t h = 0; h < harmonics.size(); ++h)
      for (std::size_t i = 0; i < lanes; ++i)
        light[i] += around.turns(angle, harmonics[h].turn) * series[h][i];
    for (std::size_t i = 0; i < count; ++i) ratio[angle * waves + wave + i] += light[i];
  }
}

/// Adds light at a group of neighbouring position angles.
void LandedPlane::add_angles(const Draws& draws, const Blocks& blocks, std::size_t first_angle,
                             std::span<double> ratio) const {
  const auto& around = sunlit_.around;
  const std::size_t all = around.parts.size(), harmonics = draws.factors.rows(),
                    count = std::min(angles_together, around.angles() - first_angle);
  const double half_arc = std::asin(std::min(1., a_ / draws.gamma_m));
  std::vector<std::size_t> parts;  // parts of the limb that send light to any of the angles
  std::vector<std::vector<double>> turns;
  for (std::size_t p = 0; p < all; ++p) {
    std::vector<double> shares(harmonics * angles_together);
    bool any = false;
    for (std::size_t i = 0; i < count; ++i) {
      if (!around.is_near(p, first_angle + i, half_arc)) continue;
      any = true;
      const auto turn = around.turns.row(first_angle + i);
      for (std::size_t m = 0; m < harmonics; ++m)
        shares[m * angles_together + i] =
            around.parts[p].cosine[m] * turn[2 * m] + around.parts[p].sine[m] * turn[2 * m + 1];
    }
    if (any) parts.push_back(p), turns.push_back(std::move(shares));
  }
  std::vector<double> turned;
  turn_factors(draws.factors, turns, turned);
  const std::size_t waves = sunlit_.waves.size(), terms = sunlit_.sun.functions.size();
  for (std::size_t block = 0; block < blocks.count; ++block) {
    std::vector<double> sums(terms * angles_together * lanes);
    for (std::size_t k = 0; k < parts.size(); ++k) {
      add_turned_rows(blocks.landed[block * all + parts[k]], draws.nodes,
                      &turned[k * draws.factors.columns() * angles_together], terms, sums.data());
    }
    const std::size_t wave = (blocks.first + block) * lanes;
    for (std::size_t term = 0; term < terms; ++term)
      for (std::size_t i = 0; i < count; ++i)
        for (std::size_t w = wave; w < std::min(wave + lanes, waves); ++w)
          ratio[(first_angle + i) * waves + w] +=
              seen(term, w) * sums[(term * angles_together + i) * lanes + w - wave];
  }
}

LandedPlane::Draws LandedPlane::draws(double gamma) const {
  const std::size_t harmonics = std::min(sunlit_.around.harmonics(), harmonics_at(gamma / a_));
  const auto stretches =
      disc_stretches(sunlit_.sun, gamma / sunlit_.bin_m, a_ / sunlit_.bin_m,
                     static_cast<int>(harmonics) - 1, 0, std::max(-first_, last_));
  Draws all{gamma, {}, {}};
  struct Drawn {
    const Stretch& stretch;
    bool across;
    std::size_t node;
  };
  std::vector<Drawn> drawn;
  for (const bool across : {false, true})
    for (const auto& stretch : stretches) {
      const int inner = across ? -stretch.from : stretch.from,
                outer = across ? -stretch.to : stretch.to;
      if (std::min(inner, outer) < last_ && std::max(inner, outer) > first_)
        drawn.push_back({stretch, across, add_ends(inner, outer, all.nodes)});
    }
  all.factors = {harmonics, all.nodes.size() * sunlit_.sun.functions.size() * moments};
  for (const auto& [stretch, across, node] : drawn) collect(stretch, across, node, all);
  return all;
}

/// Adds to `all` the factors by which the moments of landed light at the two ends of a Stretch are multiplied. If
/// `across` is true, they are for light that has crossed the axis, otherwise for light that has not.
///
/// Given  node  index of the node at the stretch's inner end; the next node is at its outer end
void LandedPlane::collect(const Stretch& stretch, bool across, std::size_t node, Draws& all) {
  const int low = across ? -stretch.to : stretch.from, high = across ? -stretch.from : stretch.to;
  // quadratics that equal 1 at one Gauss node and 0 at the other two
  std::array<std::array<double, moments>, 3> squares;
  for (std::size_t n = 0; n < 3; ++n) {
    std::array<double, 3> one{};
    one[n] = 1;
    squares[n] = square_through(low, high, one);
  }
  const std::size_t terms = stretch.light[0].rows();
  for (std::size_t harmonic = 0; harmonic < all.factors.rows(); ++harmonic) {
    const double sign = across && harmonic % 2 == 1 ? -1 : 1, inner = across ? 1 : -1;
    for (std::size_t term = 0; term < terms; ++term) {
      double* at_inner = &all.factors(harmonic, (node * terms + term) * moments);
      double* at_outer = at_inner + terms * moments;
      for (std::size_t n = 0; n < 3; ++n) {
        const double light = sign * inner * stretch.light[across ? 2 - n : n](term, harmonic);
        for (std::size_t m = 0; m < moments; ++m) {
          at_inner[m] += light * squares[n][m];
          at_outer[m] -= light * squares[n][m];
        }
      }
    }
  }
}

}  // namespace coppermoon::shadow
