// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "almanac/instant.h"
#include "eclipse/contacts.h"
#include "verbs/flags.h"

namespace coppermoon::verbs {

/// When a film's frames are.
struct FilmTimes {
  std::string eclipse = {}, from = "P1", to = "P4";
  std::optional<std::size_t> frames = {};  ///< without: 240, or as the time scale asks for
  double fps = 24;
  std::optional<double> time_scale = {};  ///< seconds of the eclipse in a second of the film
};

void add_film_times(CLI::App& verb, FilmTimes& options);

/// A film's frames: the moment of each, and the eclipse it is of.
struct Moments {
  std::vector<almanac::Instant> frames;
  eclipse::Eclipse eclipse;
};

/// A moment as "2018-07-27T18:24:00Z", or from a contact on: "U2", "P1-10min", "greatest+90s".
///
/// Throws  Error  when it is none such, or the eclipse has no such contact
almanac::Instant moment_from(const std::string& text, const eclipse::Eclipse& eclipse);

/// Throws  Error  when a moment is none, the last is before the first, or there are not 1 to 1e6
///                frames
Moments moments_of(const FilmTimes& options);

/// Contacts and the greatest phase, in order of time.
std::vector<std::pair<std::string, almanac::Instant>> contacts_of(const eclipse::Eclipse& eclipse);

/// "Total eclipse of the Moon, 2018-07-27".
std::string name_of(const eclipse::Eclipse& eclipse);

}  // namespace coppermoon::verbs
