// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <vector>

#include "uses/film/film.h"
#include "uses/light/shard.h"

namespace coppermoon::uses {

/// Files to make from a whole film once its frames exist. A file whose path is empty is not made.
struct FilmFiles {
  std::filesystem::path contact_sheet = {}, movie = {}, composite = {}, stage = {};
  std::vector<std::filesystem::path> curves = {};

  /// The requested files, in the order in which they are made.
  std::vector<std::filesystem::path> all() const;
};

/// Refuses requested files that cannot be made from any film.
///
/// Throws  Error  for a shard of a film, because the files need all frames; for a file name with a wrong ending
void require_sound(const FilmFiles& files, const Shard& shard);

/// Refuses files that cannot be made from this film, before any frame is made.
///
/// Throws  Error  when no file can be written at a path; when the film's products do not include the pictures or
///                frames that a file is made from; when a font or ffmpeg is needed but missing; as require_stage
void require_makeable(const FilmFiles& files, const Film& film);

/// Makes the requested files from the given frames. Each file appears complete or not at all.
///
/// Given   made   called with the path of each file once the file exists; may be empty
/// Throws  Error  as write_contact_sheet, write_movie, write_stage, write_plot; when a frame of the composite cannot be
///                read, differs in size from the first, or has no exposure in its header
void write_film_files(const FilmFiles& files, const Film& film, std::vector<std::size_t> frames,
                      const std::function<void(const std::filesystem::path&)>& made = {});

}  // namespace coppermoon::uses
