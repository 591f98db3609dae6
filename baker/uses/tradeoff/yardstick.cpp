// SPDX-License-Identifier: MIT
#include "uses/tradeoff/yardstick.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

#include "algebra/error.h"
#include "algebra/interpolation.h"
#include "colour/cie_observer.h"
#include "colour/difference.h"
#include "colour/working_space.h"
#include "eclipse/shadow_axis.h"
#include "photons/solar_disc.h"
#include "shadow/by_quadrature.h"
#include "shadow/lookup.h"
#include "surface/albedo_map.h"
#include "texture/bake.h"
#include "uses/light/shadow_profile.h"
#include "uses/light/spectral_bands.h"
#include "uses/picture/development.h"
#include "uses/picture/pixels.h"

namespace coppermoon::uses {
namespace {

using algebra::Grid;

constexpr double umbra_m = 4500e3;

/// Luminance of sunlight in each spectral band.
std::vector<double> luminance_of_sunlight(std::size_t bands) {
  const auto edges = band_edges_nm();
  const auto xyz = colour::xyz_weights(edges);
  const auto sunlight = photons::solar_irradiance(edges);
  Grid<double> weights(1, sunlight.size());
  for (std::size_t b = 0; b < sunlight.size(); ++b) weights(0, b) = sunlight[b] * xyz(1, b);
  const auto few = at_wavelengths(weights, static_cast<int>(bands));
  return {few.row(0).begin(), few.row(0).end()};
}

double weighted(std::span<const double> ratios, std::span<const double> weights) {
  return std::inner_product(ratios.begin(), ratios.end(), weights.begin(), 0.);
}

/// Luminance of refracted light, with a row for each sector and a column for each place.
Grid<double> luminance_of(const shadow::RefractedLight& light) {
  const auto weights = luminance_of_sunlight(light.wavelengths_nm.size());
  Grid<double> luminance(light.sectors, light.axis_distances_m.size());
  for (std::size_t s = 0; s < luminance.rows(); ++s)
    for (std::size_t d = 0; d < luminance.columns(); ++d)
      luminance(s, d) = weighted(light.ratio[s].row(d), weights);
  return luminance;
}

Grid<double> luminance_of(const shadow::DirectLight& light, double depth_m, std::size_t sectors,
                          std::span<const double> distances_m, std::size_t bands) {
  const auto weights = luminance_of_sunlight(bands);
  Grid<double> luminance(sectors, distances_m.size());
  tbb::parallel_for(std::size_t{0}, sectors, [&](std::size_t s) {
    const double angle = shadow::Sectors{sectors}.angle_rad(s);
    std::vector<double> ratios(bands);
    for (std::size_t d = 0; d < distances_m.size(); ++d) {
      light.ratios(distances_m[d], angle, depth_m, ratios);
      luminance(s, d) = weighted(ratios, weights);
    }
  });
  return luminance;
}

Grid<double> sum(Grid<double> a, const Grid<double>& b) {
  for (std::size_t i = 0; i < a.values().size(); ++i) a.values()[i] += b.values()[i];
  return a;
}

/// Mean of a field over one of `sectors` sectors, for each axis distance, computed from four angles in the sector.
std::vector<double> over_sector(const Grid<double>& field, std::size_t sector,
                                std::size_t sectors) {
  constexpr int angles = 4;
  std::vector<double> mean(field.columns());
  for (int k = 0; k < angles; ++k) {
    const double turn = (static_cast<double>(sector) + (k + 0.5) / angles - 0.5) /
                        static_cast<double>(sectors) * static_cast<double>(field.rows());
    const double first = std::floor(turn), part = turn - first;
    const auto low =
        (static_cast<std::size_t>(first + static_cast<double>(field.rows()))) % field.rows();
    const auto a = field.row(low), b = field.row((low + 1) % field.rows());
    for (std::size_t d = 0; d < mean.size(); ++d) mean[d] += std::lerp(a[d], b[d], part) / angles;
  }
  return mean;
}

/// Accumulates relative errors of light, weighted by area.
class Errors {
 public:
  void add(double found, double expected, double area) {
    const double error = std::abs(found / expected - 1);
    squares_ += area * error * error;
    area_ += area;
    worst_ = std::max(worst_, error);
  }
  Spread spread() const { return {std::sqrt(squares_ / area_), worst_}; }

 private:
  double squares_ = 0, area_ = 0, worst_ = 0;
};

/// Orthographic view of the Moon's disc from the Earth's centre, on a black background.
texture::Image seen_from_earth(const texture::Image& texture, const almanac::SkyState& sky,
                               std::size_t pixels) {
  const glm::dvec3 to_earth = almanac::selenographic_direction(sky.sub_earth);
  const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 0, 1), to_earth)),
                   up = glm::cross(to_earth, right);
  texture::Image seen(pixels, pixels, texture.channels);
  for (std::size_t c = 0; c < texture.channels.size(); ++c) {
    const auto channel = channel_of(texture, c);
    tbb::parallel_for(std::size_t{0}, pixels, [&](std::size_t row) {
      const double y = 1 - (2 * static_cast<double>(row) + 1) / static_cast<double>(pixels);
      for (std::size_t column = 0; column < pixels; ++column) {
        const double x = (2 * static_cast<double>(column) + 1) / static_cast<double>(pixels) - 1;
        const double squared = 1 - x * x - y * y;
        if (squared <= 0) continue;
        const auto at =
            almanac::selenographic_point(x * right + y * up + std::sqrt(squared) * to_earth);
        seen(row, column, c) = static_cast<float>(surface::sampled(channel, at));
      }
    });
  }
  return seen;
}

struct ErrorsByZone {
  Errors umbra, penumbra;

  /// Given  at_m  distance from the axis, used as the weight because the area is proportional to it
  void add(double found, double expected, double at_m) {
    (at_m < umbra_m ? umbra : penumbra).add(found, expected, at_m);
  }
  LightErrors spread() const { return {umbra.spread(), penumbra.spread(), {}}; }
};

/// Axis distances that the Moon's disc covers.
shadow::LookupRange over_the_disc(const almanac::SkyState& sky) {
  const double centre = algebra::in_metres(
      eclipse::place_in_shadow(eclipse::shadow_axis(sky), sky.moon_m).axis_distance);
  const double reach = algebra::in_metres(almanac::lunar_radius) + 50e3;
  return {.from_m = std::max(0., centre - reach), .to_m = centre + reach};
}

bool on_disc(std::size_t row, std::size_t column, std::size_t pixels) {
  const auto centred = [&](std::size_t i) {
    return (2 * static_cast<double>(i) + 1) / static_cast<double>(pixels) - 1;
  };
  return std::hypot(centred(row), centred(column)) < 1;
}

colour::Lab lab_of(const texture::Image& picture, std::size_t row, std::size_t column) {
  return colour::lab_from_srgb(
      {picture(row, column, 0), picture(row, column, 1), picture(row, column, 2)});
}

}  // namespace

MeasuredScene measured_scene(const MoonRequest& moon, const almanac::SkyState& sky) {
  const auto [air, arrangement] = shadow_at_the_moon(moon.light, sky);
  return {sky, air, arrangement, normal_albedo(moon), moon.photometry};
}

Yardstick::Yardstick(MeasuredScene scene, const ReferenceSettings& settings,
                     const algebra::Progress& progress)
    : scene_(std::move(scene)), settings_(settings) {
  const double reach =
      shadow::refracted_reach_m(scene_.arrangement, scene_.air, scene_.arrangement.depths_m[0]);
  for (double d = 0; d < reach + settings.spacing_m; d += settings.spacing_m)
    distances_m_.push_back(d);
  const auto light = shadow::by_quadrature(scene_.air, scene_.arrangement,
                                           wavelengths_nm(static_cast<int>(settings.bands)),
                                           distances_m_, {.rays = settings.rays}, progress);
  sectors_ = light.sectors;
  total_ = sum(luminance_of(light), direct(settings.bands));
  if (*std::ranges::min_element(total_.values()) <= 0)
    throw algebra::Error("no light reaches the middle of the shadow, to which errors are relative");
  texture_ = baked(light, settings.texture_width);
}

const Grid<double>& Yardstick::direct(std::size_t bands) {
  auto& field = direct_[bands];
  if (field.empty()) {
    const shadow::DirectLight light(scene_.air, scene_.arrangement,
                                    wavelengths_nm(static_cast<int>(bands)));
    field = luminance_of(light, scene_.arrangement.depths_m[0], sectors_, distances_m_, bands);
  }
  return field;
}

LightErrors Yardstick::errors_of(const shadow::RefractedLight& light, bool in_rings) {
  const auto refracted = luminance_of(light);
  const auto& clear = direct(light.wavelengths_nm.size());
  auto errors = in_rings ? errors_in_rings(refracted, clear, light.axis_distances_m)
                         : errors_at_places(refracted, clear);
  errors.picture =
      picture_errors(texture_, baked(light, settings_.texture_width), settings_.texture_width / 2);
  return errors;
}

LightErrors Yardstick::errors_at_places(const Grid<double>& refracted,
                                        const Grid<double>& clear) const {
  ErrorsByZone errors;
  for (std::size_t s = 0; s < sectors_; ++s)
    for (std::size_t d = 0; d < distances_m_.size(); ++d)
      errors.add(refracted(s, d) + clear(s, d), total_(s, d), distances_m_[d]);
  return errors.spread();
}

LightErrors Yardstick::errors_in_rings(const Grid<double>& refracted, const Grid<double>& clear,
                                       std::span<const double> rings_m) const {
  const double half = rings_m[0];
  ErrorsByZone errors;
  for (std::size_t s = 0; s < refracted.rows(); ++s) {
    const auto expected = over_sector(total_, s, refracted.rows()),
               beside = over_sector(clear, s, refracted.rows());
    for (std::size_t r = 0; r < rings_m.size(); ++r) {
      const double at = rings_m[r];
      if (at + half > distances_m_.back()) break;
      const auto there = [&](std::span<const double> values) {
        return algebra::interpolated(distances_m_, values, at);
      };
      errors.add(refracted(s, r) + there(beside), there(expected), at);
    }
  }
  return errors.spread();
}

texture::Image Yardstick::baked(const shadow::RefractedLight& light, std::size_t width) const {
  const std::size_t bands = light.wavelengths_nm.size();
  const shadow::DirectLight direct(scene_.air, scene_.arrangement, light.wavelengths_nm);
  shadow::Lookup lookup(
      light, direct,
      at_wavelengths(moonlight_weights(colour::channel_weights(picture_space, band_edges_nm())),
                     static_cast<int>(bands)),
      over_the_disc(scene_.sky));
  lookup.transform([](std::span<double> colour) { into_gamut_or_black(picture_space, colour); });
  return texture::bake({scene_.normal_albedo, scene_.sky, lookup}, {"R", "G", "B"}, width / 2,
                       scene_.photometry);
}

PictureErrors Yardstick::picture_errors(const texture::Image& reference,
                                        const texture::Image& other, std::size_t pixels) const {
  const Development camera{};
  const auto one = seen_from_earth(reference, scene_.sky, pixels);
  const auto exposures = exposures_for(camera, one, picture_space);
  const auto before = developed(camera, exposures, {one, picture_space}),
             after = developed(camera, exposures,
                               {seen_from_earth(other, scene_.sky, pixels), picture_space});
  std::vector<double> sizes;
  for (std::size_t r = 0; r < pixels; ++r)
    for (std::size_t c = 0; c < pixels; ++c)
      if (on_disc(r, c, pixels))
        sizes.push_back(colour::delta_e_2000(lab_of(before, r, c), lab_of(after, r, c)));
  std::ranges::sort(sizes);
  return {std::accumulate(sizes.begin(), sizes.end(), 0.) / static_cast<double>(sizes.size()),
          sizes[sizes.size() * 99 / 100]};
}

}  // namespace coppermoon::uses
