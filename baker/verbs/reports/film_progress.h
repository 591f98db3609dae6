// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>

#include "uses/film/film.h"
#include "uses/film/film_frames.h"

namespace coppermoon::verbs {

/// Tells how a film comes along: on a terminal one bar on stderr with the frame, the rate and the time
/// left; else a line a frame on stdout; or as JSON an event a line.
class FilmProgress {
 public:
  FilmProgress(const uses::Film& film, std::size_t frames, bool json);
  ~FilmProgress();
  FilmProgress(const FilmProgress&) = delete;
  FilmProgress& operator=(const FilmProgress&) = delete;

  /// Once the light is there, and how long it took.
  void light(bool kept, double seconds) const;

  /// A frame that an earlier run left.
  void kept(std::size_t frame);
  void made(const uses::MadeFrame& frame);

  /// A file made of many frames is there.
  void file(const std::filesystem::path& path);

  /// The end.
  void done() const;

 private:
  void tell(const uses::MadeFrame& frame, bool kept);
  void draw(std::size_t frame);
  double seconds() const;

  const uses::Film& film_;
  std::size_t frames_, done_ = 0, made_ = 0, developed_again_ = 0;
  bool json_, on_terminal_;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace coppermoon::verbs
