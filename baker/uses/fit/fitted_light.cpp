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

/// Scale of dust: the logarithm of light is smooth in ln(1 + dust / scale). Cubics through ten nodes, even in that,
/// err by 4e-4 up to 3e-6 per metre, 1e-3 up to 8e-6, 5e-3 up to 1.5e-5, 2e-2 beyond.
constexpr double scale_of_dust_per_m = 2e-6;

double smooth(double dust_per_m) { return std::log1p(dust_per_m / scale_of_dust_per_m); }

/// Nodes of dust.
constexpr std::array coarse_dusts_per_m{4e-7, 2.5e-6, 7.5e-6, 1.7e-5};
std::vector<double> fine_dusts_per_m() {
  constexpr int count = 10;
  std::vector<double> even;
  for (int i = 0; i < count; ++i)
    even.push_back(scale_of_dust_per_m *
                   std::expm1(smooth(search_range[0].most) * i / (count - 1)));
  return even;
}

/// Nodes of ozone: one at all ten nodes of dust, two more at five of them, for the ratio of light in two ozones is
/// smoother in dust than light is. Errors between the five, at 100 and 350 DU, are 8e-4 up to 3e-6 per metre, 1.4e-3
/// up to 8e-6, 3e-3 up to 1.5e-5; near 280 DU 0.
constexpr double ozone_of_all_dust_du = 280;
constexpr std::array<double, 2> other_ozones_du{100, 500};
constexpr std::array<std::size_t, 5> dusts_of_other_ozone{0, 2, 5, 6, 9};

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

/// Air with other dust, cover and ozone everywhere, as a request's column would set them.
atmosphere::Atmosphere changed(atmosphere::Atmosphere air, double dust, double cover,
                               double ozone) {
  const auto change = [&](atmosphere::Column& column) {
    column.dust_extinction_per_m = dust;
    column.cloud_cover = cover;
    column.cloud_per_m = column.cirrus = 0;
    column.ozone_du = ozone;
  };
  change(air.column);
  for (auto& belt : air.belts) change(belt.column);
  return air;
}

/// Air of a node, and where the logarithms of its light go, (bin, channel).
struct Node {
  double dust_per_m, cover, ozone_du;
  algebra::Grid<double>* logarithms;
};

/// Computes light at all nodes, some at once, in order of dust: air of like dust needs light at like places.
void light(const Setting& setting, std::vector<Node>& all, const algebra::Progress& progress) {
  constexpr std::size_t at_once = 8;
  std::ranges::stable_sort(all, {}, &Node::dust_per_m);
  for (std::size_t first = 0; first < all.size(); first += at_once) {
    const auto some = std::span(all).subspan(first, std::min(at_once, all.size() - first));
    std::vector<atmosphere::Atmosphere> airs;
    for (const auto& [dust, cover, ozone, logarithms] : some)
      airs.push_back(changed(setting.moon.air, dust, cover, ozone));
    auto lights = refracted_in(setting, airs);
    if (setting.scattered) shadow::add_twilight_in(lights, airs);
    tbb::parallel_for(std::size_t{0}, airs.size(), [&](std::size_t i) {
      *some[i].logarithms = in_all_bins(setting, lights[i]);
    });
    if (progress)
      progress(static_cast<double>(first + some.size()) / static_cast<double>(all.size()));
  }
}

/// Weights of the nodes of dust, by a cubic through the four nearest.
std::vector<double> shares_of_dust(std::span<const double> dusts_per_m, double dust_per_m) {
  const auto above = std::ranges::upper_bound(dusts_per_m, dust_per_m) - dusts_per_m.begin();
  const auto from = static_cast<std::size_t>(
      std::clamp<std::ptrdiff_t>(above - 2, 0, std::ssize(dusts_per_m) - 4));
  std::array<double, 4> nodes;
  for (std::size_t i = 0; i < nodes.size(); ++i) nodes[i] = smooth(dusts_per_m[from + i]);
  std::vector<double> shares(dusts_per_m.size());
  algebra::on_polynomial(nodes, smooth(dust_per_m), std::span(shares).subspan(from, nodes.size()));
  return shares;
}

/// Adds a multiple of some light to sums of the same size.
void add(double times, const FittedLight::Mixed& light, FittedLight::Mixed& sums) {
  for (const auto part : {&FittedLight::Mixed::clear, &FittedLight::Mixed::cloudy}) {
    const auto values = (light.*part).values();
    for (std::size_t i = 0; i < values.size(); ++i) (sums.*part).values()[i] += times * values[i];
  }
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

std::vector<FittedLight::InOzone> FittedLight::nodes_of(FittedAirs airs) {
  const auto node = [](double ozone_du, std::span<const double> dusts) {
    return InOzone{ozone_du, {dusts.begin(), dusts.end()}, std::vector<Mixed>(dusts.size())};
  };
  if (airs == FittedAirs::coarse) return {node(300, coarse_dusts_per_m)};
  const auto dusts = fine_dusts_per_m();
  std::vector<double> fewer;
  for (const auto d : dusts_of_other_ozone) fewer.push_back(dusts[d]);
  std::vector<InOzone> nodes{node(ozone_of_all_dust_du, dusts)};
  for (const double ozone : other_ozones_du) nodes.push_back(node(ozone, fewer));
  return nodes;
}

FittedLight::FittedLight(const LightRequest& request, std::span<const almanac::SkyState> skies,
                         std::span<const LitBins> parts, FittedAirs airs,
                         const algebra::Progress& progress)
    : nodes_(nodes_of(airs)) {
  const auto moon = moon_at(request, skies);
  const AirAbove above(parts);
  Setting setting{
      request,
      moon,
      arrangement_of(request, moon.sun_distance_m, depths_of(moon, work_of_fits.planes)),
      wavelengths_nm(work_of_fits.bands),
      distances_over_the_disc(moon),
      parts,
      above,
      at_wavelengths(above.weights(parts), work_of_fits.bands),
      airs == FittedAirs::fine && request.scattered_light != ScatteredLight::off};
  add_direct(setting, progress);
  std::vector<Node> nodes;
  for (auto& [ozone, dusts, logarithms] : nodes_)
    for (std::size_t d = 0; d < dusts.size(); ++d) {
      nodes.push_back({dusts[d], 0, ozone, &logarithms[d].clear});
      nodes.push_back({dusts[d], 1, ozone, &logarithms[d].cloudy});
    }
  light(setting, nodes, progress);
  for (auto& other : std::span(nodes_).subspan(1))
    for (std::size_t d = 0; d < other.logarithms.size(); ++d)
      add(-1, nodes_.front().logarithms[dusts_of_other_ozone[d]], other.logarithms[d]);
}

FittedLight::Mixed FittedLight::mixed(double dust_per_m, double ozone_du) const {
  std::vector<double> ozones_du;
  for (const auto& node : nodes_) ozones_du.push_back(node.ozone_du);
  auto of_ozone = algebra::on_polynomial(ozones_du, ozone_du);
  of_ozone.front() = 1;  // the others are ratios to it
  const auto& form = nodes_.front().logarithms.front().clear;
  Mixed result{{form.rows(), form.columns()}, {form.rows(), form.columns()}};
  for (std::size_t o = 0; o < nodes_.size(); ++o) {
    const auto of_dust = shares_of_dust(nodes_[o].dusts_per_m, dust_per_m);
    for (std::size_t d = 0; d < of_dust.size(); ++d)
      if (of_dust[d] != 0) add(of_ozone[o] * of_dust[d], nodes_[o].logarithms[d], result);
  }
  for (auto* grid : {&result.clear, &result.cloudy})
    for (double& value : grid->values()) value = std::exp(value);
  return result;
}

algebra::Grid<double> FittedLight::Mixed::under(double cloud_cover) const {
  auto light = clear;
  for (std::size_t i = 0; i < light.values().size(); ++i)
    light.values()[i] += cloud_cover * (cloudy.values()[i] - clear.values()[i]);
  return light;
}

algebra::Grid<double> FittedLight::at(double dust_per_m, double cloud_cover,
                                      double ozone_du) const {
  return mixed(dust_per_m, ozone_du).under(cloud_cover);
}

}  // namespace coppermoon::uses
