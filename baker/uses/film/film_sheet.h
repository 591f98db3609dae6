// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "uses/film/film.h"

namespace coppermoon::uses {

/// A frame on a contact sheet.
struct SheetFrame {
  std::size_t frame;
  /// Time from the nearest contact: "U2+35min", "U4-20s"; "U2" within half a second of it
  std::string moment;
  bool at_contact;  ///< the frame nearest to a contact, within a minute
};

/// Frames for a contact sheet: all of a short film; from a longer one 40 at even steps, and those nearest to the
/// contacts and the greatest phase.
///
/// Given   frames  of the film, in increasing order
std::vector<SheetFrame> frames_of_sheet(const Moments& moments,
                                        const std::vector<std::size_t>& frames);

/// Draws a contact sheet of the frames: their pictures with times and moments.
///
/// Throws  Error  as texture::drawn, texture::write_png
void write_contact_sheet(const std::filesystem::path& path, const Film& film,
                         const std::vector<std::size_t>& frames);

}  // namespace coppermoon::uses
