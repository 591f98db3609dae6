// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "algebra/described.h"
#include "uses/film/film.h"
#include "uses/film/film_frames.h"

namespace coppermoon::verbs {

/// The event, printed by --json, that the light of a film is available.
struct LightEvent {
  bool kept = false;
  double seconds = 0, error = 0;
};

template <class Field>
void describe(Field&& is, const LightEvent& light) {
  is.a("Light", "An event: the film's light is there.");
  is("event", "light", "kind of the event");
  is("kept", light.kept, "whether an earlier run made it");
  is("seconds", light.seconds, algebra::unit::seconds, "time that it took");
  is("error", light.error, "relative error of luminance, the largest on the disc");
}

struct FrameEvent {
  std::size_t frame = 0;
  std::string instant;
  bool kept = false;
  std::size_t done = 0, of = 0;
  std::optional<bool> developed_again;  ///< absent for a frame that is kept
  std::optional<uses::Exposures> exposures;
  std::vector<std::string> files;
};

template <class Field>
void describe(Field&& is, const FrameEvent& frame) {
  const auto& shown = frame.exposures;
  is.a("Frame", "An event: a frame is there.");
  is("event", "frame", "kind of the event");
  is("frame", frame.frame, "number of the frame");
  is("instant", frame.instant, "its moment, UTC");
  is("kept", frame.kept, "whether an earlier run made it");
  is("done", frame.done, "number of frames that are there");
  is("of", frame.of, "number of frames of this run");
  is("developed_again", algebra::if_any(frame.developed_again),
     "whether a linear frame was kept, and developed again");
  is("exposure_time_s",
     algebra::if_any(shown ? std::optional(shown->shorter.time_s) : std::nullopt),
     algebra::unit::seconds, "exposure time of a picture");
  is("longer_exposure_time_s", algebra::if_any(shown ? shown->longer_s : std::nullopt),
     algebra::unit::seconds, "longer exposure time, of a composite");
  is("files", algebra::if_any(frame.files.empty() ? std::nullopt : std::optional(frame.files)),
     "files of the frame");
}

struct FileEvent {
  std::string file;
};

template <class Field>
void describe(Field&& is, const FileEvent& event) {
  is.a("File", "An event: a file of the whole film is there, or would be written.");
  is("event", "file", "kind of the event");
  is("file", event.file, "the file");
}

struct DoneEvent {
  std::size_t made = 0, kept = 0, developed_again = 0;
  double seconds = 0;
};

template <class Field>
void describe(Field&& is, const DoneEvent& done) {
  is.a("Done", "An event: the film is done.");
  is("event", "done", "kind of the event");
  is("made", done.made, "number of frames made");
  is("kept", done.kept, "number of frames kept");
  is("developed_again", done.developed_again, "number of frames developed again");
  is("seconds", done.seconds, algebra::unit::seconds, "time that it took");
}

/// Shows the progress of a film. On a terminal, a bar on stderr shows the number of frames, the rate and the time left.
/// Otherwise, stdout receives a line for each frame or, with --json, a line of JSON for each event.
class FilmProgress {
 public:
  FilmProgress(const uses::Film& film, std::size_t frames, bool json);
  ~FilmProgress();
  FilmProgress(const FilmProgress&) = delete;
  FilmProgress& operator=(const FilmProgress&) = delete;

  /// Reports that the light is available, either kept from an earlier run or computed in the given time.
  void light(bool kept, double seconds) const;

  /// Reports that a frame exists from an earlier run and is kept.
  void kept(std::size_t frame);
  void made(const uses::MadeFrame& frame);

  /// Reports that a file that belongs to the whole film has been written.
  void file(const std::filesystem::path& path);

  /// Reports that the film is complete.
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
