// SPDX-License-Identifier: MIT
#include "uses/picture/sky_lights.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>

#include "almanac/planets.h"
#include "almanac/stars.h"
#include "atmosphere/astronomical_refraction.h"
#include "colour/working_space.h"
#include "povray_scenes/scene_camera.h"
#include "uses/light/photometer.h"
#include "uses/light/spectral_bands.h"
#include "uses/picture/pixels.h"

namespace coppermoon::uses {
namespace {

/// A cone of directions, given by its axis and the cosine of the angle between axis and edge.
struct Cone {
  glm::dvec3 middle;  ///< axis, a unit vector in the GCRS
  double cosine;

  bool holds(const glm::dvec3& direction) const { return glm::dot(direction, middle) >= cosine; }
};

/// A star or planet as seen from the observer's place (GCRS axes), without refraction or extinction by the air.
struct Source {
  glm::dvec3 direction;
  double magnitude, b_minus_v;
  double radius_rad = 0;
};

/// Stars and planets within a cone, down to the faintest magnitude.
///
/// Given  from_m  the observer's geocentric position
std::vector<Source> sources_in(const Cone& cone, double faintest, const almanac::SkyState& sky,
                               const glm::dvec3& from_m) {
  std::vector<almanac::Star> stars;
  for (const auto& star : almanac::stars())
    if (star.magnitude <= faintest && cone.holds(star.place)) stars.push_back(star);
  const auto directions = almanac::apparent_directions(stars, sky.when);
  std::vector<Source> sources;
  for (std::size_t i = 0; i < stars.size(); ++i)
    sources.push_back({directions[i], stars[i].magnitude, stars[i].b_minus_v});
  for (const auto& planet : almanac::planets_at(sky.when)) {
    const glm::dvec3 seen = planet.position_m - from_m;
    const double away_m = glm::length(seen);
    if (planet.magnitude <= faintest && cone.holds(seen / away_m))
      sources.push_back({seen / away_m, planet.magnitude, planet.b_minus_v,
                         algebra::in_metres(planet.radius) / away_m});
  }
  return sources;
}

/// Splits a planet into equal points spread over its disc; a star is one point.
std::vector<Source> in_points(const Source& source) {
  constexpr int points = 64;
  constexpr double golden_angle = std::numbers::pi * (3 - 2.23606797749979);
  if (source.radius_rad == 0) return {source};
  const glm::dvec3 aside =
      std::abs(source.direction.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
  const glm::dvec3 east = glm::normalize(glm::cross(aside, source.direction)),
                   north = glm::cross(source.direction, east);
  std::vector<Source> all;
  for (int k = 0; k < points; ++k) {
    const double out = source.radius_rad * std::sqrt((k + 0.5) / points), turn = k * golden_angle;
    all.push_back(
        {glm::normalize(source.direction + out * (std::cos(turn) * east + std::sin(turn) * north)),
         source.magnitude + 2.5 * std::log10(points), source.b_minus_v});
  }
  return all;
}

/// The sky over an observer: the places of stars and planets in it, and their light as dimmed by the air.
class Dome {
 public:
  Dome(const View& view, const almanac::SkyState& sky)
      : seen_(almanac::view_from(*view.observer, sky)),
        lowest_(horizon_altitude(*view.observer)),
        lights_(view.sightline ? std::optional(view.sightline->air) : std::nullopt, view.response) {
  }

  const almanac::ObserverView& seen() const { return seen_; }

  algebra::Angle altitude(const glm::dvec3& direction) const {
    return algebra::radians(std::asin(std::clamp(glm::dot(direction, seen_.zenith), -1., 1.)));
  }

  bool shows(const glm::dvec3& direction) const {
    return algebra::in_radians(altitude(direction) - lowest_) > 0;
  }

  std::array<double, 3> light_of(const Source& source) const {
    return lights_.lux(source.magnitude, source.b_minus_v,
                       std::max(altitude(source.direction), atmosphere::lowest_true_altitude));
  }

  /// Angle by which refraction raises light from a direction.
  double lift_rad(const glm::dvec3& direction) const {
    const auto stands = altitude(direction);
    return algebra::in_radians(atmosphere::apparent_altitude(stands) - stands);
  }

  /// Raises a direction by its own refraction. lowered_as lowers a direction by the refraction of another direction.
  glm::dvec3 raised(const glm::dvec3& direction) const {
    return turned(direction, direction, lift_rad(direction));
  }
  glm::dvec3 lowered_as(const glm::dvec3& other, const glm::dvec3& direction) const {
    return turned(direction, other, -lift_rad(other));
  }

  povray_scenes::HorizonPlace place_of(const glm::dvec3& direction) const {
    const glm::dvec3 east = glm::normalize(glm::cross(seen_.north, seen_.zenith)),
                     north = glm::cross(seen_.zenith, east);
    const double azimuth = std::atan2(glm::dot(direction, east), glm::dot(direction, north));
    return {atmosphere::apparent_altitude(altitude(direction)),
            algebra::within_circle(algebra::radians(azimuth))};
  }

 private:
  /// Turns a direction by an angle, in the vertical plane of another direction.
  glm::dvec3 turned(const glm::dvec3& direction, const glm::dvec3& other, double angle) const {
    const glm::dvec3 level = glm::cross(other, seen_.zenith);
    const double across = glm::length(level);
    if (across == 0) return direction;
    return glm::angleAxis(angle, level / across) * direction;
  }

  almanac::ObserverView seen_;
  algebra::Angle lowest_;  ///< lowest altitude of lights that can be seen
  StarLights lights_;
};

/// Cone around a camera's field. It is a degree wider, because refraction may raise a star or planet by that much.
Cone cone_of(const povray_scenes::SceneCamera& camera, const almanac::SkyState& sky) {
  constexpr double margin = std::numbers::pi / 180;
  const double half_width = std::tan(algebra::in_radians(camera.horizontal_field) / 2),
               half_height = half_width * static_cast<double>(camera.height) /
                             static_cast<double>(camera.width);
  const double reach = std::atan(std::hypot(half_width, half_height)) + margin;
  return {glm::transpose(sky.selenographic_from_gcrs) * line_of_sight(camera), std::cos(reach)};
}

/// Computes how the observer of a view sees the stars and planets.
class Eye {
 public:
  Eye(const View& view, const almanac::SkyState& sky)
      : view_(view), sky_(sky), above_({}, view.response) {
    if (view.observer) dome_.emplace(view, sky);
    if (dome_) from_m_ = dome_->seen().position_m;
    const glm::dvec3 moon_m = sky.moon_m - from_m_;
    moon_ = glm::normalize(moon_m);
    limb_ = almanac::lunar_radius / algebra::metres(glm::length(moon_m));
  }

  std::vector<Source> sources() const {
    if (!view_.stars.shown) return {};
    return sources_in(cone_of(view_.camera, sky_),
                      view_.stars.faintest.value_or(std::numeric_limits<double>::infinity()), sky_,
                      from_m_);
  }

  bool ground_hides(const glm::dvec3& direction) const { return dome_ && !dome_->shows(direction); }
  bool moon_hides(const glm::dvec3& direction) const {
    return glm::dot(direction, moon_) > 0 && glm::length(glm::cross(direction, moon_)) < limb_;
  }

  SkyLight seen(const Source& source) const {
    auto direction = source.direction;
    if (dome_ && view_.refracted) direction = dome_->lowered_as(moon_, dome_->raised(direction));
    return {sky_.selenographic_from_gcrs * direction,
            dome_ ? dome_->light_of(source) : above_.lux(source.magnitude, source.b_minus_v),
            source.radius_rad};
  }

 private:
  const View& view_;
  const almanac::SkyState& sky_;
  StarLights above_;  ///< light as seen from space
  std::optional<Dome> dome_;
  glm::dvec3 from_m_{0, 0, 0}, moon_;
  double limb_;  ///< sine of the Moon's angular radius
};

/// The shares of a Gaussian that fall on successive pixels along a line.
struct Spread {
  std::ptrdiff_t first = 0;
  std::vector<double> shares;
};

Spread spread_about(double place) {
  constexpr double deviation_px = 0.6, reach_px = 4;  // 3e-11 of the light falls outside
  const auto below = [&](double edge) {
    return 0.5 * std::erfc(-(edge - place) / (deviation_px * std::numbers::sqrt2));
  };
  Spread spread{static_cast<std::ptrdiff_t>(std::floor(place - reach_px)), {}};
  const auto last = static_cast<std::ptrdiff_t>(std::floor(place + reach_px));
  for (auto pixel = spread.first; pixel <= last; ++pixel)
    spread.shares.push_back(below(static_cast<double>(pixel + 1)) -
                            below(static_cast<double>(pixel)));
  return spread;
}

/// Spectral bands of 5 nm, the V filter's response in each of them, and the sunlight that passes this filter.
struct StarBands : BroadBands {
  std::vector<double> v{};
  double solar_magnitude = photometric_bands()[V_band].solar_magnitude, sun_in_v = 0;
};

const StarBands& bands_of_light() {
  static const StarBands all = [] {
    StarBands bands{broad_bands(5)};
    const auto response = photometric_response(bands.edges_nm);
    bands.v.assign(response.row(V_band).begin(), response.row(V_band).end());
    bands.sun_in_v = std::inner_product(bands.v.begin(), bands.v.end(), bands.sunlight.begin(), 0.);
    return bands;
  }();
  return all;
}

/// Planck's law, on an arbitrary scale.
double black_body(double wavelength_nm, double temperature_k) {
  constexpr double second_radiation_nm_k = 1.438776877e7;  // CODATA 2018, hc/k
  return std::pow(wavelength_nm, -5) /
         std::expm1(second_radiation_nm_k / (wavelength_nm * temperature_k));
}

}  // namespace

std::vector<SkyLight> sky_lights(const View& view, const almanac::SkyState& sky) {
  const Eye eye(view, sky);
  std::vector<SkyLight> lights;
  for (const auto& source : eye.sources())
    for (const auto& point : in_points(source))
      if (!eye.moon_hides(point.direction) && !eye.ground_hides(point.direction))
        lights.push_back(eye.seen(point));
  return lights;
}

std::vector<SkyLight> scene_lights(const View& view, const almanac::SkyState& sky) {
  const Eye eye(view, sky);
  std::vector<SkyLight> lights;
  for (const auto& source : eye.sources())
    if (!eye.ground_hides(source.direction)) lights.push_back(eye.seen(source));
  return lights;
}

void add_lights(texture::Image& frame, const povray_scenes::SceneCamera& camera,
                std::span<const SkyLight> lights) {
  const auto sight = povray_scenes::sight_of(camera);
  const glm::dvec3 forward = line_of_sight(camera), area = glm::cross(sight.across, sight.down);
  const double pixel = glm::length(sight.across);
  const auto width = static_cast<std::ptrdiff_t>(frame.width),
             height = static_cast<std::ptrdiff_t>(frame.height);
  std::map<std::pair<std::size_t, std::size_t>, std::array<double, 3>> sums;  // by row and column
  for (const auto& light : lights) {
    const double depth = glm::dot(light.direction, forward);
    if (depth <= 0) continue;
    const glm::dvec3 place = light.direction / depth - sight.corner;
    const double x = glm::dot(place, sight.across) / (pixel * pixel),
                 y = glm::dot(place, sight.down) / (pixel * pixel);
    constexpr double margin = 10;
    if (!(x > -margin && y > -margin && x < static_cast<double>(width) + margin &&
          y < static_cast<double>(height) + margin))
      continue;
    const auto across = spread_about(x), down = spread_about(y);
    for (std::size_t j = 0; j < down.shares.size(); ++j)
      for (std::size_t i = 0; i < across.shares.size(); ++i) {
        const auto column = across.first + static_cast<std::ptrdiff_t>(i),
                   row = down.first + static_cast<std::ptrdiff_t>(j);
        if (column < 0 || row < 0 || column >= width || row >= height) continue;
        const glm::dvec3 ray = sight.corner + (static_cast<double>(column) + 0.5) * sight.across +
                               (static_cast<double>(row) + 0.5) * sight.down;
        const double away = glm::length(ray);
        const double solid_angle = std::abs(glm::dot(area, ray)) / (away * away * away);
        const double share = across.shares[i] * down.shares[j] / solid_angle;
        for (std::size_t k = 0; k < 3; ++k)
          sums[{static_cast<std::size_t>(row), static_cast<std::size_t>(column)}][k] +=
              share * light.illuminance_lux[k];
      }
  }
  for (const auto& [place, sum] : sums)
    for (std::size_t k = 0; k < 3; ++k) {
      float& value = frame(place.first, place.second, k);
      value = as_half(value + sum[k]);
    }
}

std::vector<povray_scenes::StarInSky> lights_over(const View& view, const almanac::SkyState& sky) {
  constexpr double naked_eye = 6.5;
  if (!view.stars.shown) return {};
  const Dome dome(view, sky);
  const Cone above{dome.seen().zenith,
                   std::sin(algebra::in_radians(horizon_altitude(*view.observer)))};
  auto sources =
      sources_in(above, view.stars.faintest.value_or(naked_eye), sky, dome.seen().position_m);
  std::ranges::stable_sort(sources, {}, &Source::magnitude);
  std::vector<povray_scenes::StarInSky> lights;
  for (const auto& source : sources)
    if (dome.shows(source.direction))
      lights.push_back({dome.place_of(source.direction), dome.light_of(source)});
  return lights;
}

double star_temperature_k(double b_minus_v) {
  const double colour = 0.92 * std::clamp(b_minus_v, -0.5, 4.);
  return 4600 * (1 / (colour + 1.7) + 1 / (colour + 0.62));
}

StarLights::StarLights(const std::optional<atmosphere::ObserverAir>& air,
                       const std::string& response)
    : channels_(response.empty()
                    ? bands_of_light().channels
                    : colour::channel_weights(picture_space, bands_of_light().edges_nm, response)) {
  if (!air) return;
  for (const double centre : bands_of_light().centres_nm)
    depths_.push_back(atmosphere::vertical_depths(*air, algebra::nanometres(centre)));
}

std::array<double, 3> StarLights::lux(double magnitude, double b_minus_v,
                                      algebra::Angle altitude) const {
  const auto& bands = bands_of_light();
  const double temperature_k = star_temperature_k(b_minus_v);
  double in_v = 0;
  std::array<double, 3> light{};
  for (std::size_t b = 0; b < bands.centres_nm.size(); ++b) {
    const double above = black_body(bands.centres_nm[b], temperature_k);
    in_v += bands.v[b] * above;
    const double seen =
        depths_.empty() ? above : above * atmosphere::transmittance_above(depths_[b], altitude);
    for (std::size_t k = 0; k < 3; ++k) light[k] += channels_(k, b) * seen;
  }
  const double scale =
      bands.sun_in_v / in_v * std::pow(10, -0.4 * (magnitude - bands.solar_magnitude));
  for (double& channel : light) channel *= scale;
  into_gamut_or_black(picture_space, light);
  return light;
}

}  // namespace coppermoon::uses
