// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>

#include "files/folder_lock.h"
#include "uses/film/film.h"

namespace coppermoon::uses {

/// Keeps the film's folder, which is there, to the film for as long as this lives: all who make some of
/// it share the folder.
///
/// Throws  Error  while another film is made in it
class FilmClaim {
 public:
  explicit FilmClaim(const Film& film);

 private:
  files::FolderClaim claim_;
};

/// A folder holds one film: files of another are not overwritten unless that is asked for, nor links, nor a
/// scene that was changed.
///
/// Given   replace  files of another film may be overwritten: those that this one has no frame for are
///                  removed, and links
/// Throws  Error    where files of another film, or of nobody's, have the names of this one's: says
///                  what they hold, in the record's words
void require_own(const Film& film, bool replace);

/// Whether a file is this film's, of that frame, and whole.
bool is_own(const Film& film, const std::filesystem::path& file, std::size_t frame);

/// Whether a frame's files are all there and its own.
bool is_made(const Film& film, std::size_t frame);

/// Whether a linear frame has the very pixels that it would be made with, under any exposure.
bool shows_scene(const Film& film, std::size_t frame);

}  // namespace coppermoon::uses
