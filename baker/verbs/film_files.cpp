// SPDX-License-Identifier: MIT
#include "verbs/film_files.h"

#include <fmt/format.h>

#include <algorithm>

#include "algebra/error.h"
#include "texture/contact_sheet.h"
#include "verbs/film_composite.h"
#include "verbs/film_curve.h"
#include "verbs/film_movie.h"
#include "verbs/film_sheet.h"

namespace coppermoon::verbs {
namespace {

namespace fs = std::filesystem;

void require_ending(const fs::path& file, const char* what, const char* ending) {
  if (file.extension() != ending)
    throw algebra::Error(fmt::format("{}: a {} ends in {}", file.string(), what, ending));
}

/// Names of frames are no others' in the film's folder.
void require_no_frame(const fs::path& file, Film film) {
  film.products = {.textures = true, .frames = true, .pictures = true};
  film.bracket_ev = 1;
  for (std::size_t frame = 1; frame <= film.moments.frames.size(); ++frame)
    for (const auto& own : film.files(frame))
      if (own.filename() == file.filename())
        throw algebra::Error(
            fmt::format("{}: is the name of a frame, allowed another", file.string()));
}

/// The film's own folder need not be there yet.
void require_place_for(const fs::path& file, const Film& film) {
  const auto folder = fs::weakly_canonical(fs::absolute(file)).parent_path();
  const auto own = fs::weakly_canonical(fs::absolute(film.folder) / "").parent_path();
  if (folder != own || fs::is_directory(film.folder)) verbs::require_place_for(file);
  if (folder == own) require_no_frame(file, film);
}

void require_product(bool made, const char* flag, const char* product) {
  if (!made)
    throw algebra::Error(
        fmt::format("{0} is made of {1}, allowed with {1} among --make", flag, product));
}

}  // namespace

bool FilmFiles::any() const {
  return !contact_sheet.empty() || !movie.empty() || !composite.empty() || !curves.empty();
}

void add_film_files(CLI::App& verb, FilmFiles& files) {
  const std::string group = "Of the whole film";
  add_flag(verb, "--contact-sheet", files.contact_sheet,
           "a .png of some 40 pictures and those at the contacts, with their times")
      .writes_file()
      .in(group);
  add_flag(verb, "--curve", files.curves,
           "V magnitude and mean luminance of the disc over time, above the air: a .csv, or a "
           ".svg or .png that gnuplot draws; may be given more than once")
      .writes_file()
      .kept_each_time()
      .in(group);
  add_flag(verb, "--movie", files.movie, "an .mp4 of the pictures, by ffmpeg")
      .writes_file()
      .in(group);
  add_flag(verb, "--composite", files.composite,
           "a .png of all frames on one picture, each with its own exposure")
      .writes_file()
      .in(group);
}

void require_makeable(const FilmFiles& files, const Film& film, const Shard& shard) {
  if (!files.any()) return;
  if (shard.parts != 1)
    throw algebra::Error(fmt::format(
        "shard = {}/{}, allowed 1/1 for what is made of the whole film: a shard has not all frames",
        shard.part, shard.parts));
  std::vector<fs::path> all(files.curves.begin(), files.curves.end());
  for (const auto& curve : all) require_curve_ending(curve);
  for (const auto* file : {&files.contact_sheet, &files.movie, &files.composite})
    if (!file->empty()) all.push_back(*file);
  for (const auto& file : all) require_place_for(file, film);
  if (!files.contact_sheet.empty()) {
    require_ending(files.contact_sheet, "contact sheet", ".png");
    require_product(film.products.pictures, "--contact-sheet", "pictures");
    texture::sheet_font();
  }
  if (!files.composite.empty()) {
    require_ending(files.composite, "composite", ".png");
    require_product(film.products.frames, "--composite", "frames");
  }
  if (!files.movie.empty()) {
    require_ending(files.movie, "movie", ".mp4");
    require_product(film.products.pictures, "--movie", "pictures");
    require_ffmpeg();
  }
}

void write_film_files(const FilmFiles& files, const Film& film, std::vector<std::size_t> frames,
                      FilmProgress& progress) {
  std::ranges::sort(frames);
  const auto make = [&](const fs::path& file, const auto& write) {
    if (file.empty()) return;
    write(file, film, frames);
    progress.file(file);
  };
  if (!files.curves.empty()) {
    const auto curve = light_curve(film, frames);
    for (const auto& file : files.curves) {
      write_curve(file, film.moments.eclipse, curve);
      progress.file(file);
    }
  }
  make(files.contact_sheet, write_contact_sheet);
  make(files.composite, write_composite);
  make(files.movie, write_movie);
}

}  // namespace coppermoon::verbs
