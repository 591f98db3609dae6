// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>

#include "files/lock.h"
#include "uses/film/film.h"

namespace coppermoon::uses {

/// Claim on the film's folder, which is there, for this object's lifetime; processes that make the same film share it.
///
/// Throws  Error  while another film is made in the folder
class FilmClaim {
 public:
  explicit FilmClaim(const Film& film);

 private:
  files::FolderClaim claim_;
};

/// Refuses a folder in which files of another film, of no film, links or a changed scene have names of this film's
/// files.
///
/// Given   replace  accepts files of another film: removes links, and files that this film has no frame for
/// Throws  Error    names the first such file, and the film that it is of
void require_own(const Film& film, bool replace);

/// Whether a file is of this film and that frame, and whole.
bool is_own(const Film& film, const std::filesystem::path& file, std::size_t frame);

/// Whether all files of a frame are there, whole and of this film.
bool is_made(const Film& film, std::size_t frame);

/// Whether a linear frame is whole and has this film's pixels; its exposure may be another.
bool shows_scene(const Film& film, std::size_t frame);

}  // namespace coppermoon::uses
