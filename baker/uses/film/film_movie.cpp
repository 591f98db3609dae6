// SPDX-License-Identifier: MIT
#include "uses/film/film_movie.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <sstream>

#include "files/child_process.h"
#include "files/temporary_folder.h"
#include "files/whole_file.h"
#include "texture/read_image.h"
#include "uses/picture/avif_file.h"
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

/// Links pictures under numbers without a gap, as ffmpeg reads them.
void number_pictures(const fs::path& folder, const std::vector<fs::path>& pictures) {
  for (std::size_t i = 0; i < pictures.size(); ++i)
    fs::create_symlink(fs::absolute(pictures[i]), folder / fmt::format("{:07}.png", i));
}

/// Primaries and transfer characteristics of a display's code values, named as by ffmpeg.
///
/// Source  ITU-T H.273
struct DisplayCoding {
  const char *display, *primaries, *transfer;
};

/// Coding of a display of the built-in configuration; of any other display that of sRGB.
DisplayCoding coding_of(const std::string& display) {
  constexpr std::array<DisplayCoding, 3> others{{{"Rec.1886 Rec.709", "bt709", "bt709"},
                                                 {"Display P3", "smpte432", "iec61966-2-1"},
                                                 {"P3-D65", "smpte432", "smpte428"}}};
  const auto found = std::ranges::find(others, display, &DisplayCoding::display);
  return found != others.end() ? *found : DisplayCoding{"sRGB", "bt709", "iec61966-2-1"};
}

/// Arguments of ffmpeg for a film of standard dynamic range. The filter `setparams` tags the frames, as ffmpeg 7 would tag
/// all that comes from PNGs as sRGB, whatever -color_trc says.
std::string standard_range_coding(const std::string& display) {
  const auto coding = coding_of(display);
  return fmt::format(
      "scale=out_color_matrix=bt709:out_range=tv:flags=accurate_rnd+full_chroma_int,format=yuv420p,"
      "setparams=range=tv:colorspace=bt709:color_primaries={}:color_trc={} "
      "-c:v libx264 -crf 16",
      coding.primaries, coding.transfer);
}

/// Arguments of ffmpeg for HDR10. SMPTE ST 2086 counts chromaticities, here Rec.2020's, in steps of 0.00002, and light
/// in steps of 0.0001 cd/m².
std::string high_range_coding(const LightLevels& levels) {
  const auto whole = [](double light) { return std::max(1., std::ceil(light)); };
  return fmt::format(
      "scale=out_color_matrix=bt2020:out_range=tv:flags=accurate_rnd+full_chroma_int,"
      "format=yuv420p10le,"
      "setparams=range=tv:colorspace=bt2020nc:color_primaries=bt2020:color_trc=smpte2084 "
      "-c:v libx265 -crf 4 -tag:v hvc1 "
      "-x265-params log-level=error:hdr10=1:hdr10-opt=1:repeat-headers=1:"
      "master-display=G(8500,39850)B(6550,2300)R(35400,14600)WP(15635,16450)L({0:.0f},1):"
      "max-cll={1:.0f},{2:.0f}",
      1e4 * whole(levels.brightest), whole(levels.brightest), whole(levels.brightest_mean));
}

/// Command line of ffmpeg. Output by name to a descriptor that can seek, which its standard output as a pipe cannot.
std::vector<std::string> command(double fps, const std::string& coding) {
  std::istringstream words(
      fmt::format("ffmpeg -nostdin -loglevel error -xerror -y -framerate {} -f image2 -i %07d.png "
                  "-vf pad=ceil(iw/2)*2:ceil(ih/2)*2,{} "
                  "-movflags +faststart -f mp4 /dev/fd/1",
                  fps, coding));
  return {std::istream_iterator<std::string>(words), {}};
}

constexpr std::size_t codes = 65536;

/// Luminance of each 16-bit code of PQ [cd/m²].
std::vector<double> light_of_codes() {
  constexpr double most = 1e4;
  std::vector<double> light(codes);
  for (std::size_t i = 0; i < codes; ++i)
    light[i] = most * light_of_pq(static_cast<double>(i) / (codes - 1));
  return light;
}

}  // namespace

void require_ffmpeg() { files::run_program({.words = {"ffmpeg", "-version"}, .package = package}); }

void write_movie(const fs::path& path, const Film& film, const std::vector<std::size_t>& frames) {
  const files::TemporaryFolder folder;
  const auto pictures = pictures_of(film, frames);
  number_pictures(folder.path(), pictures);
  const auto coding = film.products.high_range ? high_range_coding(light_levels(pictures))
                                               : standard_range_coding(film.development.display);
  files::write_whole(path, [&](int descriptor) {
    files::run_program(
        {.words = command(film.fps, coding), .package = package, .folder = folder.path()},
        descriptor);
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
