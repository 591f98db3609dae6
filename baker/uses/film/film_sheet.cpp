// SPDX-License-Identifier: MIT
#include "uses/film/film_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "almanac/calendar.h"
#include "texture/contact_sheet.h"
#include "texture/write_image.h"
#include "uses/picture/caption.h"
#include "uses/picture/local_time.h"

namespace coppermoon::uses {
namespace {

constexpr std::size_t pictures_evenly = 40, most_columns = 8;

double seconds_from(const Moments& moments, const almanac::Instant& when, std::size_t frame) {
  return almanac::seconds_between(when, moments.at(frame));
}

/// The frame nearest to each contact during the film. Its caption names the contacts less than a minute away, and the
/// time from them. The limit is a minute because the times of day on a sheet are no finer than that.
std::map<std::size_t, std::string> frames_at_contacts(const Moments& moments,
                                                      const std::vector<std::size_t>& frames) {
  const double all = seconds_from(moments, moments.at(frames.front()), frames.back());
  const double slack = std::max(1., all / static_cast<double>(2 * frames.size()));
  std::map<std::size_t, std::string> names;
  for (const auto& [name, when] : contacts_of(moments.eclipse)) {
    const auto away = [&, at = when](std::size_t frame) {
      return std::abs(seconds_from(moments, at, frame));
    };
    if (seconds_from(moments, when, frames.front()) > slack ||
        seconds_from(moments, when, frames.back()) < -slack)
      continue;
    const auto nearest = *std::ranges::min_element(frames, {}, away);
    auto& known = names[nearest];
    if (away(nearest) < 60)
      known +=
          (known.empty() ? "" : ", ") + from_contact(name, seconds_from(moments, when, nearest));
  }
  return names;
}

std::vector<std::size_t> some_of(const std::vector<std::size_t>& frames) {
  if (frames.size() <= pictures_evenly) return frames;
  std::vector<std::size_t> some;
  for (std::size_t i = 0; i < pictures_evenly; ++i)
    some.push_back(
        frames[(i * (frames.size() - 1) + (pictures_evenly - 1) / 2) / (pictures_evenly - 1)]);
  return some;
}

/// Time zone of the times on the sheet. If absent, the times are in UTC.
std::optional<std::string> zone_of(const Film& film) {
  return film.view.observer ? std::optional(zone_or_utc(*film.view.observer)) : std::nullopt;
}

std::string title_of(const Film& film) {
  const auto& observer = film.view.observer;
  if (!observer)
    return title(film.moments.eclipse) + ", seen from the Earth's centre; times in UTC";
  const auto from = local_time(film.moments.frames.front(), *zone_of(film));
  return fmt::format("{}, seen from {}; times in {}", title(film.moments.eclipse),
                     place_in_words(*observer), from.abbreviation);
}

std::string time_of_day(const almanac::Instant& when, const std::optional<std::string>& zone) {
  return zone ? local_time(when, *zone).time : almanac::time_of_day_text(when);
}

}  // namespace

std::vector<SheetFrame> frames_of_sheet(const Moments& moments,
                                        const std::vector<std::size_t>& frames) {
  const auto at_contacts = frames_at_contacts(moments, frames);
  auto chosen = some_of(frames);
  for (const auto& [frame, name] : at_contacts) chosen.push_back(frame);
  std::ranges::sort(chosen);
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  std::vector<SheetFrame> sheet;
  for (const auto frame : chosen) {
    const auto known = at_contacts.find(frame);
    if (known != at_contacts.end() && !known->second.empty())
      sheet.push_back({frame, known->second, true});
    else
      sheet.push_back({frame, from_nearest_contact(moments.eclipse, moments.at(frame)), false});
  }
  return sheet;
}

void write_contact_sheet(const std::filesystem::path& path, const Film& film,
                         const std::vector<std::size_t>& frames) {
  const auto shown = frames_of_sheet(film.moments, frames);
  const double side = std::ceil(std::sqrt(static_cast<double>(shown.size())));
  texture::ContactSheet sheet{title_of(film),
                              {},
                              std::min(most_columns, static_cast<std::size_t>(side)),
                              texture::sheet_font()};
  const auto zone = zone_of(film);
  for (const auto& [frame, moment, at_contact] : shown)
    sheet.pictures.push_back(
        {film.picture(frame), time_of_day(film.moments.at(frame), zone), moment, at_contact});
  texture::write_png(path, texture::drawn(sheet), 8, film.record.film_header());
}

}  // namespace coppermoon::uses
