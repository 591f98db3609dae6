// SPDX-License-Identifier: MIT
#include "uses/film/film_files.h"

#include <fmt/format.h>

#include <algorithm>

#include "algebra/error.h"
#include "files/whole_file.h"
#include "texture/contact_sheet.h"
#include "uses/film/film_composite.h"
#include "uses/film/film_curve.h"
#include "uses/film/film_movie.h"
#include "uses/film/film_sheet.h"
#include "uses/film/film_stage.h"

namespace coppermoon::uses {
namespace {

namespace fs = std::filesystem;

/// Given  file  may be empty
void require_ending(const fs::path& file, const char* what, const char* ending) {
  if (!file.empty() && file.extension() != ending)
    throw algebra::Error(fmt::format("{}: a {} ends in {}", file.string(), what, ending));
}

/// Refuses a file in the film's folder that has the name of a frame's.
void require_no_frame(const fs::path& file, Film film) {
  film.products = {.textures = true, .frames = true, .pictures = true, .high_range = true};
  film.bracket_ev = 1;
  for (auto frame = film.moments.first_frame; frame <= film.moments.last_frame(); ++frame)
    for (const auto& own : film.files(frame))
      if (own.filename() == file.filename())
        throw algebra::Error(
            fmt::format("{}: is the name of a frame, allowed another", file.string()));
}

/// Refuses a path where no file can be; the film's own folder need not be there yet.
void require_place_for(const fs::path& file, const Film& film) {
  if (file.empty()) return;
  const auto folder = fs::weakly_canonical(fs::absolute(file)).parent_path();
  const auto own = fs::weakly_canonical(fs::absolute(film.folder) / "").parent_path();
  if (folder != own || fs::is_directory(film.folder)) files::require_place_for(file);
  if (folder == own) require_no_frame(file, film);
}

void require_product(bool made, const fs::path& file, const char* what, const char* product) {
  if (!file.empty() && !made)
    throw algebra::Error(fmt::format("{0}: a {1} is made of {2}, allowed where {2} are made",
                                     file.string(), what, product));
}

}  // namespace

std::vector<fs::path> FilmFiles::all() const {
  auto files = curves;
  for (const auto* file : {&contact_sheet, &composite, &movie, &stage})
    if (!file->empty()) files.push_back(*file);
  return files;
}

void require_sound(const FilmFiles& files, const Shard& shard) {
  if (files.all().empty()) return;
  if (shard.parts != 1)
    throw algebra::Error(fmt::format("shard = {}/{}, allowed 1/1 for what needs every frame",
                                     shard.part, shard.parts));
  for (const auto& curve : files.curves) require_curve_ending(curve);
  require_ending(files.contact_sheet, "contact sheet", ".png");
  require_ending(files.composite, "composite", ".png");
  require_movie_ending(files.movie);
  require_ending(files.stage, "stage", ".usda");
}

void require_makeable(const FilmFiles& files, const Film& film) {
  for (const auto& curve : files.curves) require_place_for(curve, film);
  for (const auto* file : {&files.contact_sheet, &files.movie, &files.composite, &files.stage})
    require_place_for(*file, film);
  require_product(film.products.pictures, files.contact_sheet, "contact sheet", "pictures");
  if (!files.contact_sheet.empty()) texture::sheet_font();
  require_product(film.products.frames, files.composite, "composite", "frames");
  require_product(film.products.pictures, files.movie, "movie", "pictures");
  if (!files.movie.empty()) require_ffmpeg();
  if (!files.stage.empty()) require_stage(files.stage, film);
}

void write_film_files(const FilmFiles& files, const Film& film, std::vector<std::size_t> frames,
                      const std::function<void(const fs::path&)>& made) {
  std::ranges::sort(frames);
  const auto tell = [&](const fs::path& file) {
    if (made) made(file);
  };
  const auto make = [&](const fs::path& file, const auto& write) {
    if (file.empty()) return;
    write(file, film, frames);
    tell(file);
  };
  if (!files.curves.empty()) {
    const auto curve = light_curve(film, frames);
    for (const auto& file : files.curves) {
      write_curve(file, film.moments.eclipse, curve);
      tell(file);
    }
  }
  make(files.contact_sheet, write_contact_sheet);
  make(files.composite, write_composite);
  make(files.movie, write_movie);
  make(files.stage, write_stage);
}

}  // namespace coppermoon::uses
