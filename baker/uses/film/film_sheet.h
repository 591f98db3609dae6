// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "uses/film/film.h"

namespace coppermoon::uses {

/// A frame that a contact sheet shows.
struct SheetFrame {
  std::size_t frame;
  std::string moment;  ///< "U2", or from the nearest contact on: "U2+35min", "U4-20s"
  bool at_contact;     ///< none of the film's frames is nearer to it
};

/// The frames that a contact sheet shows: all of a short film; of a longer one some 40, evenly, and
/// besides them the nearest to each contact and to the greatest phase.
///
/// Given   frames  of the film, increasing
std::vector<SheetFrame> frames_of_sheet(const Moments& moments,
                                        const std::vector<std::size_t>& frames);

/// Draws the pictures of some frames, as frames_of_sheet chooses, each with its time and moment.
///
/// Throws  Error  as texture::drawn, texture::write_png
void write_contact_sheet(const std::filesystem::path& path, const Film& film,
                         const std::vector<std::size_t>& frames);

}  // namespace coppermoon::uses
