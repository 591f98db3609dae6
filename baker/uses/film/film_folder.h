// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>

#include "files/lock.h"
#include "uses/film/film.h"

namespace coppermoon::uses {

/// Claims the film's folder, which must exist, for this object's lifetime; processes that make the same film share it.
///
/// Throws  Error  while another film is being made in the folder
class FilmClaim {
 public:
  explicit FilmClaim(const Film& film);

 private:
  files::FolderClaim claim_;
};

/// Refuses a folder in which names of this film's files belong to another film, to links, to files from no film, or to
/// a scene that was changed.
///
/// Given   replace  accepts another film's files: removes links, and files for which this film has no frame
/// Throws  Error    names the first such file, and the film that it belongs to
void require_own(const Film& film, bool replace);

/// Whether a file is whole and belongs to this film and frame.
bool is_own(const Film& film, const std::filesystem::path& file, std::size_t frame);

/// Whether all files of a frame exist, whole and made for this film.
bool is_made(const Film& film, std::size_t frame);

/// Whether a linear frame is whole and has this film's pixels; its exposure may differ.
bool shows_scene(const Film& film, std::size_t frame);

}  // namespace coppermoon::uses
