// SPDX-License-Identifier: MIT
#include "uses/film/make_film.h"

#include <tbb/parallel_for.h>

#include "texture/resize.h"
#include "uses/film/film_folder.h"

namespace coppermoon::uses {
namespace {

/// Frames that are not made yet; calls events.kept for the others.
std::vector<std::size_t> missing_of(const Film& film, const std::vector<std::size_t>& frames,
                                    const FilmEvents& events) {
  std::vector<char> there(frames.size());
  tbb::parallel_for(std::size_t{0}, frames.size(),
                    [&](std::size_t i) { there[i] = is_made(film, frames[i]); });
  std::vector<std::size_t> missing;
  for (std::size_t i = 0; i < frames.size(); ++i)
    if (!there[i])
      missing.push_back(frames[i]);
    else if (events.kept)
      events.kept(frames[i]);
  return missing;
}

}  // namespace

Film with_ground(Film film) {
  const auto albedo = normal_albedo(film.moon);
  film.albedo = std::make_shared<const algebra::Grid<float>>(
      texture::resized(albedo, texture_width_of(film.moon) / 2));
  film.ground = ground_of(film.moon, albedo);
  return film;
}

void make_film(const Film& film, const std::vector<std::size_t>& frames, const FilmEvents& events) {
  if (film.products.light_alone() || frames.empty()) return;
  if (film.products.scenes) write_film_scene(film);
  const auto missing = missing_of(film, frames, events);
  if (missing.empty()) return;
  make_frames(with_ground(film), missing, [&](const MadeFrame& frame) {
    if (events.made) events.made(frame);
  });
}

}  // namespace coppermoon::uses
