// SPDX-License-Identifier: MIT
#include "uses/dome/dome.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "algebra/error.h"
#include "result/columns.h"
#include "texture/write_image.h"
#include "uses/light/header.h"
#include "uses/light/photometer.h"
#include "uses/picture/brightness.h"
#include "uses/picture/clear_sky.h"
#include "uses/picture/picture_parameters.h"
#include "uses/picture/pixels.h"
#include "uses/picture/sky_lights.h"
#include "uses/picture/texture_recipe.h"

namespace coppermoon::uses {
namespace {

using std::numbers::pi;

/// Directions in the sky for the picture's rows and columns.
class Directions {
 public:
  explicit Directions(std::size_t columns) : columns_(columns), step_(2 * pi / double(columns)) {}

  std::size_t columns() const { return columns_; }
  std::size_t rows() const { return columns_ / 2; }
  std::size_t rows_above() const { return rows() / 2; }

  /// Altitude at the centre of a row [rad].
  double altitude(std::size_t row) const { return pi / 2 - (double(row) + 0.5) * step_; }
  /// Azimuth at the centre of a column [rad], −π to π.
  double azimuth(std::size_t column) const { return (double(column) + 0.5) * step_ - pi; }

  glm::dvec3 direction(std::size_t row, std::size_t column) const {
    return in_sky(algebra::radians(altitude(row)), algebra::radians(azimuth(column)));
  }

  /// Solid angle of each texel in a row [sr].
  double solid_angle(std::size_t row) const {
    return step_ * 2 * std::sin(step_ / 2) * std::cos(altitude(row));
  }

  /// Picture coordinates (x, y) of a direction, in texels from the upper left corner.
  std::pair<double, double> place(algebra::Angle altitude, algebra::Angle azimuth) const {
    return {(algebra::in_radians(azimuth) + pi) / step_,
            (pi / 2 - algebra::in_radians(altitude)) / step_};
  }

  /// Wraps a column number that lies beyond the left or right edge back into the picture.
  std::size_t around(std::ptrdiff_t column) const {
    const auto all = static_cast<std::ptrdiff_t>(columns_);
    return static_cast<std::size_t>((column % all + all) % all);
  }

 private:
  std::size_t columns_;
  double step_;  ///< angle between neighbouring rows or columns [rad]
};

void add(texture::Image& image, std::size_t row, std::size_t column, const Rgb& light,
         double factor) {
  for (std::size_t k = 0; k < light.size(); ++k)
    image(row, column, k) += static_cast<float>(factor * light[k]);
}

/// The Moon's place and brightness for an observer.
struct MoonOver {
  std::vector<double> magnitudes;  ///< by band, as seen from the Earth's centre without air
  Rgb lux{};  ///< on a surface that faces the Moon, through the air; 0 if the Moon is down
  povray_scenes::HorizonPlace place;
};

MoonOver moon_over(LitMoon moon, const ViewRequest& view) {
  MoonOver over{magnitudes_above(moon), {}, apparent_place(*view.observer, moon.sky)};
  if (!moon_is_up(view, moon.sky)) return over;
  const auto seen = view_of(view, moon.sky);
  moon.observer = seen.observer;
  moon.sightline = seen.sightline;
  over.lux = illuminance_seen(moon);
  return over;
}

/// View of the whole sky, whether or not the Moon is up.
View view_around(const ViewRequest& request, const atmosphere::ObserverAir& air) {
  View view;
  view.observer = request.observer;
  view.stars = request.stars;
  if (request.reddening) view.sightline = {air, {}};
  return view;
}

/// Spreads a point's light over the four nearest texels, weighted by distance. Rows below the horizon get no light.
void add_point(texture::Image& image, const Directions& all,
               const povray_scenes::HorizonPlace& place, const Rgb& lux) {
  const auto [x, y] = all.place(place.altitude, place.azimuth);
  const double left = std::floor(x - 0.5), above = std::floor(y - 0.5);
  for (const int down : {0, 1})
    for (const int right : {0, 1}) {
      const double share = (right ? x - 0.5 - left : 1 - (x - 0.5 - left)) *
                           (down ? y - 0.5 - above : 1 - (y - 0.5 - above));
      const auto row =
          static_cast<std::size_t>(std::clamp(above + down, 0., double(all.rows_above() - 1)));
      const auto column = all.around(static_cast<std::ptrdiff_t>(left) + right);
      add(image, row, column, lux, share / all.solid_angle(row));
    }
}

void add_stars(texture::Image& image, const Directions& all, const View& view,
               const almanac::SkyState& sky) {
  for (const auto& star : lights_over(view, sky))
    if (algebra::in_radians(star.place.altitude) >= 0)
      add_point(image, all, star.place, star.illuminance_lux);
}

/// Adds the Moon's disc in the form of many points of equal brightness, leaving out points below the horizon.
void add_moon(texture::Image& image, const Directions& all, const MoonOver& moon,
              algebra::Angle radius) {
  constexpr int points = 1 << 16;
  constexpr double golden_angle = pi * (3 - 2.23606797749979);
  const auto middle = in_sky(moon.place.altitude, moon.place.azimuth);
  const glm::dvec3 aside = std::abs(middle.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
  const glm::dvec3 right = glm::normalize(glm::cross(middle, aside)),
                   up = glm::cross(right, middle);
  for (int k = 0; k < points; ++k) {
    const double out = std::tan(algebra::in_radians(radius)) * std::sqrt((k + 0.5) / points),
                 turn = k * golden_angle;
    const auto to = glm::normalize(middle + out * (std::cos(turn) * right + std::sin(turn) * up));
    if (to.z < 0) continue;
    const auto [x, y] =
        all.place(algebra::radians(std::asin(to.z)), algebra::radians(std::atan2(to.x, to.y)));
    const auto row = std::min(static_cast<std::size_t>(y), all.rows_above() - 1);
    add(image, row, all.around(static_cast<std::ptrdiff_t>(std::floor(x))), moon.lux,
        1 / (points * all.solid_angle(row)));
  }
}

/// Illuminance on level ground from everything above the horizon.
Rgb on_level_ground(const texture::Image& image, const Directions& all) {
  Rgb lux{};
  for (std::size_t row = 0; row < all.rows_above(); ++row) {
    Rgb sum{};
    for (std::size_t column = 0; column < all.columns(); ++column)
      for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += image(row, column, k);
    for (std::size_t k = 0; k < sum.size(); ++k)
      lux[k] += sum[k] * all.solid_angle(row) * std::sin(all.altitude(row));
  }
  return lux;
}

texture::Attributes header(const DomeRequest& request, const LitMoon& moon, const ViewRequest& view,
                           const DomeFigures& figures) {
  auto attributes = scene_linear_header(space_of(request.content), moon.sky.when);
  const auto& place = *view.observer;
  attributes["latitude"] = static_cast<float>(algebra::in_degrees(place.latitude));
  attributes["longitude"] = static_cast<float>(algebra::in_degrees(place.longitude));
  attributes["altitude"] = static_cast<float>(algebra::in_metres(place.elevation));
  attributes["coppermoon:projection"] = std::string(
      "latitude-longitude: zenith on top, north in the middle column, east to the right of it");
  attributes["coppermoon:moon"] = std::string(request.moon ? "on" : "off");
  for (const auto& [name, values] : result::columns_of(std::array{figures}))
    attributes["coppermoon:" + name] = static_cast<float>(values.front());
  auto asked = request;
  auto seen = view;
  asked.content.space = space_of(request.content);
  attributes["coppermoon:recipe"] = recipe_of_light(moon, false, [&](request::Parameters& all) {
    describe_observer(all, seen);
    describe_stars(all, seen);
    describe(all, asked);
  });
  return attributes;
}

}  // namespace

void describe(request::Parameters& is, DomeRequest& dome) {
  is.begin("The dome", "", request::Affects::frame);
  is.add(request::parameter(
             "width", dome.width,
             "width of the dome [texels], a multiple of 4, 16 to 16384; its height is half of it"))
      .within(16, 16384);
  is.add(request::on_off("moon", dome.moon,
                         "the Moon itself, as an even disc; off for scenes with a Moon of their "
                         "own, which would shine twice"));
  is.add(request::parameter("ground-albedo", dome.ground_albedo,
                            "albedo of the ground below the horizon, 0 to 1; 0: black"))
      .within(0, 1);
  describe_numbers(is, dome.content);
}

void require_sound(const DomeRequest& dome) {
  algebra::require_within("width of the dome [texels]", static_cast<double>(dome.width), 16, 16384);
  if (dome.width % 4 != 0)
    throw algebra::Error(
        fmt::format("width of the dome [texels] = {}, allowed multiples of 4", dome.width));
  algebra::require_within("albedo of the ground", dome.ground_albedo, 0, 1);
}

Dome dome_over(const DomeRequest& request, const LitMoon& moon, const ViewRequest& view) {
  require_sound(request);
  if (!view.observer) throw algebra::Error("dome: seen from no place, allowed from a place");
  const auto& observer = *view.observer;
  const auto air = air_over(observer, view);
  const auto over = moon_over(moon, view);
  const ClearSky sky(observer, moon.sky, air, over.magnitudes);
  const Directions all(request.width);
  Dome dome{{all.columns(), all.rows(), {"R", "G", "B"}}, {}, {}};
  tbb::parallel_for(std::size_t{0}, all.rows_above(), [&](std::size_t row) {
    for (std::size_t column = 0; column < all.columns(); ++column)
      add(dome.light, row, column, sky.light(all.direction(row, column)), 1);
  });
  add_stars(dome.light, all, view_around(view, air), moon.sky);
  const auto of_sky = on_level_ground(dome.light, all);
  const auto seen = almanac::view_from(observer, moon.sky);
  if (request.moon)
    add_moon(dome.light, all, over,
             algebra::radians(std::asin(almanac::lunar_radius / seen.moon_distance)));
  const double steep = std::max(0., std::sin(algebra::in_radians(over.place.altitude)));
  for (std::size_t row = all.rows_above(); row < all.rows(); ++row)
    for (std::size_t column = 0; column < all.columns(); ++column)
      for (std::size_t k = 0; k < of_sky.size(); ++k)
        dome.light(row, column, k) =
            static_cast<float>(request.ground_albedo / pi * (of_sky[k] + steep * over.lux[k]));
  dome.figures = {sky.zenith_cd_m2(),
                  colour::luminance(picture_space, of_sky),
                  colour::luminance(picture_space, over.lux),
                  over.place,
                  sky.sun_altitude(),
                  sky.extinction_mag()};
  dome.attributes = header(request, moon, view, dome.figures);
  const auto space = space_of(request.content);
  if (space != picture_space) dome.light = in_space(dome.light, picture_space, space);
  return dome;
}

void write_sky(const std::filesystem::path& file, const LitMoon& moon, ViewRequest view,
               const DomeRequest& request) {
  const std::size_t width = request.width;
  view.stars.shown = false;
  auto dome = dome_over(request, moon, view);
  const auto row = [&](std::size_t r) {
    return dome.light.values.begin() + static_cast<std::ptrdiff_t>(3 * width * r);
  };
  std::copy_n(row(width / 4 - 1), 3 * width, row(width / 4));
  texture::write_exr(file, dome.light, dome.attributes);
}

}  // namespace coppermoon::uses
