// SPDX-License-Identifier: MIT
#include "uses/film/film_setup.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "algebra/error.h"
#include "algebra/quantity.h"
#include "almanac/calendar.h"
#include "files/temporary_folder.h"
#include "files/whole_file.h"
#include "uses/film/film_scene.h"
#include "uses/light/spectral_bands.h"
#include "uses/picture/clear_sky.h"
#include "uses/picture/lit_scene.h"

namespace coppermoon::uses {
namespace {

/// Refuses textures that POV-Ray cannot read: those with passes, with spectra, or in a colour space other than linear
/// Rec.709. Frames are converted to the film's colour space after rendering.
void require_content(const Film& film) {
  require_sound(film.content);
  if (!film.scene.empty()) require_scene(film);
  if (film.products.mipmapped &&
      (film.products.framed() || film.content.passes || film.content.spectral_nm))
    throw algebra::Error(
        "tx are textures without parts and frames, allowed in a film of their own");
  if (!film.products.framed()) return;
  const auto& products = film.products;
  if (const auto space = space_of(film.content);
      space != picture_space && (products.scenes || products.textures))
    throw algebra::Error(fmt::format("space = {}, allowed lin_rec709 with {}", colour::name(space),
                                     products.scenes ? "scenes" : "textures beside frames"));
  if (film.content.spectral_nm) throw algebra::Error("spectra need a film of textures alone");
  if (film.content.passes && (!products.frames || products.textures || products.scenes))
    throw algebra::Error("passes need a film of textures alone, or of frames");
}

void require_exposure(const Film& film) {
  require_sound(film.development, film.picture(film.moments.first_frame));
  if (film.products.high_range)
    require_sound(of_high_range(film.development),
                  film.high_range_picture(film.moments.first_frame));
  if (film.products.rendered()) files::require_temporary_folder();
  if (!film.bracket_ev) return;
  algebra::require_within("bracket [EV]", *film.bracket_ev, 0.01, 10);
  const auto require_times = [&](double seconds) {
    for (const double stops : {-*film.bracket_ev, *film.bracket_ev})
      algebra::require_within("exposure time of the bracket [s]", seconds * std::exp2(stops), 1e-6,
                              1e6);
  };
  if (film.development.time.rule == ExposureTime::Rule::fixed)
    require_times(film.development.time.seconds);
  for (const auto& [when, seconds] : film.time_keys) require_times(seconds);
}

void require_folder(const Film& film) {
  if (std::filesystem::is_directory(film.folder)) return;
  if (std::filesystem::exists(film.folder))
    throw algebra::Error(fmt::format("{}: is no directory", film.folder.string()));
  files::require_place_for(film.folder);
}

void mount(Film& film, const Mounting& mounting) {
  if (mounting.aim && mounting.mount != Mount::fixed)
    throw algebra::Error("an aim needs a fixed mount");
  if (mounting.mount == Mount::horizon) film.view.up = povray_scenes::Up::zenith;
  if (mounting.mount != Mount::fixed) return;
  if (!film.view.observer) throw algebra::Error("a fixed mount needs an observer");
  const auto half_way = film.moments.first_frame + (film.moments.frames.size() - 1) / 2;
  film.view.aim =
      mounting.aim ? *mounting.aim : apparent_place(*film.view.observer, film.sky(half_way));
}

/// Refuses a film in which the Moon is below the horizon in any of a few hundred evenly spaced frames. A film with a
/// user's scene is accepted, because a landscape needs no Moon.
void require_up(const Film& film, const std::vector<std::size_t>& frames) {
  if (!film.scene.empty() || !film.view.observer || film.products.light_alone() || frames.empty())
    return;
  const std::size_t step = std::max<std::size_t>(1, frames.size() / 240);
  std::vector<std::size_t> up, down;
  const auto look = [&](std::size_t frame) {
    (moon_is_up(film.view, film.sky(frame)) ? up : down).push_back(frame);
  };
  for (std::size_t i = 0; i + 1 < frames.size(); i += step) look(frames[i]);
  look(frames.back());
  if (down.empty()) return;
  const auto place = place_text(*film.view.observer);
  if (up.empty())
    throw algebra::Error(fmt::format("the Moon is below the horizon of {} in all frames", place));
  const auto [first, last] = std::ranges::minmax(up);
  throw algebra::Error(fmt::format(
      "the Moon is below the horizon of {} in frame {}; it is up from frame {} ({}) to {}", place,
      std::ranges::min(down), first,
      almanac::utc_text(film.moments.at(first), film.moments.eclipse.calendar), last));
}

/// Width of all textures [texels]: the largest that the first, middle or last frame needs.
std::size_t widest_texture(const Film& film) {
  if (film.moon.texture_width || !film.products.framed()) return texture_width_of(film.moon);
  std::size_t widest = 0;
  const auto first = film.moments.first_frame, last = film.moments.last_frame();
  for (const std::size_t frame : {first, first + (last - first) / 2, last})
    widest =
        std::max(widest, *fitted(film.moon, view_of(film, film.sky(frame)).camera).texture_width);
  return widest;
}

constexpr double degree = std::numbers::pi / 180;

povray_scenes::HorizonPlace place_of(double altitude, double azimuth) {
  return {algebra::radians(altitude), algebra::radians(azimuth)};
}

/// Directions in which the Moon is seen at several moments (see in_sky), and the shape of the picture.
struct Moons {
  std::vector<glm::dvec3> directions;
  double sine_of_radius;  ///< sine of the largest disc's angular radius
  double width_over_height;
};

/// Half the horizontal field of view [rad] that holds one whole Moon; π / 2 if no field does.
///
/// Each plane through the camera and an edge of the picture must be at least the Moon's radius from the Moon's centre.
double half_field_for(const Moons& moons, const glm::dvec3& moon,
                      const povray_scenes::HorizonPlace& aim) {
  const auto ahead = in_sky(aim.altitude, aim.azimuth);
  const auto across = glm::normalize(glm::cross(glm::dvec3(0, 0, 1), ahead));
  const auto half = [&](const glm::dvec3& side) {
    const double a = glm::dot(moon, ahead), b = std::abs(glm::dot(moon, side));
    return std::min(
        std::numbers::pi / 2,
        std::atan2(b, a) + std::asin(std::min(1., moons.sine_of_radius / std::hypot(a, b))));
  };
  const double upright = half(glm::cross(ahead, across));
  if (upright >= std::numbers::pi / 2) return upright;
  return std::max(half(across), std::atan(std::tan(upright) * moons.width_over_height));
}

/// Half the horizontal field of view [rad] that holds all Moons.
double half_field_for(const Moons& moons, const povray_scenes::HorizonPlace& aim) {
  double most = 0;
  for (const auto& moon : moons.directions) most = std::max(most, half_field_for(moons, moon, aim));
  return most;
}

/// The aim that needs the narrowest field of view, to 0.1 degrees. The search begins at the middle of all Moons, and
/// takes smaller and smaller steps.
povray_scenes::HorizonPlace best_aim(const Moons& moons) {
  constexpr double tenth = 0.1 * degree, highest = 89 * degree;
  glm::dvec3 sum(0);
  for (const auto& moon : moons.directions) sum += moon;
  const auto stepped = [](double angle) { return std::round(angle / tenth) * tenth; };
  double altitude = stepped(std::atan2(sum.z, std::hypot(sum.x, sum.y))),
         azimuth = stepped(std::atan2(sum.x, sum.y));
  altitude = std::min(altitude, highest);
  double narrowest = half_field_for(moons, place_of(altitude, azimuth));
  for (double step = 12.8 * degree; step > tenth / 2;) {
    const double from_altitude = altitude, from_azimuth = azimuth, before = narrowest;
    for (const int up : {-1, 0, 1})
      for (const int right : {-1, 0, 1}) {
        const double h = std::clamp(from_altitude + up * step, -highest, highest),
                     a = from_azimuth + right * step;
        const double half = half_field_for(moons, place_of(h, a));
        if (half < narrowest) altitude = h, azimuth = a, narrowest = half;
      }
    if (narrowest == before) step /= 2;
  }
  const double turn = 2 * std::numbers::pi;
  return place_of(altitude, azimuth - turn * std::floor(azimuth / turn));
}

}  // namespace

void set_up(Film& film, const Mounting& mounting, const std::vector<std::size_t>& frames) {
  require_content(film);
  film.view = seen_through(film.development.camera, film.view);
  film.development.focal_length_mm = film.view.focal_length_mm;
  require_exposure(film);
  if (film.scene.empty()) mount(film, mounting);
  require_folder(film);
  require_up(film, frames);
  film.moon.texture_width = widest_texture(film);
  require_map(film.moon);
}

FixedView fixed_view(const Film& film) {
  const auto& observer = *film.view.observer;
  const auto& frames = film.moments;
  const std::size_t step = std::max<std::size_t>(1, frames.frames.size() / 240);
  Moons moons{{}, 0, static_cast<double>(film.view.width) / static_cast<double>(film.view.height)};
  double half_field = 0;
  for (auto frame = frames.first_frame; frame <= frames.last_frame(); frame += step) {
    const auto sky = film.sky(frame);
    if (!moon_is_up(film.view, sky)) continue;
    if (half_field == 0)
      half_field = algebra::in_radians(view_of(film, sky).camera.horizontal_field) / 2;
    const auto place = apparent_place(observer, sky);
    moons.directions.push_back(in_sky(place.altitude, place.azimuth));
    const auto seen = almanac::view_from(observer, sky);
    moons.sine_of_radius =
        std::max(moons.sine_of_radius, almanac::lunar_radius / seen.moon_distance);
  }
  FixedView view{.looked_at = moons.directions.size()};
  view.outside =
      static_cast<std::size_t>(std::ranges::count_if(moons.directions, [&](const glm::dvec3& moon) {
        return half_field_for(moons, moon, *film.view.aim) > half_field;
      }));
  if (view.outside == 0) return view;
  constexpr double widest_deg = 179;
  const auto aim = best_aim(moons);
  const double half = half_field_for(moons, aim), field_deg = half <= half_field
                                                                  ? 2 * half_field / degree
                                                                  : std::ceil(2 * half / degree);
  if (field_deg > widest_deg) return view;
  view.aim = aim;
  view.field_deg = field_deg;
  return view;
}

}  // namespace coppermoon::uses
