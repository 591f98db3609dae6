// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "uses/film/film_files.h"
#include "uses/film/film_setup.h"
#include "uses/film/film_times.h"
#include "uses/picture/moment_text.h"
#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// What flags say of a film, but for its Moon, its view and its pictures.
struct FilmOptions {
  std::string eclipse = {}, from = "P1", to = "P4";
  almanac::Calendar calendar = almanac::Calendar::gregorian;
  std::string zone = {};  ///< of times of day without an offset; empty: UTC
  std::optional<std::size_t> frames = {};
  uses::FrameRate fps = {};
  std::optional<double> time_scale = {}, duration_s = {};
  std::optional<std::size_t> start_frame = {};
  std::string moments = {};
  std::string make = "pictures", range = {}, shard = "1/1";
  uses::Mount mount = uses::Mount::tracking;
  std::string aim = {}, scene = {};
  std::optional<double> bracket_ev = {};
  bool hdr = false;
  std::string contact_sheet = {}, movie = {}, composite = {}, stage = {};
  std::vector<std::string> curves = {};
};

/// When its frames are, what is made of them, which of them, the mount; files of the whole film.
void add_film_options(Verb& verb, FilmOptions& options);

/// The eclipse of the day that is named (uses::eclipse_of_day); without one on that day the nearest within 15 days, which is
/// said on stderr; where none is named, the eclipse nearest to the first moment that has a date.
///
/// Throws  Error  when there is none, or no day is named
eclipse::Eclipse eclipse_of(const FilmOptions& options,
                            const std::optional<almanac::Observer>& observer = {});

/// Times of the eclipse that is meant. "moonrise" and "moonset" alone begin and end the part from P1 to P4, or to the other
/// moment, in which the observer's Moon is up (uses::while_up).
///
/// Throws  Error  as eclipse_of; when a moment is none; for those two without an observer, or where the Moon is never up
uses::FilmTimes times_of(const FilmOptions& options, const uses::ViewRequest& view = {});

/// Lets a film begin at moonrise and end at moonset where nobody asks for another begin or end and the observer's Moon rises
/// later or sets before: changes the times, and the parameters for the recipe; says so on stderr.
///
/// Throws  Error  where the Moon is below the horizon all the time
void keep_to_the_moon(uses::FilmTimes& times, request::Parameters& parameters,
                      const uses::ViewRequest& view);

/// "light" alone, or "textures", "scenes" (with their textures), "frames", "pictures", with commas
/// between; pictures of high dynamic range too; and what files of the whole film are made of.
///
/// Throws  Error  when one of them is none; when there are pictures of high dynamic range alone
uses::Products products_of(const FilmOptions& options);

/// Exposure times [s] at moments, as "P1:0.001,U2:4": none where the text is no such list.
///
/// Throws  Error  when a moment or a time is none, or the moments are not in order
std::vector<std::pair<almanac::Instant, double>> time_keys_from(
    const std::string& text, const eclipse::Eclipse& eclipse,
    const uses::MomentContext& context = {});

/// How the camera is held.
///
/// Given   observed  there is an observer
/// Throws  Error     for a fixed mount without one, an aim without a fixed mount or that is none
uses::Mounting mounting_of(const FilmOptions& options, bool observed);

/// Files of the whole film.
///
/// Throws  Error  as require_sound of them; for those of a shard
uses::FilmFiles files_of(const FilmOptions& options);

/// Products as --make has them.
std::string make_text(const uses::Products& products);

}  // namespace coppermoon::verbs
