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

/// Values of the flags for a film, except for those that concern its Moon, its view and the developing of its pictures.
struct FilmOptions {
  std::string eclipse = {}, from = "P1", to = "P4";
  almanac::Calendar calendar = almanac::Calendar::gregorian;
  std::string zone = {};  ///< time zone for times without an offset; if empty, UTC
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

/// Adds the flags for the times of frames, the frames and products to make, the mount, and files of the whole film.
void add_film_options(Verb& verb, FilmOptions& options);

/// The eclipse that the options mean. If they name a day, it is the eclipse on that day (uses::eclipse_of_day) or else
/// the nearest within 15 days, which is then reported on stderr. If they name no day, it is the eclipse nearest to the
/// first of the given moments that has a date, also within 15 days.
///
/// Throws  Error  if there is no such eclipse, or neither a day nor a date is given
eclipse::Eclipse eclipse_of(const FilmOptions& options,
                            const std::optional<almanac::Observer>& observer = {});

/// Times of the film that the options describe. A film from "moonrise" begins when the Moon first is above the horizon
/// after P1; a film to "moonset" ends when the Moon last is above the horizon before P4 (uses::while_up).
///
/// Throws  Error  like eclipse_of; if a moment cannot be read; for "moonrise" or "moonset" without an observer, or if
///                the Moon is never up
uses::FilmTimes times_of(const FilmOptions& options, const uses::ViewRequest& view = {});

/// Shortens a film to the time when the Moon is above the observer's horizon. A beginning or end that the user gave is
/// kept. The times and the recipe's parameters are changed, and the change is reported on stderr.
///
/// Throws  Error  if the Moon is below the horizon during the whole film
void keep_to_the_moon(uses::FilmTimes& times, request::Parameters& parameters,
                      const uses::ViewRequest& view);

/// Products that the options request: those that --make lists, pictures of high dynamic range if --hdr is set, and
/// those from which the files of the whole film are made.
///
/// Throws  Error  if --make lists an unknown product; if high dynamic range is requested without pictures
uses::Products products_of(const FilmOptions& options);

/// Exposure times [s] at given moments, from a list such as "P1:0.001,U2:4". Empty if the text is not such a list.
///
/// Throws  Error  if a moment or a time cannot be read, or the moments are not in order
std::vector<std::pair<almanac::Instant, double>> time_keys_from(
    const std::string& text, const eclipse::Eclipse& eclipse,
    const uses::MomentContext& context = {});

/// How the camera is mounted, and where a fixed camera points.
///
/// Given   observed  whether there is an observer
/// Throws  Error     for a fixed mount without an observer, an aim without a fixed mount, or an aim that cannot be read
uses::Mounting mounting_of(const FilmOptions& options, bool observed);

/// Checks the options for files of the whole film.
///
/// Throws  Error  if files of the whole film are requested for a single shard; like require_sound
void require_whole_film(const FilmOptions& options);

/// Converts products to the text with which --make requests them.
std::string make_text(const uses::Products& products);

}  // namespace coppermoon::verbs
