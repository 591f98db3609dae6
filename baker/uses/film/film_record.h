// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "plan/plan.h"
#include "request/recipe.h"
#include "texture/image.h"

namespace coppermoon::uses {

/// The request that a film is made from, as its files' headers keep it; it tells the film's own files from others.
/// Functions may be called from any thread.
struct FilmRecord {
  request::Recipe
      recipe{};  ///< as asked for, with the textures' width; if empty, no file is this film's
  std::string map_contents{}, view_contents{};  ///< fingerprints of the files that the recipe names
  std::optional<plan::Work> work{};             ///< for the light, once it is planned
  /// How the error that refuses another film's files ends, after "allowed another folder".
  std::string way_out{};

  /// Attributes in the header of each file of a frame, besides its number.
  texture::Attributes frame_header() const;
  /// Attributes in the header of each file that is made from many frames.
  texture::Attributes film_header() const;

  /// Recipe with all that the light depends on except time, before it is planned.
  request::Recipe light_key() const;
  /// Text that tells this film from others, whichever products are made from it.
  std::string film_key() const;

  /// Whether a file was made from this film's request, in all settings that such a file depends on.
  bool made_alike(const std::filesystem::path& file) const;
  /// Whether a linear frame's pixels were made from this film's request; its exposure may differ.
  bool shows_the_same(const std::filesystem::path& frame) const;
  /// Contents of a file that is not this film's, in words; empty if it is, or if it is damaged. Work is compared by the
  /// settings that it is planned from.
  std::string foreign_contents(const std::filesystem::path& file) const;
};

/// The recipe in the text of a light_key, with or without settings before it.
request::Recipe light_key_in(const std::string& text);

/// Differences in words, for whoever asked for the second recipe: "iso = 800, asked 100; …"; empty if there are none.
std::string in_words(std::vector<request::Difference> differences);

}  // namespace coppermoon::uses
