// SPDX-License-Identifier: MIT
#include "uses/film/film_setup.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "algebra/error.h"
#include "almanac/calendar.h"
#include "files/temporary_folder.h"
#include "files/whole_file.h"
#include "uses/film/film_scene.h"
#include "uses/light/spectral_bands.h"
#include "uses/picture/lit_scene.h"

namespace coppermoon::uses {
namespace {

/// Refuses textures that POV-Ray cannot read: other spaces, passes and spectra. Frames get their space and passes after
/// rendering.
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

/// Refuses a Moon below the horizon in any of a few hundred frames, spread evenly; a landscape needs none.
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

/// Width of all textures [texels], for the nearest Moon of the first, middle and last frame.
std::size_t widest_texture(const Film& film) {
  if (film.moon.texture_width || !film.products.framed()) return texture_width_of(film.moon);
  std::size_t widest = 0;
  const auto first = film.moments.first_frame, last = film.moments.last_frame();
  for (const std::size_t frame : {first, first + (last - first) / 2, last})
    widest =
        std::max(widest, *fitted(film.moon, view_of(film, film.sky(frame)).camera).texture_width);
  return widest;
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

}  // namespace coppermoon::uses
