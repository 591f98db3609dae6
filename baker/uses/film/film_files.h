// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <vector>

#include "uses/film/film.h"
#include "uses/light/shard.h"

namespace coppermoon::uses {

/// Files to make from a whole film, once its frames exist; an empty path asks for none.
struct FilmFiles {
  std::filesystem::path contact_sheet = {}, movie = {}, composite = {}, stage = {};
  std::vector<std::filesystem::path> curves = {};

  /// The files asked for, in the order in which they are made.
  std::vector<std::filesystem::path> all() const;
};

/// Refuses files that could not be made from any film.
///
/// Throws  Error  for a shard, which lacks frames; for a file name with a wrong ending
void require_sound(const FilmFiles& files, const Shard& shard);

/// Refuses files that cannot be made from this film, before any frame is made.
///
/// Throws  Error  for a path where no file can be written; for products that lack the pictures or frames that a
///                file is made from; if the font or ffmpeg that it needs is missing
void require_makeable(const FilmFiles& files, const Film& film);

/// Makes the files, each whole or not at all, from frames in order of time.
///
/// Given   made   called with each file once it exists; may be empty
/// Throws  Error  as write_contact_sheet, write_movie, write_stage, write_plot; for a frame of the composite that
///                cannot be read, differs in size from the first, or has no exposure in its header
void write_film_files(const FilmFiles& files, const Film& film, std::vector<std::size_t> frames,
                      const std::function<void(const std::filesystem::path&)>& made = {});

}  // namespace coppermoon::uses
