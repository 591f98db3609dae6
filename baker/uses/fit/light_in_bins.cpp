// SPDX-License-Identifier: MIT
#include "uses/fit/light_in_bins.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "algebra/interpolation.h"
#include "shadow/twilight.h"
#include "uses/light/planning.h"
#include "uses/light/spectral_bands.h"

namespace coppermoon::uses {
namespace {

/// Settings with which light is computed about as exactly as photographs can show it.
constexpr plan::Work work_of_fits{.scattered_light = true,
                                  .bands = 40,
                                  .rays = 200,
                                  .sun_terms = 3,
                                  .planes = 2,
                                  .place_error = 1e-2};

/// Number of sectors around the shadow's axis, and highest harmonic of position angle, for air without sharp borders.
/// Compared with 96 sectors and all harmonics, light has relative errors of 2e-3 at most, and 1e-4 on average.
constexpr std::size_t sectors_of_fits = 48;
constexpr int harmonics_of_fits = 24;

constexpr double darkness = 1e-30;

/// How the air above the observer dims light at each moment. Light is computed for a few moments, the nodes. For other
/// moments, a polynomial interpolates the logarithm of light between nodes.
struct AirAbove {
  std::size_t nodes = 0;
  algebra::Grid<double> shares;  ///< weight of each node at each moment: (moment, node)
  /// Grid (row, band) of spectral weights, with a row for each channel of the first node, then of the next, and so on.
  /// As many rows follow for the change of light per unit of the ground's colour (LitPlace::colour).
  algebra::Grid<double> weights;
};

AirAbove air_above(std::span<const LitBins> parts) {
  constexpr double alike = 0.02, most_nodes = 4;
  std::vector<double> dimming, nodes;
  for (const auto& part : parts) {
    const auto values = part.weights.values();
    dimming.push_back(-std::log(std::accumulate(values.begin(), values.end(), 0.)));
  }
  const auto [least, most] = std::ranges::minmax(dimming);
  const double count = std::clamp(std::ceil((most - least) / alike) + 1, 1., most_nodes);
  std::vector<std::size_t> of_node;  // for each node, the index of its moment in `parts`
  for (double i = 0; i < count; ++i) {
    const double wanted = least + (most - least) * i / std::max(1., count - 1);
    const auto nearest =
        std::ranges::min_element(dimming, {}, [&](double each) { return std::abs(each - wanted); });
    if (!nodes.empty() && *nearest - nodes.back() < alike / 10) continue;
    nodes.push_back(*nearest);
    of_node.push_back(static_cast<std::size_t>(nearest - dimming.begin()));
  }
  const auto channels = parts.front().weights.rows(), bands = parts.front().weights.columns(),
             rows = channels * nodes.size();
  AirAbove above{nodes.size(), {parts.size(), nodes.size()}, {2 * rows, bands}};
  for (std::size_t p = 0; p < parts.size(); ++p)
    algebra::on_polynomial(nodes, dimming[p], above.shares.row(p));
  const auto centres_nm = band_centres_nm();
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t b = 0; b < bands; ++b) {
      above.weights(row, b) = parts[of_node[row / channels]].weights(row % channels, b);
      above.weights(rows + row, b) = colour_at(centres_nm[b]) * above.weights(row, b);
    }
  return above;
}

/// Input to the computation of light that does not depend on the unknowns of the air.
struct Setting {
  const LightRequest& request;
  ShadowedMoon moon;
  shadow::Arrangement arrangement;
  std::vector<double> waves, distances_m;
  std::span<const LitBins> parts;
  AirAbove above;
  algebra::Grid<double> weights;                ///< spectral weights, resampled to `waves`
  std::vector<algebra::Grid<double>> direct{};  ///< sunlight past the air: (place, weights row)

  std::size_t channels_of_nodes() const { return weights.rows() / 2; }
};

/// Computes the sunlight that passes clear of the Earth and its air. Dust, cloud and ozone do not change this sunlight.
void add_direct(Setting& setting, const algebra::Progress& progress) {
  const shadow::DirectLight light(setting.moon.air, setting.arrangement, setting.waves);
  const auto layers = light.in_layers(setting.weights);
  for (const auto& part : setting.parts) {
    algebra::Grid<double> all(part.places.size(), setting.weights.rows());
    tbb::parallel_for(std::size_t{0}, part.places.size(), [&](std::size_t i) {
      if (progress && i % 4096 == 0) progress(0);
      const auto& place = part.places[i].place;
      std::vector<double> clear(layers.columns());
      light.clear_parts(algebra::in_metres(place.axis_distance),
                        algebra::in_radians(place.position_angle), algebra::in_metres(place.depth),
                        clear);
      for (std::size_t k = 0; k < layers.rows(); ++k)
        all(i, k) = std::inner_product(clear.begin(), clear.end(), layers.row(k).begin(), 0.);
    });
    setting.direct.push_back(std::move(all));
  }
}

std::vector<shadow::RefractedLight> refracted_in(const Setting& setting,
                                                 std::span<const atmosphere::Atmosphere> airs) {
  constexpr double some_of_the_twilight = 1e-7;
  auto moon = setting.moon;
  moon.air = airs.front();
  const bool sharp_borders = !moon.air.regions.empty();
  auto finely =
      quadrature_for(work_of_fits, moon, sharp_borders ? sectors_of_a_plan : sectors_of_fits);
  if (!sharp_borders) finely.harmonics = harmonics_of_fits;
  finely.dark_ratio = some_of_the_twilight;
  return shadow::by_quadrature_in(airs, setting.arrangement, setting.waves, setting.distances_m,
                                  finely);
}

/// Logarithm of light / full sunlight in the bins of moment `p`, seen through the air above the observer at each node's
/// moment. The result is a grid (bin, node × channel).
algebra::Grid<double> in_bins(const Setting& setting, std::size_t p,
                              const shadow::RefractedLight& refracted) {
  const auto& part = setting.parts[p];
  const std::size_t channels = setting.channels_of_nodes();
  RefractedAt at(refracted);
  algebra::Grid<double> light(part.bins, channels);
  std::vector<double> sunlit(part.bins), ratios(setting.waves.size());
  for (std::size_t i = 0; i < part.places.size(); ++i) {
    const auto& [place, bright, bin, colour] = part.places[i];
    at.read(place, ratios);
    sunlit[bin] += bright;
    const auto in_row = [&](std::size_t row) {
      return setting.direct[p](i, row) +
             std::inner_product(ratios.begin(), ratios.end(), setting.weights.row(row).begin(), 0.);
    };
    for (std::size_t k = 0; k < channels; ++k)
      light(bin, k) += bright * (in_row(k) + (colour == 0 ? 0 : colour * in_row(channels + k)));
  }
  for (std::size_t b = 0; b < part.bins; ++b)
    for (double& value : light.row(b))
      value = std::log(std::max(darkness, sunlit[b] > 0 ? value / sunlit[b] : 0));
  return light;
}

/// Logarithm of light / full sunlight in the bins of all moments, each seen through the air above the observer at that
/// moment. The result is a grid (bin, channel).
algebra::Grid<double> in_all_bins(const Setting& setting, const shadow::RefractedLight& refracted) {
  const auto nodes = setting.above.nodes, channels = setting.channels_of_nodes() / nodes;
  std::size_t bins = 0;
  for (const auto& part : setting.parts) bins += part.bins;
  algebra::Grid<double> all(bins, channels);
  std::size_t row = 0;
  for (std::size_t p = 0; p < setting.parts.size(); ++p) {
    const auto light = in_bins(setting, p, refracted);
    const auto shares = setting.above.shares.row(p);
    for (std::size_t b = 0; b < light.rows(); ++b, ++row)
      for (std::size_t n = 0; n < nodes; ++n)
        for (std::size_t k = 0; k < channels; ++k)
          all(row, k) += shares[n] * light(b, n * channels + k);
  }
  return all;
}

/// The air with these unknowns everywhere along the limb: factors multiply the air's own values, amounts replace them.
atmosphere::Atmosphere changed(atmosphere::Atmosphere air, Unknowns unknowns,
                               const AirNumbers& numbers) {
  const double aerosol = numbers[0], cloud = numbers[1], ozone = numbers[2];
  const auto multiply = [&](atmosphere::Column& column) {
    column.stratospheric_factor *= aerosol;
    column.cloud_per_m *= cloud;
    column.ozone_du *= ozone;
  };
  const auto replace = [&](atmosphere::Column& column) {
    column.dust_extinction_per_m = aerosol;
    column.cloud_cover = cloud;
    column.cloud_per_m = column.cirrus = 0;
    column.ozone_du = ozone;
  };
  const auto change = [&](atmosphere::Column& column, atmosphere::Belts& belts) {
    unknowns == Unknowns::factors ? multiply(column) : replace(column);
    for (auto& belt : belts)
      unknowns == Unknowns::factors ? multiply(belt.column) : replace(belt.column);
  };
  change(air.column, air.belts);
  if (unknowns == Unknowns::factors)
    for (auto& region : air.regions) change(region.column, region.belts);
  return air;
}

/// The Moon in the shadow, with its path through all of the given moments.
ShadowedMoon moon_at(const LightRequest& request, std::span<const almanac::SkyState> skies) {
  auto moon = shadowed_moon(request, skies[skies.size() / 2]);
  if (skies.size() > 1)
    for (const auto& sky : skies)
      moon.path.push_back(eclipse::place_in_shadow(eclipse::shadow_axis(sky), sky.moon_m));
  return moon;
}

}  // namespace

std::vector<algebra::Grid<double>> light_in_bins(const LightRequest& request, Unknowns unknowns,
                                                 std::span<const almanac::SkyState> skies,
                                                 std::span<const LitBins> parts,
                                                 std::span<const AirNumbers> numbers,
                                                 bool scattered,
                                                 const algebra::Progress& progress) {
  constexpr std::size_t at_once = 8;
  auto unit = request;
  if (unknowns == Unknowns::factors) unit.air = with_unit_factors(unit.air);
  const auto moon = moon_at(unit, skies);
  const auto above = air_above(parts);
  Setting setting{unit,
                  moon,
                  arrangement_of(moon, depths_of(moon, work_of_fits.planes)),
                  wavelengths_nm(work_of_fits.bands),
                  distances_over_the_disc(moon),
                  parts,
                  above,
                  at_wavelengths(above.weights, work_of_fits.bands)};
  add_direct(setting, progress);
  // Light is computed for groups of airs with similar aerosol, because these need it at similar axis distances.
  std::vector<std::size_t> order(numbers.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return numbers[i].front(); });
  std::vector<algebra::Grid<double>> all(numbers.size());
  for (std::size_t first = 0; first < order.size(); first += at_once) {
    const auto some = std::span(order).subspan(first, std::min(at_once, order.size() - first));
    std::vector<atmosphere::Atmosphere> airs;
    for (const auto i : some) airs.push_back(changed(moon.air, unknowns, numbers[i]));
    auto lights = refracted_in(setting, airs);
    if (scattered) shadow::add_twilight_in(lights, airs);
    tbb::parallel_for(std::size_t{0}, some.size(),
                      [&](std::size_t i) { all[some[i]] = in_all_bins(setting, lights[i]); });
    if (progress)
      progress(static_cast<double>(first + some.size()) / static_cast<double>(order.size()));
  }
  return all;
}

RefractedAt::RefractedAt(const shadow::RefractedLight& light)
    : light_(light), between_places_(light), some_(light.wavelengths_nm.size()) {}

void RefractedAt::read(const eclipse::ShadowPlace& place, std::span<double> ratios) {
  const auto& depths_m = light_.arrangement.depths_m;
  const double depth_m = algebra::in_metres(place.depth),
               at_m = algebra::in_metres(place.axis_distance),
               sector = algebra::in_radians(place.position_angle) / (2 * std::numbers::pi) *
                        static_cast<double>(light_.sectors);
  const auto [nearer, farther, deeper] = algebra::on_line(depths_m, depth_m);
  const std::array planes{std::pair{nearer, 1 - deeper}, std::pair{farther, deeper}};
  std::ranges::fill(ratios, 0);
  const auto sectors = algebra::on_circle(light_.sectors, sector);
  for (std::size_t i = 0; i < sectors.at.size(); ++i)
    for (const auto& [plane, of_plane] : planes) {
      const double share = of_plane * sectors.share[i];
      if (share == 0) continue;
      between_places_.read(plane, sectors.at[i], shadow::sheared(at_m, depths_m[plane] / depth_m),
                           some_);
      for (std::size_t w = 0; w < some_.size(); ++w) ratios[w] += share * some_[w];
    }
}

}  // namespace coppermoon::uses
