// SPDX-License-Identifier: MIT
#include "uses/film/film_movie.h"

#include <fmt/format.h>
#include <unistd.h>

#include <iterator>
#include <sstream>

#include "files/temporary_folder.h"
#include "files/whole_file.h"
#include "povray_scenes/child_process.h"

namespace coppermoon::uses {
namespace {

namespace fs = std::filesystem;

constexpr const char* package = "ffmpeg";

/// Frames by names that ffmpeg counts through without a gap.
void number_pictures(const fs::path& folder, const Film& film,
                     const std::vector<std::size_t>& frames) {
  for (std::size_t i = 0; i < frames.size(); ++i)
    fs::create_symlink(fs::absolute(film.picture(frames[i])), folder / fmt::format("{:07}.png", i));
}

/// Given  film  a descriptor that ffmpeg inherits: it needs a file in which it can go back
std::vector<std::string> command(double fps, int film) {
  std::istringstream words(fmt::format(
      "ffmpeg -nostdin -loglevel error -xerror -y -framerate {} -f image2 -i %07d.png "
      "-vf pad=ceil(iw/2)*2:ceil(ih/2)*2,"
      "scale=out_color_matrix=bt709:out_range=tv:flags=accurate_rnd+full_chroma_int,format=yuv420p "
      "-c:v libx264 -crf 16 -color_primaries bt709 -color_trc bt709 -colorspace bt709 "
      "-color_range tv -movflags +faststart -f mp4 /dev/fd/{}",
      fps, film));
  return {std::istream_iterator<std::string>(words), {}};
}

}  // namespace

void require_ffmpeg() {
  povray_scenes::run_program({.words = {"ffmpeg", "-version"}, .package = package});
}

void write_movie(const fs::path& path, const Film& film, const std::vector<std::size_t>& frames) {
  const files::TemporaryFolder folder;
  number_pictures(folder.path(), film, frames);
  files::write_whole(path, [&](int descriptor) {
    povray_scenes::FileDescriptor inherited;
    inherited.number = ::dup(descriptor);  // what is opened here is closed to other programs
    povray_scenes::run_program({.words = command(film.fps, inherited.number),
                                .package = package,
                                .folder = folder.path()});
  });
}

}  // namespace coppermoon::uses
