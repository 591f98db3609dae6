// SPDX-License-Identifier: MIT
#include "uses/fit/fitted_light.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "algebra/interpolation.h"
#include "shadow/twilight.h"
#include "uses/fit/refracted_at.h"
#include "uses/light/planning.h"
#include "uses/light/spectral_bands.h"

namespace coppermoon::uses {
namespace {

/// Scale on which the logarithm of light is smooth: ln(1 + number / scale).
double smooth(double number, double scale) { return std::log1p(number / scale); }

/// Numbers from the least to the most, even on that scale.
std::vector<double> even_on_scale(const std::array<double, 2>& range, double scale, int count) {
  std::vector<double> all;
  const double from = smooth(range[0], scale), to = smooth(range[1], scale);
  for (int i = 0; i < count; ++i)
    all.push_back(scale * std::expm1(from + (to - from) * i / (count - 1)));
  return all;
}

/// Scale of dust. Cubics through ten nodes, even in it, err by 4e-4 up to 3e-6 per metre, 1e-3 up to 8e-6, 5e-3 up to
/// 1.5e-5, 2e-2 beyond.
constexpr double scale_of_dust_per_m = 2e-6;
constexpr std::array coarse_dusts_per_m{4e-7, 2.5e-6, 7.5e-6, 1.7e-5};

/// Scale of factors on stratospheric aerosol: that of a vertical optical depth of 0.015, along the limb some 1.
constexpr double scale_of_depth = 0.015;

/// Scale of factors on the chance of cloud.
constexpr double scale_of_cloud_chance = 0.7;

double smooth_cloud(Unknowns unknowns, double cloud) {
  return unknowns == Unknowns::factors ? smooth(cloud, scale_of_cloud_chance) : cloud;
}

/// Work for light as exact as photographs are.
constexpr plan::Work work_of_fits{.scattered_light = true,
                                  .bands = 40,
                                  .rays = 200,
                                  .sun_terms = 3,
                                  .planes = 2,
                                  .place_error = 1e-2};

/// Sectors, interpolated by cubics, and the highest harmonic, in air without sharp borders. Errors against 96 sectors
/// and all harmonics are 2e-3 at most, 1e-4 in the mean.
constexpr std::size_t sectors_of_fits = 48;
constexpr int harmonics_of_fits = 24;

constexpr double darkness = 1e-30;

/// Interpolation between different air above the observer.
class AirAbove {
 public:
  explicit AirAbove(std::span<const LitBins> parts) {
    for (const auto& part : parts) dimming_.push_back(dimming_of(part.weights));
    const auto [least, most] = std::ranges::minmax(dimming_);
    const auto count =
        static_cast<std::size_t>(std::clamp(std::ceil((most - least) / alike) + 1, 1., most_nodes));
    for (std::size_t i = 0; i < count; ++i) {
      const double wanted = least + (most - least) * static_cast<double>(i) /
                                        static_cast<double>(std::max<std::size_t>(1, count - 1));
      const auto nearest = std::ranges::min_element(
          dimming_, {}, [&](double dimming) { return std::abs(dimming - wanted); });
      if (!nodes_.empty() && *nearest - nodes_.back() < alike / 10) continue;
      nodes_.push_back(*nearest);
      of_part_.push_back(static_cast<std::size_t>(nearest - dimming_.begin()));
    }
  }

  std::size_t nodes() const { return nodes_.size(); }

  /// Weights of the nodes' logarithms for a part.
  std::vector<double> shares(std::size_t part) const {
    return algebra::on_polynomial(nodes_, dimming_[part]);
  }

  /// Weights of all nodes' channels, one node after the other; then as many rows for the ground's colour.
  algebra::Grid<double> weights(std::span<const LitBins> parts) const {
    const auto channels = parts.front().weights.rows(), bands = parts.front().weights.columns(),
               rows = channels * nodes();
    algebra::Grid<double> all(2 * rows, bands);
    for (std::size_t n = 0; n < nodes(); ++n)
      for (std::size_t k = 0; k < channels; ++k)
        std::ranges::copy(parts[of_part_[n]].weights.row(k), all.row(n * channels + k).begin());
    const auto centres_nm = band_centres_nm();
    for (std::size_t b = 0; b < bands; ++b) {
      const double change = colour_at(centres_nm[b]);
      for (std::size_t row = 0; row < rows; ++row) all(rows + row, b) = change * all(row, b);
    }
    return all;
  }

 private:
  static constexpr double alike = 0.02, most_nodes = 4;

  static double dimming_of(const algebra::Grid<double>& weights) {
    return -std::log(std::accumulate(weights.values().begin(), weights.values().end(), 0.));
  }

  std::vector<double> dimming_, nodes_;  // [part]; increasing
  std::vector<std::size_t> of_part_;     // [node]
};

/// All that does not depend on the air sought.
struct Setting {
  const LightRequest& request;
  ShadowedMoon moon;
  shadow::Arrangement arrangement;
  std::vector<double> waves, distances_m;
  std::span<const LitBins> parts;
  AirAbove above;
  algebra::Grid<double> weights;  ///< as AirAbove::weights: (row, wave)
  bool scattered;
  std::vector<algebra::Grid<double>> direct{};  ///< [part](place, row)

  std::size_t channels_of_nodes() const { return weights.rows() / 2; }
};

/// Adds sunlight that passes clear of Earth and air, which dust, cloud and ozone do not change.
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

/// Logarithms of a part's light over its sunlight, (bin, channel of all nodes).
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

/// Logarithms of all parts' light over sunlight, each through its own air above: (bin, channel).
algebra::Grid<double> in_all_bins(const Setting& setting, const shadow::RefractedLight& refracted) {
  const auto nodes = setting.above.nodes(), channels = setting.channels_of_nodes() / nodes;
  std::size_t bins = 0;
  for (const auto& part : setting.parts) bins += part.bins;
  algebra::Grid<double> all(bins, channels);
  std::size_t row = 0;
  for (std::size_t p = 0; p < setting.parts.size(); ++p) {
    const auto light = in_bins(setting, p, refracted);
    const auto shares = setting.above.shares(p);
    for (std::size_t b = 0; b < light.rows(); ++b, ++row)
      for (std::size_t n = 0; n < nodes; ++n)
        for (std::size_t k = 0; k < channels; ++k)
          all(row, k) += shares[n] * light(b, n * channels + k);
  }
  return all;
}

/// Air whose unknowns have other numbers in all columns.
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

/// Air of a node, and where the logarithms of its light go, (bin, channel).
struct Node {
  AirNumbers numbers;
  algebra::Grid<double>* logarithms;
};

/// Computes light at all nodes, some at once, in order of aerosol: air of like aerosol needs light at like places.
void light(const Setting& setting, Unknowns unknowns, std::vector<Node>& all,
           const algebra::Progress& progress) {
  constexpr std::size_t at_once = 8;
  std::ranges::stable_sort(all, {}, [](const Node& node) { return node.numbers.front(); });
  for (std::size_t first = 0; first < all.size(); first += at_once) {
    const auto some = std::span(all).subspan(first, std::min(at_once, all.size() - first));
    std::vector<atmosphere::Atmosphere> airs;
    for (const auto& [numbers, logarithms] : some)
      airs.push_back(changed(setting.moon.air, unknowns, numbers));
    auto lights = refracted_in(setting, airs);
    if (setting.scattered) shadow::add_twilight_in(lights, airs);
    tbb::parallel_for(std::size_t{0}, airs.size(), [&](std::size_t i) {
      *some[i].logarithms = in_all_bins(setting, lights[i]);
    });
    if (progress)
      progress(static_cast<double>(first + some.size()) / static_cast<double>(all.size()));
  }
}

/// Weights of the nodes of aerosol, by a cubic through the four nearest on their scale.
std::vector<double> shares_of_aerosol(std::span<const double> aerosols, double aerosol,
                                      double scale) {
  constexpr std::size_t near = 4;
  const auto count = std::min(near, aerosols.size());
  const auto above = std::ranges::upper_bound(aerosols, aerosol) - aerosols.begin();
  const auto from = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(
      above - 2, 0, std::ssize(aerosols) - static_cast<std::ptrdiff_t>(count)));
  std::vector<double> nodes(count), shares(aerosols.size());
  for (std::size_t i = 0; i < count; ++i) nodes[i] = smooth(aerosols[from + i], scale);
  algebra::on_polynomial(nodes, smooth(aerosol, scale), std::span(shares).subspan(from, count));
  return shares;
}

/// Adds a multiple of some light to sums of the same size.
void add(double times, const algebra::Grid<double>& light, algebra::Grid<double>& sums) {
  const auto values = light.values();
  for (std::size_t i = 0; i < values.size(); ++i) sums.values()[i] += times * values[i];
}

/// Some of the numbers.
std::vector<double> some(const std::vector<double>& all, std::initializer_list<std::size_t> which) {
  std::vector<double> fewer;
  for (const auto i : which) fewer.push_back(all[i]);
  return fewer;
}

/// First, middle and last number.
std::vector<double> three_of(const std::vector<double>& all) {
  return some(all, {0, all.size() / 2, all.size() - 1});
}

/// Scale of aerosol's nodes: of factors, by the mean optical depth of the stratosphere over the limb.
double aerosol_scale_of(Unknowns unknowns, const atmosphere::Atmosphere& air) {
  if (unknowns == Unknowns::amounts) return scale_of_dust_per_m;
  double sum = 0, count = 0;
  for (const auto* column : air.columns())
    if (column->stratospheric_layer) {
      sum += column->stratospheric_layer->optical_depth();
      ++count;
    }
  return sum > 0 ? std::clamp(scale_of_depth * count / sum, 0.1, 10.) : 1;
}

/// The Moon at all moments.
ShadowedMoon moon_at(const LightRequest& request, std::span<const almanac::SkyState> skies) {
  auto moon = shadowed_moon(request, skies[skies.size() / 2]);
  if (skies.size() > 1)
    for (const auto& sky : skies)
      moon.path.push_back(eclipse::place_in_shadow(eclipse::shadow_axis(sky), sky.moon_m));
  return moon;
}

}  // namespace

FittedLight::InOzone FittedLight::node(double ozone, std::vector<double> aerosols,
                                       std::vector<double> clouds) {
  const auto count = aerosols.size() * clouds.size();
  return {ozone, std::move(aerosols), std::move(clouds), std::vector<algebra::Grid<double>>(count)};
}

std::vector<FittedLight::InOzone> FittedLight::nodes_of(Unknowns unknowns, FittedAirs airs,
                                                        double aerosol_scale) {
  const auto [aerosol, cloud, ozone] = whole_range(unknowns);
  const bool fine = airs == FittedAirs::fine;
  if (unknowns == Unknowns::amounts) {
    // one ozone at all nodes of dust, two more at five: the ratio of light in two ozones is smoother in dust than light
    // is. Errors between the five, at 100 and 350 DU, are 8e-4 up to 3e-6 per metre, 1.4e-3 up to 8e-6, 3e-3 up to
    // 1.5e-5; near 280 DU 0
    const auto dusts = even_on_scale(aerosol, aerosol_scale, 10);
    const std::vector<double> deck{0, 1};
    if (!fine) return {node(300, {coarse_dusts_per_m.begin(), coarse_dusts_per_m.end()}, deck)};
    std::vector<InOzone> nodes{node(280, dusts, deck)};
    for (const double other : ozone)
      nodes.push_back(node(other, some(dusts, {0, 2, 5, 6, 9}), deck));
    return nodes;
  }
  const auto factors = even_on_scale(aerosol, aerosol_scale, fine ? 11 : 4),
             chances = even_on_scale(cloud, scale_of_cloud_chance, fine ? 5 : 3);
  std::vector<InOzone> nodes{node(1, factors, chances)};
  if (fine)
    for (const double other : ozone)
      nodes.push_back(node(other, some(factors, {0, 2, 5, 7, 10}), some(chances, {0, 2, 4})));
  return nodes;
}

std::vector<FittedLight::InOzone> FittedLight::nodes_within(const AirRange& range,
                                                            Unknowns unknowns,
                                                            double aerosol_scale) {
  // steps of aerosol and cloud a third as long as over the whole range: errors of cubics are a hundredth
  constexpr double aerosol_step = 0.12, cloud_step = 0.2;
  const auto& [aerosol, cloud, ozone] = range;
  const auto even = [](const std::array<double, 2>& numbers, double scale, double step, int most) {
    const double length = smooth(numbers[1], scale) - smooth(numbers[0], scale);
    return even_on_scale(numbers, scale,
                         std::clamp(static_cast<int>(std::ceil(length / step)) + 1, 4, most));
  };
  const auto aerosols = even(aerosol, aerosol_scale, aerosol_step, 11);
  const bool deck = unknowns == Unknowns::amounts;
  const auto clouds =
      deck ? std::vector<double>{0, 1} : even(cloud, scale_of_cloud_chance, cloud_step, 7);
  std::vector<InOzone> nodes{node((ozone[0] + ozone[1]) / 2, aerosols, clouds)};
  for (const double other : ozone)
    nodes.push_back(node(other, three_of(aerosols), deck ? clouds : three_of(clouds)));
  return nodes;
}

FittedLight::FittedLight(const LightRequest& request, Unknowns unknowns,
                         std::span<const almanac::SkyState> skies, std::span<const LitBins> parts,
                         FittedAirs airs, const algebra::Progress& progress,
                         const std::optional<AirRange>& range)
    : unknowns_(unknowns), range_(range.value_or(whole_range(unknowns))) {
  auto unit = request;
  if (unknowns == Unknowns::factors) unit.air = with_unit_factors(unit.air);
  const auto moon = moon_at(unit, skies);
  aerosol_scale_ = aerosol_scale_of(unknowns, moon.air);
  nodes_ = range ? nodes_within(*range, unknowns, aerosol_scale_)
                 : nodes_of(unknowns, airs, aerosol_scale_);
  const AirAbove above(parts);
  Setting setting{unit,
                  moon,
                  arrangement_of(unit, moon.sun_distance_m, depths_of(moon, work_of_fits.planes)),
                  wavelengths_nm(work_of_fits.bands),
                  distances_over_the_disc(moon),
                  parts,
                  above,
                  at_wavelengths(above.weights(parts), work_of_fits.bands),
                  airs == FittedAirs::fine && request.scattered_light != ScatteredLight::off};
  add_direct(setting, progress);
  std::vector<Node> nodes;
  for (auto& [ozone, aerosols, clouds, logarithms] : nodes_)
    for (std::size_t i = 0; i < logarithms.size(); ++i)
      nodes.push_back(
          {{aerosols[i / clouds.size()], clouds[i % clouds.size()], ozone}, &logarithms[i]});
  light(setting, unknowns, nodes, progress);
  const auto& first = nodes_.front();
  const auto place = [](const std::vector<double>& of, double number) {
    return static_cast<std::size_t>(std::ranges::find(of, number) - of.begin());
  };
  for (auto& other : std::span(nodes_).subspan(1))
    for (std::size_t i = 0; i < other.logarithms.size(); ++i) {
      const auto a = place(first.aerosols, other.aerosols[i / other.clouds.size()]),
                 c = place(first.clouds, other.clouds[i % other.clouds.size()]);
      add(-1, first.logarithms[a * first.clouds.size() + c], other.logarithms[i]);
    }
}

FittedLight::OverCloud FittedLight::over_cloud(double aerosol, double ozone) const {
  std::vector<double> ozones;
  for (const auto& node : nodes_) ozones.push_back(node.ozone);
  auto of_ozone = algebra::on_polynomial(ozones, ozone);
  of_ozone.front() = 1;  // the others are ratios to it
  const auto& first = nodes_.front();
  const auto& form = first.logarithms.front();
  const auto on_scale = [&](const std::vector<double>& clouds) {
    std::vector<double> all;
    for (const double cloud : clouds) all.push_back(smooth_cloud(unknowns_, cloud));
    return all;
  };
  OverCloud result;
  result.unknowns = unknowns_;
  result.clouds = on_scale(first.clouds);
  result.light.assign(first.clouds.size(), algebra::Grid<double>(form.rows(), form.columns()));
  for (std::size_t o = 0; o < nodes_.size(); ++o) {
    const auto& node = nodes_[o];
    const auto of_aerosol = shares_of_aerosol(node.aerosols, aerosol, aerosol_scale_);
    const auto clouds = on_scale(node.clouds);
    for (std::size_t c = 0; c < result.clouds.size(); ++c) {
      const auto of_cloud = algebra::on_polynomial(clouds, result.clouds[c]);
      for (std::size_t i = 0; i < node.logarithms.size(); ++i) {
        const double share =
            of_ozone[o] * of_aerosol[i / clouds.size()] * of_cloud[i % clouds.size()];
        if (share != 0) add(share, node.logarithms[i], result.light[c]);
      }
    }
  }
  if (unknowns_ == Unknowns::amounts)
    for (auto& grid : result.light)
      for (double& value : grid.values()) value = std::exp(value);
  return result;
}

algebra::Grid<double> FittedLight::OverCloud::under(double cloud) const {
  const auto shares = algebra::on_polynomial(clouds, smooth_cloud(unknowns, cloud));
  algebra::Grid<double> sums(light.front().rows(), light.front().columns());
  for (std::size_t c = 0; c < shares.size(); ++c) add(shares[c], light[c], sums);
  if (unknowns == Unknowns::factors)
    for (double& value : sums.values()) value = std::exp(value);
  return sums;
}

algebra::Grid<double> FittedLight::at(const AirNumbers& numbers) const {
  return over_cloud(numbers[0], numbers[2]).under(numbers[1]);
}

}  // namespace coppermoon::uses
