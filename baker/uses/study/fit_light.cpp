// SPDX-License-Identifier: MIT
#include "uses/study/fit_light.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "algebra/interpolation.h"
#include "shadow/twilight.h"
#include "uses/light/planning.h"
#include "uses/light/spectral_bands.h"

namespace coppermoon::uses {
namespace {

/// Dust and ozone that light is computed at.
constexpr std::array dusts_per_m{0.,     4e-7,   1e-6,   1.7e-6, 2.5e-6, 3.6e-6,
                                 5.2e-6, 7.5e-6, 1.1e-5, 1.7e-5, 3e-5};
constexpr std::array ozones_du{100., 280., 500.};

/// Work that makes light as exact as a photograph is known.
constexpr plan::Work work_of_fits{.scattered_light = true,
                                  .bands = 40,
                                  .rays = 200,
                                  .sun_terms = 3,
                                  .planes = 2,
                                  .place_error = 3e-3};

constexpr double darkness = 1e-30;

/// What does not change with the air sought.
struct Setting {
  const LightRequest& request;
  ShadowedMoon moon;
  shadow::Arrangement arrangement;
  std::vector<double> waves, distances_m;
  algebra::Grid<double> weights;
  std::span<const LitPlace> places;
  std::size_t bins;
};

shadow::Lookup lookup_of(const Setting& setting, const atmosphere::Atmosphere& of_air) {
  auto moon = setting.moon;
  moon.air = of_air;
  const auto settings = quadrature_for(work_of_fits, moon);
  auto light = shadow::by_quadrature(of_air, setting.arrangement, setting.waves,
                                     setting.distances_m, settings);
  if (setting.request.scattered_light != ScatteredLight::off) shadow::add_twilight(light, of_air);
  const shadow::DirectLight direct(of_air, setting.arrangement, setting.waves);
  const shadow::LookupRange range{light.axis_distances_m.front(), light.axis_distances_m.back(),
                                  1e-3, settings.first_sector, settings.sectors};
  return {light, direct, setting.weights, range};
}

/// Logarithms of a bin's light over its sunlight.
algebra::Grid<double> in_bins(const Setting& setting, const shadow::Lookup& lookup) {
  const std::size_t channels = lookup.channels();
  algebra::Grid<double> light(setting.bins, channels);
  std::vector<double> sunlit(setting.bins), values(channels);
  for (const auto& [place, bright, bin] : setting.places) {
    lookup.read(place, values);
    sunlit[bin] += bright;
    for (std::size_t k = 0; k < channels; ++k) light(bin, k) += bright * values[k];
  }
  for (std::size_t b = 0; b < setting.bins; ++b)
    for (double& value : light.row(b))
      value = std::log(std::max(darkness, sunlit[b] > 0 ? value / sunlit[b] : 0));
  return light;
}

atmosphere::Atmosphere changed(atmosphere::Atmosphere air, double dust, double cover,
                               double ozone) {
  const auto change = [&](atmosphere::Column& column, double ozone_du) {
    column.dust_extinction_per_m = dust;
    column.cloud_cover = cover;
    column.cloud_per_m = column.cirrus = 0;
    column.ozone_du = ozone_du;
  };
  change(air.column, ozone);
  double mean = 0;
  for (const auto& belt : air.belts)
    mean += belt.column.ozone_du / static_cast<double>(air.belts.size());
  for (auto& belt : air.belts)
    change(belt.column, mean > 0 ? ozone * belt.column.ozone_du / mean : ozone);
  return air;
}

/// The first of the four doses of dust about one.
std::size_t first_of_four(double dust_per_m) {
  const auto above = std::ranges::upper_bound(dusts_per_m, dust_per_m) - dusts_per_m.begin();
  return static_cast<std::size_t>(
      std::clamp<std::ptrdiff_t>(above - 2, 0, std::ssize(dusts_per_m) - 4));
}

}  // namespace

FittedLight::FittedLight(const LightRequest& request, const almanac::SkyState& sky,
                         const algebra::Grid<double>& weights, std::span<const LitPlace> places,
                         std::size_t bins)
    : nodes_(dusts_per_m.size() * ozones_du.size()) {
  const auto moon = shadowed_moon(request, sky);
  const Setting setting{
      request,
      moon,
      arrangement_of(request, moon.sun_distance_m, depths_of(moon, work_of_fits.planes)),
      wavelengths_nm(work_of_fits.bands),
      distances_over_the_disc(moon),
      at_wavelengths(weights, work_of_fits.bands),
      places,
      bins};
  tbb::parallel_for(std::size_t{0}, nodes_.size(), [&](std::size_t i) {
    const double dust = dusts_per_m[i / ozones_du.size()], ozone = ozones_du[i % ozones_du.size()];
    const auto light = [&](double cover) {
      return in_bins(setting, lookup_of(setting, changed(moon.air, dust, cover, ozone)));
    };
    nodes_[i] = {light(0), light(1)};
  });
}

FittedLight::Mixed FittedLight::mixed(double dust_per_m, double ozone_du) const {
  const auto from = first_of_four(dust_per_m);
  const auto of_dust =
      algebra::on_polynomial(std::span<const double, 4>(&dusts_per_m[from], 4), dust_per_m);
  const auto of_ozone = algebra::on_polynomial(std::span(ozones_du), ozone_du);
  Mixed result = nodes_.front();
  const auto sum_up = [&](algebra::Grid<double> Mixed::*part) {
    auto values = (result.*part).values();
    for (std::size_t i = 0; i < values.size(); ++i) {
      double logarithm = 0;
      for (std::size_t d = 0; d < of_dust.size(); ++d)
        for (std::size_t o = 0; o < of_ozone.size(); ++o)
          logarithm += of_dust[d] * of_ozone[o] *
                       (nodes_[(from + d) * of_ozone.size() + o].*part).values()[i];
      values[i] = std::exp(logarithm);
    }
  };
  sum_up(&Mixed::clear);
  sum_up(&Mixed::cloudy);
  return result;
}

algebra::Grid<double> FittedLight::at(double dust_per_m, double cloud_cover,
                                      double ozone_du) const {
  auto [clear, cloudy] = mixed(dust_per_m, ozone_du);
  for (std::size_t i = 0; i < clear.values().size(); ++i)
    clear.values()[i] += cloud_cover * (cloudy.values()[i] - clear.values()[i]);
  return clear;
}

}  // namespace coppermoon::uses
