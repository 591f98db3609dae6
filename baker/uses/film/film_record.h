// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "plan/plan.h"
#include "request/recipe.h"
#include "texture/image.h"

namespace coppermoon::uses {

/// Request that a film is made from, as its files' headers keep it; tells the film's own files from others.
/// Functions may be called from any thread.
struct FilmRecord {
  request::Recipe
      recipe{};  ///< as asked for, with the textures' width; empty: no file is of this film
  std::string map_contents{}, view_contents{};  ///< fingerprints of files that the recipe names
  std::optional<plan::Work> work{};             ///< of the light, once it is planned
  /// End of the refusal of another film's files, behind "allowed another folder"
  std::string way_out{};

  /// Attributes in the header of each file of a frame, beside its number.
  texture::Attributes frame_header() const;
  /// Attributes in the header of each file that is made of many frames.
  texture::Attributes film_header() const;

  /// Recipe of all that the light depends on but time, before it is planned.
  request::Recipe light_key() const;
  /// Text that tells this film from others, whichever products are made of it.
  std::string film_key() const;

  /// Whether a file was made from this film's request, as far as the file depends on it.
  bool made_alike(const std::filesystem::path& file) const;
  /// Whether a linear frame's pixels were made from this film's request; its exposure may differ.
  bool shows_the_same(const std::filesystem::path& frame) const;
  /// Contents of a file that is not of this film, in words; empty where it is of it, or damaged. Work counts by what
  /// it is planned from.
  std::string foreign_contents(const std::filesystem::path& file) const;
};

/// Recipe that the text of a light_key holds, with or without settings before it.
request::Recipe light_key_in(const std::string& text);

/// Differences in words, for whoever asked for the second: "iso = 800, asked 100; …". Empty: none.
std::string in_words(std::vector<request::Difference> differences);

}  // namespace coppermoon::uses
