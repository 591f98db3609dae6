// SPDX-License-Identifier: MIT
#include "shadow/lookup_table.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shadow/lookup_table.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <hwy/contrib/math/math-inl.h>
#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <numbers>

HWY_BEFORE_NAMESPACE();
namespace coppermoon::shadow::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Place between two neighbouring entries of the table: the offset of the first, and the weight of the second.
template <class V>
struct Between {
  V low, part;
};

constexpr std::size_t places_at_once = 64;

/// Number of sectors used for cubic interpolation in position angle: two on either side of a place.
constexpr std::size_t sectors_about = 4;

/// Offsets and weights for reading the table at a few places. An offset `start` of -1 stands for full sunlight.
struct Found {
  std::array<std::array<std::int64_t, places_at_once>, sectors_about> start;
  std::array<double, places_at_once> along, deeper;
  std::array<std::array<double, places_at_once>, sectors_about> share;
};

template <class D, class V = hn::VFromD<D>>
Between<V> between_nodes(D d, const LookupTable& table, V axis_distance_m) {
  const hn::RebindToSigned<D> indices;
  const auto& nodes = table.nodes;
  const auto cells = hn::Set(d, static_cast<double>(nodes.parts.size()));
  const auto one = hn::Set(d, 1), size = hn::Set(d, static_cast<double>(table.values.columns()));
  const auto beyond_first = hn::Sub(axis_distance_m, hn::Set(d, nodes.first_m));
  const auto place =
      hn::Clamp(hn::Mul(beyond_first, hn::Set(d, 1 / nodes.cell_m)), hn::Zero(d), cells);
  const auto cell = hn::Min(hn::Floor(place), hn::Sub(cells, one));
  const auto index = hn::ConvertTo(indices, cell);
  const auto first = hn::GatherIndex(d, nodes.first_node.data(), index),
             parts = hn::GatherIndex(d, nodes.parts.data(), index);
  const auto along = hn::Mul(hn::Sub(place, cell), parts);
  const auto low = hn::Min(hn::Floor(along), hn::Sub(parts, one));
  return {hn::Mul(hn::Add(first, low), size), hn::Sub(along, low)};
}

template <class D, class V = hn::VFromD<D>>
Between<V> between_planes(D d, const LookupTable& table, V depth_m) {
  const auto& depths = table.depths_m;
  const auto size = static_cast<double>(table.held * table.nodes.count() * table.values.columns());
  auto low = hn::Zero(d), part = hn::Zero(d);
  for (std::size_t k = 0; k + 1 < depths.size(); ++k) {
    const auto behind = hn::Sub(depth_m, hn::Set(d, depths[k]));
    const auto here = hn::Ge(behind, hn::Zero(d));
    const auto share = hn::Mul(behind, hn::Set(d, 1 / (depths[k + 1] - depths[k])));
    low = hn::IfThenElse(here, hn::Set(d, static_cast<double>(k) * size), low);
    part = hn::IfThenElse(here, hn::Min(share, hn::Set(d, 1)), part);
  }
  return {low, part};
}

/// Position angle [rad] from north through east, 0 to 2π.
template <class D, class V = hn::VFromD<D>>
V position_angle(D d, V east, V north) {
  const auto x = hn::Abs(east), y = hn::Abs(north);
  const auto steep = hn::Gt(x, y), middle = hn::Eq(hn::Max(x, y), hn::Zero(d));
  const auto slope = hn::Div(hn::Min(x, y), hn::IfThenElse(middle, hn::Set(d, 1), hn::Max(x, y)));
  const auto pi = hn::Set(d, std::numbers::pi);
  auto angle = hn::Atan(d, slope);
  angle = hn::IfThenElse(steep, hn::Sub(hn::Set(d, std::numbers::pi / 2), angle), angle);
  angle = hn::IfThenElse(hn::Lt(north, hn::Zero(d)), hn::Sub(pi, angle), angle);
  return hn::IfThenElse(hn::Lt(east, hn::Zero(d)), hn::Sub(hn::Add(pi, pi), angle), angle);
}

template <class D, class V = hn::VFromD<D>>
V sheared_by(D d, V axis_distance_m, V deeper) {
  const auto one = hn::Set(d, 1);
  const auto shift = hn::Mul(hn::Sub(axis_distance_m, hn::Set(d, limb_m)), hn::Sub(deeper, one));
  const auto part = hn::Min(one, hn::Mul(axis_distance_m, hn::Set(d, 1 / one_limb_m)));
  return hn::MulAdd(shift, part, axis_distance_m);
}

/// Lagrange weights for cubic interpolation between four sectors at -1, 0, 1 and 2.
///
/// Given  t  place between the second sector and the third, 0 to 1
template <class D, class V = hn::VFromD<D>>
std::array<V, sectors_about> cubic_shares(D d, V t) {
  const auto one = hn::Set(d, 1), half = hn::Set(d, 0.5), sixth = hn::Set(d, 1. / 6);
  const auto before = hn::Add(t, one), behind = hn::Sub(t, one), farther = hn::Sub(behind, one);
  const auto inner = hn::Mul(hn::Mul(t, behind), sixth),
             outer = hn::Mul(hn::Mul(before, farther), half);
  return {hn::Neg(hn::Mul(inner, farther)), hn::Mul(outer, behind), hn::Neg(hn::Mul(outer, t)),
          hn::Mul(inner, before)};
}

/// Finds offsets and weights for a vector of places, beginning with place i, and stores them in `found` from k on.
template <class D>
void find_lanes(D d, const LookupTable& table, const Places& places, std::size_t i, std::size_t k,
                Found& found) {
  const hn::RebindToSigned<D> indices;
  const auto east = hn::LoadU(d, &places.east_m[i]), north = hn::LoadU(d, &places.north_m[i]);
  const auto depth = hn::LoadU(d, &places.depth_m[i]);
  const auto axis_distance = hn::Sqrt(hn::MulAdd(east, east, hn::Mul(north, north)));
  const auto sunlit =
      hn::Or(hn::Ge(axis_distance, hn::Set(d, table.end_m)), hn::Le(depth, hn::Zero(d)));
  const auto deeper = hn::Div(hn::Set(d, table.middle_depth_m), depth);
  const auto node = between_nodes(d, table, sheared_by(d, axis_distance, deeper));
  const auto plane = between_planes(d, table, depth);
  const auto store_start = [&](auto sector_start, std::int64_t* to) {
    const auto start = hn::Add(hn::Add(node.low, plane.low), sector_start);
    hn::StoreU(hn::ConvertTo(indices, hn::IfThenElse(sunlit, hn::Set(d, -1), start)), indices, to);
  };
  hn::StoreU(node.part, d, &found.along[k]);
  hn::StoreU(plane.part, d, &found.deeper[k]);
  if (table.sectors.around == 1) return store_start(hn::Zero(d), &found.start[0][k]);
  const auto count = hn::Set(d, static_cast<double>(table.sectors.around));
  const auto size = hn::Set(d, static_cast<double>(table.nodes.count() * table.values.columns()));
  const auto turn = hn::Mul(position_angle(d, east, north),
                            hn::Mul(count, hn::Set(d, 1 / (2 * std::numbers::pi))));
  const auto whole = hn::Floor(turn), first = hn::Set(d, static_cast<double>(table.sectors.first)),
             dark = hn::Set(d, static_cast<double>(table.held - 1));
  const auto start_of = [&](auto sector) {  // -1 to count + 2, as `turn` may round up to count
    auto after = hn::Sub(sector, first);
    after = hn::IfThenElse(hn::Lt(after, hn::Zero(d)), hn::Add(after, count), after);
    after = hn::IfThenElse(hn::Ge(after, count), hn::Sub(after, count), after);
    return hn::Mul(hn::Min(after, dark), size);
  };
  const auto shares = cubic_shares(d, hn::Sub(turn, whole));
  for (std::size_t s = 0; s < sectors_about; ++s) {
    store_start(start_of(hn::Add(whole, hn::Set(d, static_cast<double>(s) - 1))),
                &found.start[s][k]);
    // FAULT cubics around the axis the wrong way round: shares[s] => shares[sectors_about - 1 - s]
    hn::StoreU(shares[s], d, &found.share[s][k]);
  }
}

/// Interpolates a vector of channels at one place, as many as D has lanes.
template <class D, class V = hn::VFromD<D>>
V blended(D d, const LookupTable& table, const Found& found, std::size_t k, std::size_t channel) {
  if (found.start[0][k] < 0) return hn::LoadU(d, &table.sunlight[channel]);
  const std::size_t node = table.values.columns();
  const std::size_t plane = table.depths_m.size() > 1 ? table.held * table.nodes.count() * node : 0;
  const auto along = hn::Set(d, found.along[k]), deeper = hn::Set(d, found.deeper[k]);
  const auto mixed = [](V a, V b, V part) { return hn::MulAdd(part, hn::Sub(b, a), a); };
  const hn::Rebind<float, D> single;
  const auto load = [&](const float* at) { return hn::PromoteTo(d, hn::LoadU(single, at)); };
  const auto in_sector = [&](std::int64_t start) {
    const float* at = table.values.values().data() + start + channel;
    return mixed(mixed(load(at), load(at + node), along),
                 mixed(load(at + plane), load(at + plane + node), along), deeper);
  };
  auto value = in_sector(found.start[0][k]);
  if (table.sectors.around == 1) return value;
  auto lowest = hn::Min(value, hn::Zero(d));
  value = hn::Mul(hn::Set(d, found.share[0][k]), value);
  for (std::size_t s = 1; s < sectors_about; ++s) {
    const auto there = in_sector(found.start[s][k]);
    lowest = hn::Min(lowest, there);
    value = hn::MulAdd(hn::Set(d, found.share[s][k]), there, value);
  }
  // FAULT cubics darker than black: return hn::Max(value, lowest) => return value
  return hn::Max(value, lowest);
}

/// Writes the channels of one place, in whole vectors if there is room. The next place overwrites the surplus values.
void store(const LookupTable& table, const Found& found, std::size_t k, std::size_t place,
           std::span<double> values) {
  const hn::CappedTag<double, channel_padding> d;
  const std::size_t lanes = hn::Lanes(d);
  for (std::size_t c = 0; c < table.channels; c += lanes) {
    const auto blend = blended(d, table, found, k, c);
    const std::size_t to = place * table.channels + c;
    if (to + lanes <= values.size()) {
      hn::StoreU(blend, d, &values[to]);
      continue;
    }
    std::array<double, channel_padding> last;
    hn::StoreU(blend, d, last.data());
    std::copy_n(last.begin(), values.size() - to, &values[to]);
  }
}

void read_all(const LookupTable& table, const Places& places, std::span<double> values) {
  const hn::CappedTag<double, places_at_once> many;
  const hn::CappedTag<double, 1> one;
  const std::size_t lanes = hn::Lanes(many), count = places.depth_m.size();
  Found found;
  for (std::size_t i = 0; i < count; i += places_at_once) {
    const std::size_t here = std::min(places_at_once, count - i);
    std::size_t k = 0;
    for (; k + lanes <= here; k += lanes) find_lanes(many, table, places, i + k, k, found);
    for (; k < here; ++k) find_lanes(one, table, places, i + k, k, found);
    for (k = 0; k < here; ++k) store(table, found, k, i + k, values);
  }
}

}  // namespace coppermoon::shadow::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace coppermoon::shadow {

UnevenNodes uneven_nodes(double first_m, double cell_m, std::span<const double> parts) {
  UnevenNodes nodes{first_m, cell_m, {}, {parts.begin(), parts.end()}, {}};
  for (std::size_t cell = 0; cell < parts.size(); ++cell) {
    nodes.first_node.push_back(static_cast<double>(nodes.count()));
    for (double part = 0; part < parts[cell]; ++part)
      nodes.at_m.push_back(first_m + (static_cast<double>(cell) + part / parts[cell]) * cell_m);
  }
  nodes.at_m.push_back(first_m + static_cast<double>(parts.size()) * cell_m);
  return nodes;
}

HWY_EXPORT(read_all);

void read(const LookupTable& table, const Places& places, std::span<double> values) {
  assert(values.size() == table.channels * places.depth_m.size());
  if (table.nodes.count() > 0) return HWY_DYNAMIC_DISPATCH(read_all)(table, places, values);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = table.sunlight[i % table.channels];
}

}  // namespace coppermoon::shadow
#endif
