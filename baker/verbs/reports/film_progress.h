// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>

#include "uses/film/film.h"
#include "uses/film/film_frames.h"

namespace coppermoon::verbs {

/// Progress of a film: on a terminal a bar on stderr with the count of frames, rate and time left; else a line per frame on stdout,
/// or one JSON event per line.
class FilmProgress {
 public:
  FilmProgress(const uses::Film& film, std::size_t frames, bool json);
  ~FilmProgress();
  FilmProgress(const FilmProgress&) = delete;
  FilmProgress& operator=(const FilmProgress&) = delete;

  /// Light is there, kept or made in so many seconds.
  void light(bool kept, double seconds) const;

  /// Frame of an earlier run is kept.
  void kept(std::size_t frame);
  void made(const uses::MadeFrame& frame);

  /// File of the whole film is there.
  void file(const std::filesystem::path& path);

  /// Film is done.
  void done() const;

 private:
  void tell(const uses::MadeFrame& frame, bool kept);
  void draw();
  double seconds() const;

  const uses::Film& film_;
  std::size_t frames_, done_ = 0, made_ = 0, developed_again_ = 0;
  bool json_, on_terminal_;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace coppermoon::verbs
