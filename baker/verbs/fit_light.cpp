// SPDX-License-Identifier: MIT
#include "verbs/fit_light.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "shadow/twilight.h"
#include "verbs/planning.h"
#include "verbs/spectral_bands.h"

namespace coppermoon::verbs {
namespace {

/// Where light is computed.
constexpr std::array dusts_per_m{0.,   3e-7, 7e-7, 1.2e-6, 1.8e-6, 2.6e-6, 3.6e-6,
                                 5e-6, 7e-6, 1e-5, 1.4e-5, 2e-5,   3e-5};
constexpr std::array ozones_du{100., 230., 360., 500.};

/// As closely as a photograph is known.
constexpr plan::Work work{.scattered_light = true,
                          .bands = 20,
                          .rays = 200,
                          .sun_terms = 3,
                          .planes = 2,
                          .place_error = 3e-3};

constexpr double darkness = 1e-30;

/// What does not change with the air sought.
struct Setting {
  const LightOptions& options;
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
  const auto settings = quadrature_for(work, moon);
  auto light = shadow::by_quadrature(of_air, setting.arrangement, setting.waves,
                                     setting.distances_m, settings);
  if (setting.options.scattered_light != "off") shadow::add_twilight(light, of_air);
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
  air.column.dust_extinction_per_m = dust;
  air.column.cloud_cover = cover;
  air.column.ozone_du = ozone;
  return air;
}

/// Between which two nodes a value lies, and how far.
struct Way {
  std::size_t from;
  double share;
};

template <std::size_t size>
Way way_to(const std::array<double, size>& nodes, double value) {
  const auto above = std::upper_bound(nodes.begin() + 1, nodes.end() - 1, value);
  const auto from = above - 1;
  return {static_cast<std::size_t>(from - nodes.begin()), (value - *from) / (*above - *from)};
}

}  // namespace

FittedLight::FittedLight(const LightOptions& options, const almanac::SkyState& sky,
                         const algebra::Grid<double>& weights, std::span<const LitPlace> places,
                         std::size_t bins)
    : nodes_(dusts_per_m.size() * ozones_du.size()) {
  const auto moon = shadowed_moon(options, sky);
  const Setting setting{options,
                        moon,
                        arrangement_of(options, moon.sun_distance_m, depths_of(moon, work.planes)),
                        wavelengths_nm(work.bands),
                        distances_over_the_disc(moon),
                        at_wavelengths(weights, work.bands),
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
  const auto dust = way_to(dusts_per_m, dust_per_m), ozone = way_to(ozones_du, ozone_du);
  const auto node = [&](std::size_t d, std::size_t o) -> const Mixed& {
    return nodes_[(dust.from + d) * ozones_du.size() + ozone.from + o];
  };
  Mixed result = node(0, 0);
  const auto between = [&](algebra::Grid<double>& all, algebra::Grid<double> Mixed::*part) {
    for (std::size_t i = 0; i < all.values().size(); ++i) {
      const auto along = [&](std::size_t d) {
        const double from = (node(d, 0).*part).values()[i], to = (node(d, 1).*part).values()[i];
        return from + ozone.share * (to - from);
      };
      all.values()[i] = std::exp(along(0) + dust.share * (along(1) - along(0)));
    }
  };
  between(result.clear, &Mixed::clear);
  between(result.cloudy, &Mixed::cloudy);
  return result;
}

algebra::Grid<double> FittedLight::at(double dust_per_m, double cloud_cover,
                                      double ozone_du) const {
  auto [clear, cloudy] = mixed(dust_per_m, ozone_du);
  for (std::size_t i = 0; i < clear.values().size(); ++i)
    clear.values()[i] += cloud_cover * (cloudy.values()[i] - clear.values()[i]);
  return clear;
}

}  // namespace coppermoon::verbs
