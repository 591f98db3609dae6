// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>

#include "files/lock.h"
#include "uses/film/film.h"

namespace coppermoon::uses {

/// Claims the film's existing folder while this object lives. Processes that make the same film can share the folder.
///
/// Throws  Error  while another film is being made in the folder
class FilmClaim {
 public:
  explicit FilmClaim(const Film& film);

 private:
  files::FolderClaim claim_;
};

/// Refuses a folder in which a file named like this film's files belongs to another film or to none, is a link, or is a
/// scene that the user has changed.
///
/// Given   replace  whether to accept such a folder; links, and files for which this film has no frame, are removed
/// Throws  Error    when there is such a file; names the first one and says what it contains
void require_own(const Film& film, bool replace);

/// Whether a file is whole and was made for this film and this frame.
bool is_own(const Film& film, const std::filesystem::path& file, std::size_t frame);

/// Whether all files of a frame exist, are whole, and were made for this film.
bool is_made(const Film& film, std::size_t frame);

/// Whether a linear frame exists, is whole, and has the pixels that this film needs. Its exposure may differ.
bool shows_scene(const Film& film, std::size_t frame);

}  // namespace coppermoon::uses
