// SPDX-License-Identifier: MIT
#include "uses/light/ring_strip.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <numbers>

#include "algebra/error.h"
#include "eclipse/shadow_axis.h"
#include "photons/solar_disc.h"
#include "result/columns.h"
#include "shadow/limb_ring.h"
#include "uses/light/header.h"
#include "uses/light/spectral_bands.h"

namespace coppermoon::uses {
namespace {

using algebra::in_degrees;
using std::numbers::pi;

constexpr std::size_t ring_columns = 1440, ring_rows = 256;
constexpr int ring_bands = 40;

/// Observer on the Moon who looks at the Earth. Vectors have GCRS axes.
struct Lookout {
  almanac::SelenographicPoint place;
  glm::dvec3 position_m, zenith, celestial_pole;

  glm::dvec3 earthward() const { return -glm::normalize(position_m); }
  algebra::Angle earth_altitude() const {
    return algebra::radians(std::asin(glm::dot(earthward(), zenith)));
  }
  /// Position angle of the zenith; none if the Earth is there.
  std::optional<algebra::Angle> zenith_angle() const {
    constexpr double there_rad = 1e-6;
    if (glm::length(zenith - earthward()) < there_rad) return {};
    return position_angle(zenith);
  }
  /// Position angle of a direction about the Earth's centre, on the observer's sky.
  algebra::Angle position_angle(const glm::dvec3& direction) const {
    return almanac::position_angle(earthward(), direction, celestial_pole);
  }
};

Lookout lookout_at(const almanac::SelenographicPoint& place, const almanac::SkyState& sky) {
  const auto zenith =
      glm::transpose(sky.selenographic_from_gcrs) * almanac::selenographic_direction(place);
  return {place, sky.moon_m + algebra::in_metres(almanac::lunar_radius) * zenith, zenith,
          glm::row(sky.equator_from_gcrs, 2)};
}

void require_earth_in_sight(const Lookout& lookout) {
  const double altitude_deg = in_degrees(lookout.earth_altitude());
  if (altitude_deg > 0) return;
  throw algebra::Error(fmt::format(
      "at {:.2f},{:.2f} on the Moon the Earth stands {:.1f} degrees "
      "below the horizon, allowed above",
      in_degrees(lookout.place.latitude), in_degrees(lookout.place.longitude), -altitude_deg));
}

void require_umbra(const Lookout& lookout, const atmosphere::Atmosphere& air,
                   const shadow::Arrangement& arrangement, const eclipse::ShadowPlace& there) {
  double direct = 1;
  shadow::DirectLight(air, arrangement, std::array{550.})
      .ratios(algebra::in_metres(there.axis_distance), algebra::in_radians(there.position_angle),
              algebra::in_metres(there.depth), {&direct, 1});
  if (direct <= 0) return;
  throw algebra::Error(fmt::format(
      "{:.2g} of the Sun's light comes straight to {:.2f},{:.2f} on the Moon, allowed 0: the ring "
      "is seen from the umbra",
      direct, in_degrees(lookout.place.latitude), in_degrees(lookout.place.longitude)));
}

/// Weights of wavelengths that convert radiance, relative to the Sun's mean radiance, to picture_space [cd/m²] times
/// `scale`. The Sun's radiance is that of sunlit white ground at 1 au, times (1 au / solar radius)².
shadow::ChannelWeights sun_weights(double scale) {
  auto weights = white_ground_weights(colour::channel_weights(picture_space, band_edges_nm()));
  const double radii = almanac::astronomical_unit_m / photons::solar_radius_m;
  for (double& weight : weights.values()) weight *= scale * radii * radii;
  return at_wavelengths(weights, ring_bands);
}

/// Inner and outer edge of the ring's image, as angles from the Earth's centre.
struct Angles {
  double inner_rad, outer_rad;

  double angle(std::size_t row) const {
    return std::lerp(outer_rad, inner_rad, (static_cast<double>(row) + 0.5) / ring_rows);
  }
};

Angles angles_of(const shadow::LimbRing& ring) {
  const auto [lowest, highest] = ring.extent();
  if (!(highest > lowest))
    throw algebra::Error("this air bends no sunlight to that place: the ring is black");
  return {std::asin(lowest / ring.distance_m()), std::asin(highest / ring.distance_m())};
}

/// Image of the Earth's ring.
///
/// Given  north_rad  position angle of the shadow frame's Y axis on the sky, where the X axis points west
///        weights    (channel, wavelength), for radiance relative to the Sun's mean
texture::Image image_of(const shadow::LimbRing& ring, const Angles& angles, double north_rad,
                        const shadow::ChannelWeights& weights) {
  texture::Image image(ring_columns, ring_rows, {"R", "G", "B"});
  tbb::parallel_for(std::size_t{0}, ring_rows, [&](std::size_t row) {
    const double impact_m = ring.distance_m() * std::sin(angles.angle(row));
    std::vector<double> radiance(ring_bands);
    for (std::size_t column = 0; column < ring_columns; ++column) {
      const double angle = 2 * pi * (static_cast<double>(column) + 0.5) / ring_columns;
      ring.radiance(north_rad - angle, impact_m, radiance);
      std::array<double, 3> channels{};
      for (std::size_t c = 0; c < channels.size(); ++c)
        for (std::size_t w = 0; w < radiance.size(); ++w)
          channels[c] += weights(c, w) * radiance[w];
      into_gamut_or_black(picture_space, channels);
      for (std::size_t c = 0; c < channels.size(); ++c)
        image(row, column, c) = static_cast<float>(channels[c]);
    }
  });
  return image;
}

RingFigures figures_of(const Lookout& lookout, const glm::dvec3& sun_m, const Angles& angles,
                       double scale) {
  return {lookout.place,
          algebra::radians(angles.inner_rad),
          algebra::radians(angles.outer_rad),
          glm::length(lookout.position_m) / 1e3,
          lookout.earth_altitude(),
          lookout.zenith_angle(),
          lookout.position_angle(sun_m - lookout.position_m),
          scale};
}

}  // namespace

RingStrip ring_strip(const LightRequest& request, const almanac::SkyState& sky,
                     const std::optional<almanac::SelenographicPoint>& on, double scale) {
  algebra::require_within("scale", scale, 1e-9, 1e9);
  const auto lookout = lookout_at(on.value_or(sky.sub_earth), sky);
  require_eclipse(sky.when);
  require_earth_in_sight(lookout);
  const auto axis = eclipse::shadow_axis(sky);
  const auto there = eclipse::place_in_shadow(axis, lookout.position_m);
  const auto moon = shadowed_moon(request, sky);
  const auto arrangement = arrangement_of(moon, {algebra::in_metres(there.depth)});
  require_umbra(lookout, moon.air, arrangement, there);
  const shadow::LimbRing ring(moon.air, arrangement, there, wavelengths_nm(ring_bands));
  const auto angles = angles_of(ring);
  const auto north = lookout.position_angle(glm::row(axis.shadow_from_gcrs, 1));
  RingStrip strip{image_of(ring, angles, algebra::in_radians(north), sun_weights(scale)),
                  figures_of(lookout, sky.sun_m, angles, scale),
                  scene_linear_header(picture_space, sky.when)};
  for (const auto& [name, values] : result::columns_of(std::array{strip.figures}))
    if (std::isfinite(values.front()))
      strip.attributes["coppermoon:" + name] = static_cast<float>(values.front());
  return strip;
}

}  // namespace coppermoon::uses
