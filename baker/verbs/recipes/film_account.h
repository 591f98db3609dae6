// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "plan/plan.h"
#include "uses/film/film.h"

namespace coppermoon::verbs {

/// What a film is made from.
struct FilmAccount {
  std::string recipe;                       ///< as asked for, with the textures' width
  std::string map_contents, view_contents;  ///< fingerprints of what stands in files
  std::optional<plan::Work> work = {};      ///< planned for its light; without: not yet
};

/// The same as the headers of its files keep it, and what tells from a header whether a file was made
/// from it. Before its work is planned no frame is known to be.
uses::FilmRecord record_of(const FilmAccount& account);

}  // namespace coppermoon::verbs
