// SPDX-License-Identifier: MIT
#include "verbs/reports/film_progress.h"

#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "almanac/calendar.h"
#include "files/standard_streams.h"
#include "verbs/reports/in_words.h"
#include "verbs/reports/one_line.h"

namespace coppermoon::verbs {
namespace {

using nlohmann::ordered_json;

void say(const std::string& line) {
  fmt::print("{}\n", line);
  std::fflush(stdout);
}

void say(const ordered_json& event) { say(event.dump()); }

}  // namespace

FilmProgress::FilmProgress(const uses::Film& film, std::size_t frames, bool json)
    : film_(film),
      frames_(frames),
      json_(json),
      on_terminal_(files::errors_on_terminal()),
      start_(std::chrono::steady_clock::now()) {}

FilmProgress::~FilmProgress() {
  if (on_terminal_) fmt::print(stderr, "\r\033[K");
}

double FilmProgress::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

void FilmProgress::light(bool kept, double seconds) const {
  if (json_)
    say({{"event", "light"},
         {"kept", kept},
         {"seconds", seconds},
         {"error", film_.light->error_found}});
  else if (!on_terminal_)
    say(fmt::format("light: {}, {}", kept ? "kept" : "made in " + duration(seconds),
                    within(film_.light->error_found)));
}

void FilmProgress::kept(std::size_t frame) { tell({frame, std::nullopt}, true); }

void FilmProgress::made(const uses::MadeFrame& frame) {
  ++(frame.developed_again ? developed_again_ : made_);
  tell(frame, false);
}

void FilmProgress::tell(const uses::MadeFrame& frame, bool kept) {
  ++done_;
  const auto instant =
      almanac::utc_text(film_.moments.at(frame.frame), film_.moments.eclipse.calendar);
  if (json_) {
    ordered_json event{{"event", "frame"}, {"frame", frame.frame}, {"instant", instant},
                       {"kept", kept},     {"done", done_},        {"of", frames_}};
    if (!kept) event["developed_again"] = frame.developed_again;
    if (frame.exposures) {
      event["exposure_time_s"] = frame.exposures->shorter.time_s;
      if (frame.exposures->longer_s) event["longer_exposure_time_s"] = *frame.exposures->longer_s;
    }
    for (const auto& path : film_.files(frame.frame)) event["files"].push_back(path.string());
    say(event);
  } else if (on_terminal_) {
    draw();
  } else {
    say(fmt::format("{} of {}: frame {}, {}{}", done_, frames_, frame.frame, instant,
                    kept              ? ", kept"
                    : frame.exposures ? ", " + exposure_in_words(*frame.exposures)
                                      : ""));
  }
}

void FilmProgress::draw() {
  constexpr std::size_t width = 30;
  const double rate = static_cast<double>(made_ + developed_again_) / std::max(1e-3, seconds());
  fmt::print(stderr, "\rframes [{:<{}}] {} of {}", std::string(width * done_ / frames_, '='), width,
             done_, frames_);
  if (rate > 0)
    fmt::print(stderr, ", {:.2g} a second, {} left\033[K", rate,
               duration(static_cast<double>(frames_ - done_) / rate));
  std::fflush(stderr);
}

void FilmProgress::file(const std::filesystem::path& path) {
  if (json_)
    say({{"event", "file"}, {"file", path.string()}});
  else
    say((on_terminal_ ? "\r\033[K" : "") + one_line(path.string()));
}

void FilmProgress::done() const {
  const auto kept = done_ - made_ - developed_again_;
  if (json_)
    say({{"event", "done"},
         {"made", made_},
         {"kept", kept},
         {"developed_again", developed_again_},
         {"seconds", seconds()}});
  else
    say(fmt::format(
        "{}{}: {} frames made,{} {} kept, in {}", on_terminal_ ? "\r\033[K" : "",
        one_line(film_.folder.string()), made_,
        developed_again_ > 0
            ? fmt::format(" {} developed again from kept linear frames,", developed_again_)
            : "",
        kept, duration(seconds())));
}

}  // namespace coppermoon::verbs
