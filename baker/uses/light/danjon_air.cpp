// SPDX-License-Identifier: MIT
#include "uses/light/danjon_air.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <numbers>
#include <numeric>
#include <span>

#include "algebra/error.h"
#include "algebra/interpolation.h"
#include "algebra/quadrature.h"
#include "almanac/ephemeris.h"
#include "almanac/lunar_orientation.h"
#include "eclipse/contacts.h"
#include "eclipse/shadow_axis.h"
#include "shadow/by_quadrature.h"
#include "uses/light/photometer.h"
#include "uses/light/spectral_bands.h"

namespace coppermoon::uses {
namespace {

using std::numbers::pi;

constexpr int coarse_bands = 10;
constexpr std::size_t coarse_sectors = 24;

/// A place on the Moon's disc. All places represent equal areas.
struct Place {
  double axis_distance_m, position_angle_rad;
};

std::vector<Place> places_over(const eclipse::ShadowPlace& centre, double axis_distance_m) {
  constexpr int rings = 4, around = 16;
  const double radius = algebra::in_metres(almanac::lunar_radius),
               angle = algebra::in_radians(centre.position_angle);
  const double x = axis_distance_m * std::sin(angle), y = axis_distance_m * std::cos(angle);
  std::vector<Place> places;
  for (int r = 0; r < rings; ++r)
    for (int a = 0; a < around; ++a) {
      const double away = radius * std::sqrt((r + 0.5) / rings), turn = 2 * pi * a / around;
      const double px = x + away * std::sin(turn), py = y + away * std::cos(turn);
      places.push_back({std::hypot(px, py), std::atan2(px, py)});
    }
  return places;
}

/// The eclipse nearest to a moment, at maximum. If the Moon is not wholly inside the umbra, it is moved just inside.
class Totality {
 public:
  explicit Totality(const almanac::SkyState& near)
      : sky_(almanac::sky_at(
            eclipse::nearest_eclipse(near.when, eclipse::ShadowConvention::danjon).greatest)) {
    const auto axis = eclipse::shadow_axis(sky_);
    const auto centre = eclipse::place_in_shadow(axis, sky_.moon_m);
    arrangement_ = {
        algebra::in_metres(axis.sun_distance), {algebra::in_metres(centre.depth)}, true};
    dimmer_ = std::pow(glm::length(sky_.moon_m) / mean_distance_m *
                           algebra::in_metres(axis.sun_distance) / almanac::astronomical_unit_m,
                       2);
    const double radius = algebra::in_metres(almanac::lunar_radius);
    const double umbra_m =
        shadow::landing_m(atmosphere::earth_equatorial_radius_m, 0, arrangement_.sun_distance_m,
                          arrangement_.depths_m[0]) -
        shadow::projected_solar_radius_m(arrangement_, arrangement_.depths_m[0]);
    const double deep = std::min(algebra::in_metres(centre.axis_distance), umbra_m - radius);
    places_ = places_over(centre, deep);
    for (double d = 0; d < deep + radius + spacing_m; d += spacing_m) distances_m_.push_back(d);
  }

  /// Visual magnitude of the eclipsed Moon, without extinction by an observer's air.
  double magnitude(const atmosphere::Atmosphere& air) const {
    const auto waves = wavelengths_nm(coarse_bands);
    const auto light =
        shadow::by_quadrature(with_fewer_belts(air), arrangement_, waves, distances_m_,
                              {.rays = 100, .sun_terms = 2, .sectors = {coarse_sectors}});
    const auto weights = at_wavelengths(photometer().weights, coarse_bands);
    double all = 0, seen = 0;
    for (std::size_t w = 0; w < waves.size(); ++w) {
      all += weights(visual, w);
      for (const auto& place : places_)
        seen += weights(visual, w) * at(light, place, w) / static_cast<double>(places_.size());
    }
    return full_moon - 2.5 * std::log10(std::max(seen / all, 1e-12) / dimmer_);
  }

 private:
  static constexpr double spacing_m = 200e3, mean_distance_m = 3.844e8;
  static constexpr std::size_t visual = 1;  ///< index of V among the photometer's channels
  /// Visual magnitude of an unshadowed full Moon, at mean distances of Sun and Moon and a phase angle of 1.5° (ROLO).
  static constexpr double full_moon = -12.73;

  double at(const shadow::RefractedLight& light, const Place& place, std::size_t wave) const {
    const double along = place.axis_distance_m / spacing_m;
    const auto i = std::min(static_cast<std::size_t>(along), distances_m_.size() - 2);
    const auto& ratio =
        light.ratio[shadow::Sectors{light.sectors}.nearest(place.position_angle_rad)];
    return std::lerp(ratio(i, wave), ratio(i + 1, wave), along - static_cast<double>(i));
  }

  almanac::SkyState sky_;
  shadow::Arrangement arrangement_;
  std::vector<Place> places_;
  std::vector<double> distances_m_;
  double dimmer_ = 1;  ///< factor by which the distances of Sun and Moon dim the Moon
};

/// Clearness of the air at which the Moon has the given visual magnitude, interpolated with a polynomial through
/// up to four known points. `bright` is the index of the first known point at least as bright as `magnitude`.
template <typename Known>
double between(std::span<const Known> known, std::size_t bright, double magnitude) {
  const std::size_t first = bright > 1 ? bright - 2 : 0,
                    count = std::min(bright + 2, known.size()) - first;
  std::vector<double> nodes;
  for (const auto& one : known.subspan(first, count)) nodes.push_back(one.magnitude);
  const auto shares = algebra::on_polynomial(nodes, magnitude);
  double at = 0;
  for (std::size_t i = 0; i < count; ++i) at += shares[i] * known[first + i].clearness;
  const double dark = known[bright - 1].clearness, light = known[bright].clearness;
  return at > dark && at < light ? at : std::midpoint(dark, light);
}

void clear(atmosphere::Column& column, double clearness) {
  const double left = 1 - std::max(0., clearness);
  atmosphere::scale_cloud_and_aerosol(column, left);
  if (!column.stratospheric_layer) return;
  const double depth = left * column.stratospheric_layer->optical_depth() - std::min(0., clearness);
  column.stratospheric_layer = std::make_shared<atmosphere::StratosphericLayer>(
      column.stratospheric_layer->with_optical_depth(std::min(depth, 2.)));
}

}  // namespace

atmosphere::Atmosphere cleared(atmosphere::Atmosphere air, double clearness) {
  for (auto& belt : air.belts) clear(belt.column, clearness);
  return air;
}

DanjonScale::DanjonScale(const atmosphere::Atmosphere& air, const almanac::SkyState& sky)
    : magnitude_([air, totality = Totality(sky)](double clearness) {
        return totality.magnitude(cleared(air, clearness));
      }) {}

void DanjonScale::add(double clearness, std::vector<Known>& known) {
  const auto kept = magnitudes_.find(clearness);
  const double magnitude = kept != magnitudes_.end() ? kept->second : magnitude_(clearness);
  magnitudes_.emplace(clearness, magnitude);
  const auto after = std::ranges::upper_bound(known, clearness, {}, &Known::clearness);
  known.insert(after, {clearness, magnitude});
}

double DanjonScale::clearness(int l) {
  algebra::require_within("Danjon", l, 0, 4);
  constexpr double first_step = 1. / 16, factor = 4, near_mag = 0.02, least_part = 0.05;
  const double asked = 4.2 - 3. * l + l * l / 4.;
  std::vector<Known> known;
  add(0, known);
  for (;;) {
    const auto is_bright = [&](const Known& one) { return one.magnitude <= asked; };
    const auto bright =
        static_cast<std::size_t>(std::ranges::find_if(known, is_bright) - known.begin());
    if (bright == known.size()) {
      if (known.back().clearness == brightest_clearness) return brightest_clearness;
      add(brightest_clearness, known);
    } else if (bright == 0) {
      const double darkest = known.front().clearness;
      if (darkest == darkest_clearness) return darkest_clearness;
      add(std::max(darkest_clearness, factor * std::min(darkest, -first_step / factor)), known);
    } else {
      const auto &dark = known[bright - 1], &light = known[bright];
      const double found = between(std::span<const Known>(known), bright, asked);
      const double off = std::min(dark.magnitude - asked, asked - light.magnitude);
      const double width = light.clearness - dark.clearness;
      if (off < near_mag || width < clearness_error / 2) return found;
      add(std::clamp(found, dark.clearness + least_part * width,
                     light.clearness - least_part * width),
          known);
    }
  }
}

}  // namespace coppermoon::uses
