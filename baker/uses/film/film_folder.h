// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>

#include "files/lock.h"
#include "uses/film/film.h"

namespace coppermoon::uses {

/// Reserves the film's existing folder while this object exists. Processes making the same film can share the folder.
///
/// Throws  Error  while another film is being made in the folder
class FilmClaim {
 public:
  explicit FilmClaim(const Film& film);

 private:
  files::FolderClaim claim_;
};

/// Refuses a folder in which a file has the name of one of this film's files but belongs to another film or to none, is
/// a link, or is a scene that the user has changed.
///
/// Given   replace  whether to accept the folder and remove each such file that is a link or no frame of this film
/// Throws  Error    when there is such a file; names the first one and says what it contains
void require_own(const Film& film, bool replace);

/// Whether a file is undamaged and was made for this film and this frame.
bool is_own(const Film& film, const std::filesystem::path& file, std::size_t frame);

/// Whether all files of a frame exist, are undamaged, and were made for this film.
bool is_made(const Film& film, std::size_t frame);

/// Whether a linear frame exists, is undamaged, and has the pixels that this film needs. Its exposure may differ.
bool shows_scene(const Film& film, std::size_t frame);

}  // namespace coppermoon::uses
