// SPDX-License-Identifier: MIT
#include "uses/film/film_movie.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <sstream>

#include "algebra/error.h"
#include "files/child_process.h"
#include "files/temporary_folder.h"
#include "files/whole_file.h"
#include "texture/read_image.h"
#include "uses/picture/picture_files.h"
#include "uses/picture/pixels.h"

namespace coppermoon::uses {
namespace {

namespace fs = std::filesystem;

constexpr const char* package = "ffmpeg";

std::vector<fs::path> pictures_of(const Film& film, const std::vector<std::size_t>& frames) {
  std::vector<fs::path> pictures;
  for (const std::size_t frame : frames)
    pictures.push_back(film.products.high_range ? film.high_range_picture(frame)
                                                : film.picture(frame));
  return pictures;
}

/// Gives the pictures consecutive numbers as file names, because ffmpeg requires such names.
void number_pictures(const fs::path& folder, const std::vector<fs::path>& pictures) {
  for (std::size_t i = 0; i < pictures.size(); ++i)
    files::name_also(pictures[i], folder / fmt::format("{:07}.png", i));
}

/// Primaries and transfer characteristics of a display, under the names that ffmpeg uses.
///
/// Source  ITU-T H.273
struct DisplayCoding {
  const char *display, *primaries, *transfer;
};

/// The coding for a display of the built-in configuration. Any other display is coded as sRGB.
DisplayCoding coding_of(const std::string& display) {
  constexpr std::array<DisplayCoding, 3> others{{{"Rec.1886 Rec.709", "bt709", "bt709"},
                                                 {"Display P3", "smpte432", "iec61966-2-1"},
                                                 {"P3-D65", "smpte432", "smpte428"}}};
  const auto found = std::ranges::find(others, display, &DisplayCoding::display);
  return found != others.end() ? *found : DisplayCoding{"sRGB", "bt709", "iec61966-2-1"};
}

/// ffmpeg's filters that convert the pictures to a movie's matrix and pixel format, and tag the frames. The filter
/// `setparams` does the tagging, because ffmpeg 7 would tag frames from PNGs as sRGB, whatever -color_trc says.
std::string coding(const char* matrix, const char* format, const DisplayCoding& tags) {
  return fmt::format(
      "scale=out_color_matrix={}:out_range=tv:flags=accurate_rnd+full_chroma_int,format={},"
      "setparams=range=tv:colorspace={}:color_primaries={}:color_trc={} ",
      matrix, format, std::string_view(matrix) == "bt2020" ? "bt2020nc" : matrix, tags.primaries,
      tags.transfer);
}

constexpr DisplayCoding high_range_tags{"Rec.2100-PQ", "bt2020", "smpte2084"};

/// ffmpeg's arguments for a film of standard dynamic range.
std::string standard_range_coding(const std::string& display) {
  return coding("bt709", "yuv420p", coding_of(display)) + "-c:v libx264 -crf 16";
}

/// ffmpeg's arguments for ProRes 422 HQ, with the vendor code that editing programs look for.
std::string prores_coding(const Film& film) {
  constexpr const char* format = "yuv422p10le";
  return (film.products.high_range ? coding("bt2020", format, high_range_tags)
                                   : coding("bt709", format, coding_of(film.development.display))) +
         "-c:v prores_ks -profile:v hq -vendor apl0";
}

/// ffmpeg's arguments for HDR10. As in SMPTE ST 2086, chromaticities (here those of Rec.2020) are given in steps of
/// 0.00002, and luminances in steps of 0.0001 cd/m².
std::string high_range_coding(const LightLevels& levels) {
  const auto whole = [](double light) { return std::max(1., std::ceil(light)); };
  return coding("bt2020", "yuv420p10le", high_range_tags) +
         fmt::format(
             "-c:v libx265 -crf 4 -tag:v hvc1 "
             "-x265-params log-level=error:hdr10=1:hdr10-opt=1:repeat-headers=1:"
             "master-display=G(8500,39850)B(6550,2300)R(35400,14600)WP(15635,16450)L({0:.0f},1):"
             "max-cll={1:.0f},{2:.0f}",
             1e4 * whole(levels.brightest), whole(levels.brightest), whole(levels.brightest_mean));
}

bool is_prores(const fs::path& movie) { return movie.extension() == ".mov"; }

std::string coding_for(const fs::path& movie, const Film& film,
                       const std::vector<fs::path>& pictures) {
  if (is_prores(movie)) return prores_coding(film);
  return film.products.high_range ? high_range_coding(light_levels(pictures))
                                  : standard_range_coding(film.development.display);
}

/// ffmpeg's command line. ffmpeg opens the output file by name, because it has to seek backwards in the file.
std::vector<std::string> command(const FrameRate& fps, const std::string& coding,
                                 const fs::path& movie, const std::string& output) {
  std::istringstream words(
      fmt::format("ffmpeg -nostdin -loglevel error -xerror -y -framerate {} -f image2 -i %07d.png "
                  "-vf pad=ceil(iw/2)*2:ceil(ih/2)*2,{} "
                  "-movflags +faststart -f {}",
                  text_of(fps), coding, is_prores(movie) ? "mov" : "mp4"));
  std::vector<std::string> all{std::istream_iterator<std::string>(words), {}};
  all.push_back(output);
  return all;
}

constexpr std::size_t codes = 65536;

/// Luminance for each 16-bit PQ code [cd/m²].
std::vector<double> light_of_codes() {
  constexpr double most = 1e4;
  std::vector<double> light(codes);
  for (std::size_t i = 0; i < codes; ++i)
    light[i] = most * light_of_pq(static_cast<double>(i) / (codes - 1));
  return light;
}

}  // namespace

void require_movie_ending(const fs::path& path) {
  if (!path.empty() && path.extension() != ".mp4" && !is_prores(path))
    throw algebra::Error(fmt::format("{}: a movie ends in .mp4 or .mov", path.string()));
}

void require_ffmpeg() { files::run_program({.words = {"ffmpeg", "-version"}, .package = package}); }

void write_movie(const fs::path& path, const Film& film, const std::vector<std::size_t>& frames) {
  const files::TemporaryFolder folder;
  const auto pictures = pictures_of(film, frames);
  number_pictures(folder.path(), pictures);
  const auto coding = coding_for(path, film, pictures);
  files::write_whole(path, [&](const files::Handle& file) {
    const auto words = command(film.fps, coding, path, files::own_output(file));
    files::run_program({.words = words, .package = package, .folder = folder.path()}, &file);
  });
}

LightLevels light_levels(const std::vector<fs::path>& pictures) {
  const auto light = light_of_codes();
  std::vector<LightLevels> each(pictures.size());
  tbb::parallel_for(std::size_t{0}, pictures.size(), [&](std::size_t i) {
    const auto pixels = pixels_of(texture::read_image(pictures[i]));
    for (const auto& pixel : pixels.values()) {
      const double code = std::clamp(std::ranges::max(pixel), 0.F, 1.F);
      const double bright = light[static_cast<std::size_t>(std::lround(code * (codes - 1)))];
      each[i].brightest = std::max(each[i].brightest, bright);
      each[i].brightest_mean += bright / static_cast<double>(pixels.values().size());
    }
  });
  LightLevels all;
  for (const auto& one : each) {
    all.brightest = std::max(all.brightest, one.brightest);
    all.brightest_mean = std::max(all.brightest_mean, one.brightest_mean);
  }
  return all;
}

}  // namespace coppermoon::uses
