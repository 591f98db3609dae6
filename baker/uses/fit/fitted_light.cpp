// SPDX-License-Identifier: MIT
#include "uses/fit/fitted_light.h"

#include <algorithm>
#include <cmath>

#include "algebra/interpolation.h"
#include "uses/light/planning.h"

namespace coppermoon::uses {
namespace {

using InOzone = FittedLight::InOzone;

/// Transforms an amount or factor to ln(1 + number / scale). The logarithm of light is a smooth function of the result.
double smooth(double number, double scale) { return std::log1p(number / scale); }

/// Numbers that cover a range in steps that are equal after transformation by `smooth`.
std::vector<double> even_on_scale(const std::array<double, 2>& range, double scale, int count) {
  std::vector<double> all;
  const double from = smooth(range[0], scale), to = smooth(range[1], scale);
  for (int i = 0; i < count; ++i)
    all.push_back(scale * std::expm1(from + (to - from) * i / (count - 1)));
  return all;
}

/// Scale of `smooth` for dust. With ten nodes evenly spaced on this scale, cubic interpolation has relative errors of
/// 4e-4 for dust up to 3e-6 per metre, 1e-3 up to 8e-6, 5e-3 up to 1.5e-5, and 2e-2 beyond.
constexpr double scale_of_dust_per_m = 2e-6;

/// Scale of `smooth` for stratospheric aerosol: vertical optical depth that gives a grazing ray a depth of about 1.
constexpr double scale_of_depth = 0.015;

/// Scale of `smooth` for factors on the chance of cloud.
constexpr double scale_of_cloud_chance = 0.7;

double smooth_cloud(Unknowns unknowns, double cloud) {
  return unknowns == Unknowns::factors ? smooth(cloud, scale_of_cloud_chance) : cloud;
}

/// Weights of `aerosols` for cubic interpolation at `aerosol` between the four nearest, all transformed by `smooth`.
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

/// Adds a multiple of `light` to sums of the same size.
void add(double times, const algebra::Grid<double>& light, algebra::Grid<double>& sums) {
  const auto values = light.values();
  for (std::size_t i = 0; i < values.size(); ++i) sums.values()[i] += times * values[i];
}

/// The elements of a vector that have the given indices.
std::vector<double> some(const std::vector<double>& all, std::span<const std::size_t> which) {
  std::vector<double> fewer;
  for (const auto i : which) fewer.push_back(all[i]);
  return fewer;
}

/// Values of the unknowns at which light is computed (nodes), over the given range or, without one, the whole range.
///
/// Fine nodes have three values of ozone. The first is combined with all values of aerosol and cloud, the others with
/// fewer, because the ratio of light at two values of ozone is smoother than light itself. If the unknowns are amounts,
/// the others are combined with five of ten values of dust. The error this causes is 0 at 280 DU of ozone. At 100 and
/// 350 DU, the relative error of light is 8e-4 for dust up to 3e-6 per metre, 1.4e-3 up to 8e-6, and 3e-3 up to 1.5e-5.
/// Nodes over a narrow range are closer together, so that cubic interpolation has smaller errors.
std::vector<InOzone> nodes_of(Unknowns unknowns, FittedAirs airs, double aerosol_scale,
                              const std::optional<AirRange>& range) {
  using Which = std::vector<std::size_t>;
  const auto [aerosol, cloud, ozone] = range.value_or(whole_range(unknowns));
  const bool fine = airs == FittedAirs::fine, deck = unknowns == Unknowns::amounts;
  const auto count = [](const std::array<double, 2>& numbers, double scale, double step, int most) {
    const double length = smooth(numbers[1], scale) - smooth(numbers[0], scale);
    return std::clamp(static_cast<int>(std::ceil(length / step)) + 1, 4, most);
  };
  std::vector<double> aerosols, clouds{0, 1};
  Which some_aerosols, some_clouds{0, 1};
  double first_ozone = 1;
  if (range) {
    aerosols = even_on_scale(aerosol, aerosol_scale, count(aerosol, aerosol_scale, 0.12, 11));
    if (!deck)
      clouds =
          even_on_scale(cloud, scale_of_cloud_chance, count(cloud, scale_of_cloud_chance, 0.2, 7));
    some_aerosols = {0, aerosols.size() / 2, aerosols.size() - 1};
    if (!deck) some_clouds = {0, clouds.size() / 2, clouds.size() - 1};
    first_ozone = (ozone[0] + ozone[1]) / 2;
  } else if (deck) {
    aerosols = fine ? even_on_scale(aerosol, aerosol_scale, 10)
                    : std::vector<double>{4e-7, 2.5e-6, 7.5e-6, 1.7e-5};
    some_aerosols = {0, 2, 5, 6, 9};
    first_ozone = fine ? 280 : 300;
  } else {
    aerosols = even_on_scale(aerosol, aerosol_scale, fine ? 11 : 4);
    clouds = even_on_scale(cloud, scale_of_cloud_chance, fine ? 5 : 3);
    some_aerosols = {0, 2, 5, 7, 10};
    some_clouds = {0, 2, 4};
  }
  std::vector<InOzone> nodes{{first_ozone, aerosols, clouds, {}}};
  for (const double other : ozone)
    if (fine)
      nodes.push_back({other, some(aerosols, some_aerosols), some(clouds, some_clouds), {}});
  for (auto& node : nodes) node.logarithms.resize(node.aerosols.size() * node.clouds.size());
  return nodes;
}

/// Scale of `smooth` for aerosol. If aerosol is a factor, the scale follows from the stratosphere's mean optical depth.
double aerosol_scale_of(const LightRequest& request, Unknowns unknowns,
                        const almanac::SkyState& sky) {
  if (unknowns == Unknowns::amounts) return scale_of_dust_per_m;
  auto unit = request;
  unit.air = with_unit_factors(unit.air);
  const auto moon = shadowed_moon(unit, sky);  // holds the columns
  double sum = 0, count = 0;
  for (const auto* column : moon.air.columns())
    if (column->stratospheric_layer) {
      sum += column->stratospheric_layer->optical_depth();
      ++count;
    }
  return sum > 0 ? std::clamp(scale_of_depth * count / sum, 0.1, 10.) : 1;
}

}  // namespace

FittedLight::FittedLight(const LightRequest& request, Unknowns unknowns,
                         std::span<const almanac::SkyState> skies, std::span<const LitBins> parts,
                         FittedAirs airs, const algebra::Progress& progress,
                         const std::optional<AirRange>& range)
    : unknowns_(unknowns), range_(range.value_or(whole_range(unknowns))) {
  aerosol_scale_ = aerosol_scale_of(request, unknowns, skies[skies.size() / 2]);
  nodes_ = nodes_of(unknowns, airs, aerosol_scale_, range);
  std::vector<AirNumbers> numbers;
  for (const auto& node : nodes_)
    for (const double aerosol : node.aerosols)
      for (const double cloud : node.clouds) numbers.push_back({aerosol, cloud, node.ozone});
  auto logarithms = light_in_bins(
      request, unknowns, skies, parts, numbers,
      airs == FittedAirs::fine && request.scattered_light != ScatteredLight::off, progress);
  auto next = logarithms.begin();
  for (auto& node : nodes_)
    for (auto& light : node.logarithms) light = std::move(*next++);
  const auto& first = nodes_.front();
  const auto place = [](const std::vector<double>& of, double number) {
    return static_cast<std::size_t>(std::ranges::find(of, number) - of.begin());
  };
  for (auto& other : std::span(nodes_).subspan(1))
    for (std::size_t i = 0; i < other.logarithms.size(); ++i)
      add(-1,
          first.logarithms[place(first.aerosols, other.aerosols[i / other.clouds.size()]) *
                               first.clouds.size() +
                           place(first.clouds, other.clouds[i % other.clouds.size()])],
          other.logarithms[i]);
}

FittedLight::OverCloud FittedLight::over_cloud(double aerosol, double ozone) const {
  std::vector<double> ozones;
  for (const auto& node : nodes_) ozones.push_back(node.ozone);
  auto of_ozone = algebra::on_polynomial(ozones, ozone);
  of_ozone.front() = 1;  // because grids at other values of ozone hold ratios to the first grids
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
