// SPDX-License-Identifier: MIT
#include "shadow/lookup.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "algebra/error.h"
#include "algebra/interpolation.h"
#include "shadow/padding.h"

namespace coppermoon::shadow {
namespace {

constexpr double widest_spacing_m = 10e3;

/// Largest number of parts into which an interval of axis distance is divided. More are needed if the Sun is not
/// limb-darkened, because its limb, which appears first, is then as bright as its middle.
double most_parts(const Arrangement& arrangement) { return arrangement.limb_darkening ? 10 : 40; }

/// Axis distance beyond which refracted light is 0: half a spacing beyond the last place (the edge of its ring).
double last_distance(std::span<const double> x) {
  return x.size() < 2 ? x.back() : x.back() + (x.back() - x[x.size() - 2]) / 2;
}

std::vector<double> row_sums(const ChannelWeights& weights) {
  std::vector<double> sums(padded(weights.rows(), channel_padding));
  for (std::size_t c = 0; c < weights.rows(); ++c)
    sums[c] = std::reduce(weights.row(c).begin(), weights.row(c).end());
  return sums;
}

/// Weights of one channel. The zeros at either end are left out, because most weights of a spectral band are 0.
struct Weights {
  std::size_t first;
  std::span<const double> values;

  double sum_of(std::span<const double> ratios) const {
    return std::transform_reduce(values.begin(), values.end(),
                                 ratios.begin() + static_cast<std::ptrdiff_t>(first), 0.);
  }
};

std::vector<Weights> by_channel(const algebra::Grid<double>& weights) {
  const auto counts = [](double weight) { return weight != 0; };
  std::vector<Weights> all;
  for (std::size_t c = 0; c < weights.rows(); ++c) {
    const auto row = weights.row(c);
    const auto from = std::ranges::find_if(row, counts) - row.begin();
    const auto end = std::find_if(row.rbegin(), row.rend() - from, counts).base() - row.begin();
    const auto first = static_cast<std::size_t>(from);
    all.push_back({first, row.subspan(first, static_cast<std::size_t>(end) - first)});
  }
  return all;
}

/// Up to four consecutive places with known light, and their weights for a point between them.
struct Cubic {
  std::ptrdiff_t first = 0;  ///< index of the first place; −1 is the first across the axis
  std::size_t count = 0;
  std::array<double, 4> share{};
};

/// Weights for the cubic through two places on either side of a point. Outside the places, the nearest value applies.
///
/// Given  beyond_axis  number of places used beyond the axis, which are mirror images of those on this side
Cubic cubic_at(std::span<const double> x, std::size_t beyond_axis, double at) {
  if (at <= x.front() && beyond_axis == 0) return {0, 1, {1}};
  if (at >= x.back()) return {static_cast<std::ptrdiff_t>(x.size()) - 1, 1, {1}};
  const auto size = static_cast<std::ptrdiff_t>(x.size()),
             lowest = -static_cast<std::ptrdiff_t>(beyond_axis),
             above = std::upper_bound(x.begin(), x.end(), at) - x.begin(),
             count = std::min<std::ptrdiff_t>(4, size - lowest);
  Cubic cubic{
      std::min(std::max(above - 2, lowest), size - count), static_cast<std::size_t>(count), {}};
  std::array<double, 4> nodes;
  for (std::ptrdiff_t k = 0; k < count; ++k) {
    const auto place = cubic.first + k;
    nodes[static_cast<std::size_t>(k)] =
        place < 0 ? -x[static_cast<std::size_t>(-1 - place)] : x[static_cast<std::size_t>(place)];
  }
  algebra::on_polynomial(std::span(nodes).first(cubic.count), at,
                         std::span(cubic.share).first(cubic.count));
  return cubic;
}

using Rows = std::array<std::span<const double>, 4>;

/// Light at the places of a cubic, one row for each. If there are fewer than four places, the last row is repeated.
Rows rows_of(const Cubic& cubic, const algebra::Grid<double>& here,
             const algebra::Grid<double>& across) {
  Rows rows;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto place = cubic.first + static_cast<std::ptrdiff_t>(std::min(i, cubic.count - 1));
    rows[i] = place < 0 ? across.row(static_cast<std::size_t>(-1 - place))
                        : here.row(static_cast<std::size_t>(place));
  }
  return rows;
}

double on_cubic(const Cubic& cubic, const Rows& rows, std::size_t k) {
  const auto& share = cubic.share;
  return share[0] * rows[0][k] + share[1] * rows[1][k] + share[2] * rows[2][k] +
         share[3] * rows[3][k];
}

/// Limits for interpolating in the logarithm of light: relative noise, and ln(brightest / darkest) among four places.
constexpr double known_to = 1. / 3, widest_range = 7;

/// Whether to interpolate in the logarithm of light; false if a logarithm is NaN.
bool in_logarithm(const Rows& logs, std::size_t k) {
  const auto [low, high] = std::minmax({logs[0][k], logs[1][k], logs[2][k], logs[3][k]});
  const double sum = logs[0][k] + logs[1][k] + logs[2][k] + logs[3][k];
  return std::isfinite(sum) && high - low <= widest_range;
}

std::size_t sector_of(const LookupTable& table, std::size_t row) {
  return table.sectors[row / table.nodes.count() % table.held];
}

/// Whether a row of the table belongs to the dark sector, which stands for all sectors that the table does not hold.
bool is_dark(const LookupTable& table, std::size_t row) {
  return !table.sectors.all() && row / table.nodes.count() % table.held == table.held - 1;
}

/// Inputs from which a table is filled, node by node.
struct Filling {
  const RefractedLight& light;
  const DirectLight& direct;
  const ChannelWeights& weights;
  LightPart part;
  BetweenPlaces between{light};
  algebra::Grid<double> direct_weights = direct.in_layers(weights);
  std::vector<Weights> refracted_in = by_channel(weights), direct_in = by_channel(direct_weights);

  /// Given     row  index of a row of the table
  /// Returned  whether refracted light is known at this row's place
  bool fill(LookupTable& table, std::size_t row, std::span<double> ratios,
            std::span<double> clear) const {
    const std::size_t nodes = table.nodes.count(), plane = row / nodes / table.held,
                      sector = sector_of(table, row);
    const double depth_m = table.depths_m[plane];
    const double at_m = sheared(table.nodes.at_m[row % nodes], depth_m / table.middle_depth_m);
    // FAULT direct light of the north in all sectors: table.sectors.angle_rad(sector) => 0
    direct.clear_parts(at_m, table.sectors.angle_rad(sector), depth_m, clear);
    std::ranges::fill(ratios, 0);
    if (part != LightPart::direct) between.read(plane, sector, at_m, ratios);
    const double of_direct = part == LightPart::refracted ? 0 : 1;
    for (std::size_t c = 0; c < weights.rows(); ++c)
      table.values(row, c) = static_cast<float>(refracted_in[c].sum_of(ratios) +
                                                of_direct * direct_in[c].sum_of(clear));
    return between.knows(at_m);
  }
};

/// Estimated error of linear interpolation between nodes, relative to the brightest channel. It is a quarter of the
/// difference between the value at node `middle` and the mean of the values at the two nodes beside it.
double bend(const LookupTable& table, std::size_t middle) {
  double bent = 0, brightest = 0;
  for (std::size_t c = 0; c < table.channels; ++c) {
    const auto value = [&](std::size_t i) {
      return double{table.values(i, c)} / std::max(std::abs(table.sunlight[c]), 1e-300);
    };
    const double line = (value(middle - 1) + value(middle + 1)) / 2;
    bent = std::max(bent, std::abs(value(middle) - line) / 4);
    brightest = std::max(brightest, std::abs(line));
  }
  return brightest > 0 ? bent / brightest : 0;
}

/// Fills a table whose nodes have been set.
///
/// Returned  for each row, whether refracted light is known at its place
std::vector<char> fill_table(LookupTable& table, const Filling& filling) {
  const std::size_t rows = table.depths_m.size() * table.held * table.nodes.count();
  table.values = {};  // frees the coarser table before the finer one is allocated
  table.values = algebra::Grid<float>(rows, table.sunlight.size());
  std::vector<char> known(rows);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, rows, 64), [&](const auto& part) {
    std::vector<double> ratios(filling.weights.columns()), clear(filling.direct_weights.columns());
    for (std::size_t i = part.begin(); i < part.end(); ++i)
      if (!is_dark(table, i)) known[i] = filling.fill(table, i, ratios, clear);
  });
  return known;
}

/// Largest `bend` at each node, over all planes and sectors in which refracted light is known.
std::vector<double> bends(const LookupTable& table, std::span<const char> known) {
  const std::size_t nodes = table.nodes.count();
  std::vector<double> worst(nodes);
  tbb::parallel_for(std::size_t{1}, nodes - 1, [&](std::size_t node) {
    for (std::size_t i = node; i < table.values.rows(); i += nodes)
      if (known[i - 1] && known[i + 1]) worst[node] = std::max(worst[node], bend(table, i));
  });
  return worst;
}

/// Number of parts for an interval of axis distance. The error of linear interpolation falls as the spacing squared.
/// At the umbra's edge it falls as spacing^(3/2), because the Sun's uncovered area grows as distance^(3/2) there.
double parts_for(double tolerance, double error) {
  if (error <= tolerance) return 1;
  return std::ceil(std::pow(error / (0.8 * tolerance), 2. / 3));
}

/// Number of parts for each interval (cell) of axis distance, from the largest `bend` at nodes in or next to it. The
/// whole table is limited to half a gigabyte.
std::vector<double> parts_of_cells(const LookupTable& table, std::span<const double> bends,
                                   double tolerance, double most) {
  constexpr double most_values = 5e8 / sizeof(float);
  const auto cells = table.nodes.parts.size();
  const auto most_nodes = most_values * static_cast<double>(table.nodes.count()) /
                          static_cast<double>(table.values.values().size());
  std::vector<double> parts(cells);
  for (std::size_t c = 0; c < cells; ++c) {
    const std::size_t from = std::max<std::size_t>(1, c) - 1, to = std::min(c + 3, bends.size());
    const double error = *std::max_element(bends.begin() + static_cast<std::ptrdiff_t>(from),
                                           bends.begin() + static_cast<std::ptrdiff_t>(to));
    parts[c] = std::min(most, parts_for(tolerance, error));
  }
  while (most > 1 && std::reduce(parts.begin(), parts.end()) > most_nodes)
    for (--most; double& count : parts) count = std::min(count, most);
  return parts;
}

}  // namespace

BetweenPlaces::BetweenPlaces(const RefractedLight& light)
    : light_(light), from_m_(light.axis_distances_m.front()), to_m_(light.axis_distances_m.back()) {
  if (light.photons == 0) return;
  const auto& x = light.axis_distances_m;
  if (x.size() > 1 && x[0] > 0 && 2 * x[0] <= (x[1] - x[0]) * (1 + 1e-9)) {
    beyond_axis_ = 2;
    from_m_ = 0;
  }
  logs_ = light.ratio;
  tbb::parallel_for(std::size_t{0}, logs_.size(), [&](std::size_t g) {
    const auto errors = light.standard_error[g].values();
    auto values = logs_[g].values();
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = values[i] > 0 && errors[i] <= known_to * values[i] ? std::log(values[i]) : NAN;
  });
}

void BetweenPlaces::read(std::size_t plane, std::size_t sector, double at_m,
                         std::span<double> ratios) const {
  const auto& places = light_.axis_distances_m;
  if (at_m > last_distance(places)) {
    std::ranges::fill(ratios, 0.);
    return;
  }
  const std::size_t here = plane * light_.sectors + sector,
                    across = plane * light_.sectors + Sectors{light_.sectors}.opposite(sector);
  const auto cubic = cubic_at(places, beyond_axis_, at_m);
  const auto rows = rows_of(cubic, light_.ratio[here], light_.ratio[across]);
  for (std::size_t k = 0; k < ratios.size(); ++k)
    ratios[k] = std::max(0., on_cubic(cubic, rows, k));
  if (logs_.empty()) return;
  const auto logs = rows_of(cubic, logs_[here], logs_[across]);
  for (std::size_t k = 0; k < ratios.size(); ++k)
    if (in_logarithm(logs, k)) ratios[k] = std::exp(on_cubic(cubic, logs, k));
}

Lookup::Lookup(const ChannelWeights& weights, LightPart part) {
  table_.channels = weights.rows();
  table_.sunlight = row_sums(weights);
  if (part == LightPart::refracted) std::ranges::fill(table_.sunlight, 0);
}

Lookup::Lookup(const RefractedLight& light, const DirectLight& direct,
               const ChannelWeights& weights, const LookupRange& range, LightPart part)
    : Lookup(weights) {  // sets table_.sunlight, to which errors are relative
  algebra::require_within("tolerance of the look-up", range.tolerance, 1e-6, 0.1);
  table_.depths_m = light.arrangement.depths_m;
  table_.middle_depth_m = std::midpoint(table_.depths_m.front(), table_.depths_m.back());
  table_.sectors = range.sectors.in(light.sectors);
  table_.held = table_.sectors.all() ? light.sectors : table_.sectors.count + 1;
  table_.end_m = direct.penumbra_m(table_.depths_m.back());
  const double first_m = std::clamp(range.from_m, 0., table_.end_m),
               to_m = std::clamp(range.to_m, first_m, table_.end_m);
  const double cells = std::max(1., std::ceil((to_m - first_m) / widest_spacing_m));
  std::vector<double> parts(static_cast<std::size_t>(cells), 1.);
  table_.nodes = uneven_nodes(first_m, widest_spacing_m, parts);
  const Filling filling{light, direct, weights, part};
  const auto known = fill_table(table_, filling);
  parts =
      parts_of_cells(table_, bends(table_, known), range.tolerance, most_parts(light.arrangement));
  if (std::ranges::any_of(parts, [](double count) { return count > 1; })) {
    table_.nodes = uneven_nodes(first_m, widest_spacing_m, parts);
    fill_table(table_, filling);
  }
  if (part == LightPart::refracted) std::ranges::fill(table_.sunlight, 0);
}

void Lookup::read(const eclipse::ShadowPlace& place, std::span<double> values) const {
  const double turn = algebra::in_radians(place.position_angle);
  const double east_m = algebra::in_metres(place.axis_distance) * std::sin(turn),
               north_m = algebra::in_metres(place.axis_distance) * std::cos(turn),
               depth_m = algebra::in_metres(place.depth);
  read({{&east_m, 1}, {&north_m, 1}, {&depth_m, 1}}, values);
}

void Lookup::transform(const std::function<void(std::span<double>)>& change) {
  std::vector<double> values(channels());
  for (std::size_t i = 0; i < table_.values.rows(); ++i) {
    const auto row = table_.values.row(i).first(channels());
    std::ranges::copy(row, values.begin());
    change(values);
    std::ranges::transform(values, row.begin(),
                           [](double value) { return static_cast<float>(value); });
  }
  change(std::span(table_.sunlight).first(channels()));
}

double Lookup::worst_relative_error(const RefractedLight& light, const ChannelWeights& weights,
                                    double from_m, double to_m) const {
  if (light.standard_error.empty()) return 0;
  const auto& places = light.axis_distances_m;
  std::vector<double> errors(places.size());
  double worst = 0;
  for (std::size_t i = 0; i < table_.values.rows(); ++i) {
    if (is_dark(table_, i)) continue;
    const std::size_t nodes = table_.nodes.count(), plane = i / nodes / table_.held, n = i % nodes;
    const auto& known = light.standard_error[plane * light.sectors + sector_of(table_, i)];
    if (n == 0)
      for (std::size_t p = 0; p < errors.size(); ++p)
        errors[p] = combined_error(light, known.row(p), weights.row(0));
    const double at_m = table_.nodes.at_m[n];
    if (at_m < from_m || at_m > to_m) continue;
    const double value = double{table_.values(i, 0)};
    const double error =
        at_m < last_distance(places) ? algebra::interpolated(places, errors, at_m) : 0;
    worst = std::max(worst, value > 0 ? error / value : 1);
  }
  return worst;
}

}  // namespace coppermoon::shadow
