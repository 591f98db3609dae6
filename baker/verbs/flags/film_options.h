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

/// What the flags say about a film, apart from its Moon, its view and its pictures.
struct FilmOptions {
  std::string eclipse = {}, from = "P1", to = "P4";
  almanac::Calendar calendar = almanac::Calendar::gregorian;
  std::string zone = {};  ///< time zone for times of day without an offset; empty: UTC
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
  uses::FilmFiles files = {};
};

/// Adds the flags for the times of the frames, what to make of which frames, the mount, and the whole film's files.
void add_film_options(Verb& verb, FilmOptions& options);

/// The eclipse on the day that the options name (uses::eclipse_of_day). If there is none on that day, takes the nearest
/// within 15 days and says so on stderr. If no day is named, takes the eclipse nearest to the first moment with a date.
///
/// Throws  Error  if there is no such eclipse, or neither a day nor a date is given
eclipse::Eclipse eclipse_of(const FilmOptions& options,
                            const std::optional<almanac::Observer>& observer = {});

/// Times of the film. "moonrise" and "moonset" stand for the begin and end of the time in which the observer's Moon is
/// up (uses::while_up), between P1 and P4 or the other moment given.
///
/// Throws  Error  as eclipse_of; if a moment cannot be read; for "moonrise" or "moonset" without an observer, or if the
///                Moon is never up
uses::FilmTimes times_of(const FilmOptions& options, const uses::ViewRequest& view = {});

/// Lets a film begin at moonrise if the observer's Moon rises after its begin, and end at moonset if it sets before its
/// end, unless the user gave that begin or end. Changes the times and the recipe's parameters, and says so on stderr.
///
/// Throws  Error  if the Moon is below the horizon all the time
void keep_to_the_moon(uses::FilmTimes& times, request::Parameters& parameters,
                      const uses::ViewRequest& view);

/// Products that --make lists ("light", "textures", "scenes" with their textures, "frames", "pictures"), with high
/// dynamic range for pictures if asked for, and those that the files of the whole film need.
///
/// Throws  Error  if one is unknown; if high dynamic range is asked for without pictures
uses::Products products_of(const FilmOptions& options);

/// Exposure times [s] at moments, from a list such as "P1:0.001,U2:4"; empty if the text is not such a list.
///
/// Throws  Error  if a moment or a time cannot be read, or the moments are not in order
std::vector<std::pair<almanac::Instant, double>> time_keys_from(
    const std::string& text, const eclipse::Eclipse& eclipse,
    const uses::MomentContext& context = {});

/// How the camera is held.
///
/// Given   observed  whether there is an observer
/// Throws  Error     for a fixed mount without an observer, or an aim that cannot be read or has no fixed mount
uses::Mounting mounting_of(const FilmOptions& options, bool observed);

/// Throws  Error  for the whole film's files as require_sound; if a shard asks for one of them
void require_whole_film(const FilmOptions& options);

/// Products as --make spells them.
std::string make_text(const uses::Products& products);

}  // namespace coppermoon::verbs
