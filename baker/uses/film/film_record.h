// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "plan/plan.h"
#include "request/recipe.h"
#include "texture/image.h"

namespace coppermoon::uses {

/// The request that a film is made from, as recorded in the headers of its files. It distinguishes the film's files
/// from other files. Its functions may be called from any thread.
struct FilmRecord {
  request::Recipe
      recipe{};  ///< requested settings, plus the textures' width; if empty, none of the folder's files count
  std::string map_contents{}, view_contents{};  ///< fingerprints of the files that the recipe names
  std::optional<plan::Work> work{};             ///< work planned for computing the light, if known
  /// End of the error message that refuses another film's files. It follows the words "allowed another folder".
  std::string way_out{};

  /// Header attributes that the files of all frames have in common.
  texture::Attributes frame_header() const;
  /// Header attributes of the files that are made from many frames, such as a contact sheet.
  texture::Attributes film_header() const;

  /// The requested settings on which the light depends, except the time. Numbers chosen by the program are left out.
  request::Recipe light_key() const;
  /// Text that distinguishes this film from others, whatever products are made.
  std::string film_key() const;

  /// Whether a file was made with this film's settings. Settings that do not affect such a file are ignored.
  bool made_alike(const std::filesystem::path& file) const;
  /// Whether a linear frame's pixels were made with this film's settings. Its exposure may differ.
  bool shows_the_same(const std::filesystem::path& frame) const;
  /// Describes the contents of a file that does not belong to this film. The text is empty if the file belongs to the
  /// film or is damaged. Settings that the program can plan, or from which it plans (tolerance), are not compared.
  std::string foreign_contents(const std::filesystem::path& file) const;
};

/// Reads a light_key from its text, which may also hold the moments of the first and the last frame.
request::Recipe light_key_in(const std::string& text);

/// Describes how settings differ from the requested ones, such as "iso = 800, asked 100"; empty if they do not differ.
std::string in_words(std::vector<request::Difference> differences);

}  // namespace coppermoon::uses
