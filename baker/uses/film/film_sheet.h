// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "uses/film/film.h"

namespace coppermoon::uses {

struct SheetFrame {
  std::size_t frame;
  /// Time from the nearest contact, such as "U2+35min" or "U4-20s", but only "U2" within half a second of the contact.
  std::string moment;
  bool at_contact;  ///< whether the frame is the nearest to a contact, and within a minute of it
};

/// Chooses the frames for a contact sheet: all frames if there are at most 40, otherwise 40 at even steps and those
/// nearest to the contacts and to greatest eclipse.
///
/// Given   frames  the film's frames, in increasing order
std::vector<SheetFrame> frames_of_sheet(const Moments& moments,
                                        const std::vector<std::size_t>& frames);

/// Draws a contact sheet of the frames' pictures, with the time of day and the time from a contact for each.
///
/// Throws  Error  as texture::drawn, texture::write_png
void write_contact_sheet(const std::filesystem::path& path, const Film& film,
                         const std::vector<std::size_t>& frames);

}  // namespace coppermoon::uses
