// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "verbs/film.h"
#include "verbs/film_progress.h"
#include "verbs/flags.h"
#include "verbs/frame_range.h"

namespace coppermoon::verbs {

/// Files that are made of a whole film, once its frames are there; empty: not.
struct FilmFiles {
  std::string contact_sheet, movie, composite;
  std::vector<std::string> curves;

  bool any() const;
};

void add_film_files(CLI::App& verb, FilmFiles& files);

/// What may be refused before any frame is made.
///
/// Throws  Error  for a shard, which has not all frames; when the film's products lack what a file
///                is made of; for an ending or a place that a file cannot have; without a font or
///                ffmpeg
void require_makeable(const FilmFiles& files, const Film& film, const Shard& shard);

/// Makes them, each whole or not at all, in the frames' order of time.
void write_film_files(const FilmFiles& files, const Film& film, std::vector<std::size_t> frames,
                      FilmProgress& progress);

}  // namespace coppermoon::verbs
