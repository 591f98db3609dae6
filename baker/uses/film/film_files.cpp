// SPDX-License-Identifier: MIT
#include "uses/film/film_files.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "algebra/error.h"
#include "algebra/number.h"
#include "almanac/calendar.h"
#include "files/whole_file.h"
#include "texture/contact_sheet.h"
#include "texture/read_image.h"
#include "texture/resize.h"
#include "texture/write_image.h"
#include "uses/film/film_movie.h"
#include "uses/film/film_sheet.h"
#include "uses/film/film_stage.h"
#include "uses/picture/plots.h"

namespace coppermoon::uses {
namespace {

namespace fs = std::filesystem;

/// Refuses a file whose name does not end in `ending`. An empty path is accepted.
void require_ending(const fs::path& file, const char* what, const char* ending) {
  if (!file.empty() && file.extension() != ending)
    throw algebra::Error(fmt::format("{}: a {} ends in {}", file.string(), what, ending));
}

/// Refuses a file that has the same name as a file of one of the film's frames.
void require_no_frame(const fs::path& file, Film film) {
  film.products = {.textures = true, .frames = true, .pictures = true, .high_range = true};
  film.bracket_ev = 1;
  for (auto frame = film.moments.first_frame; frame <= film.moments.last_frame(); ++frame)
    for (const auto& own : film.files(frame))
      if (own.filename() == file.filename())
        throw algebra::Error(
            fmt::format("{}: is the name of a frame, allowed another", file.string()));
}

/// Refuses a path where no file can be written. The film's folder need not exist yet.
void require_place_for(const fs::path& file, const Film& film) {
  if (file.empty()) return;
  const auto folder = fs::weakly_canonical(fs::absolute(file)).parent_path();
  const auto own = fs::weakly_canonical(fs::absolute(film.folder) / "").parent_path();
  if (folder != own || fs::is_directory(film.folder)) files::require_place_for(file);
  if (folder == own) require_no_frame(file, film);
}

void require_product(bool made, const fs::path& file, const char* what, const char* product) {
  if (!file.empty() && !made)
    throw algebra::Error(fmt::format("{0}: a {1} is made of {2}, allowed where {2} are made",
                                     file.string(), what, product));
}

/// Brightness of the Moon's whole disc in one frame, as seen from the Earth's centre, without the effect of air.
struct CurvePoint {
  std::size_t frame;
  almanac::Instant when;
  double V_magnitude;  ///< apparent magnitude; infinite if no part of the Moon is lit
  double mean_luminance_cd_m2;
};

using Curve = std::vector<CurvePoint>;

/// Light curve for the given frames, from the light in the Earth's shadow that all frames of the film share.
///
/// Accuracy  5e-4 in magnitude and in relative luminance, compared with brightness_of, which simulates each moment
///           separately and uses twice as many rows
Curve curve_of(const Film& film, const std::vector<std::size_t>& frames) {
  constexpr std::size_t rows = 180;  // rows of the textures used to measure brightness
  const MoonSurvey survey(film.moon, texture::resized(normal_albedo(film.moon), rows), *film.light);
  Curve curve(frames.size());
  tbb::parallel_for(std::size_t{0}, frames.size(), [&](std::size_t i) {
    const auto sky = film.sky(frames[i]);
    const auto disc = survey.brightness(sky);
    curve[i] = {frames[i], sky.when, disc.magnitudes[V_band], disc.mean_luminance_cd_m2};
  });
  return curve;
}

/// A number as text. The text is empty if the number is not finite.
std::string number(double value, int decimals) {
  return std::isfinite(value) ? fmt::format("{:.{}f}", value, decimals) : "";
}

std::string as_csv(const eclipse::Eclipse& eclipse, const Curve& curve) {
  std::string text = "frame,instant,hours_from_greatest,V_magnitude,mean_luminance_cd_m2\n";
  for (const auto& point : curve)
    text += fmt::format("{},{},{:.6f},{},{:.6g}\n", point.frame,
                        almanac::utc_text(point.when, eclipse.calendar, 3),
                        hours_from_greatest(eclipse, point.when), number(point.V_magnitude, 4),
                        point.mean_luminance_cd_m2);
  return text;
}

/// The curve in one panel of the plot. It shows the given member of each point against hours from greatest eclipse.
PlotCurve drawn(const eclipse::Eclipse& eclipse, const Curve& curve, double CurvePoint::*column) {
  std::string data;
  for (const auto& point : curve)
    data += fmt::format("{:.6f},{}\n", hours_from_greatest(eclipse, point.when),
                        number(point.*column, 6));
  return {data, "linespoints pt 7 ps 0.4 lw 2 lc rgb '#b0432b'"};
}

Plot plot_of(const eclipse::Eclipse& eclipse, const Curve& curve) {
  auto plot = plot_over(eclipse, curve.front().when, curve.back().when);
  plot.panels = {{{.label = "V magnitude", .reversed = true},
                  {drawn(eclipse, curve, &CurvePoint::V_magnitude)}},
                 {{.label = "mean luminance of the disc [cd/m^2]", .logarithmic = true},
                  {drawn(eclipse, curve, &CurvePoint::mean_luminance_cd_m2)}}};
  return plot;
}

/// Writes a curve as a table if the file is .csv, otherwise as a plot with the eclipse's contacts.
void write_curve(const fs::path& path, const eclipse::Eclipse& eclipse, const Curve& curve) {
  if (path.extension() == ".csv")
    files::write_whole(path, as_csv(eclipse, curve));
  else
    write_plot(path, plot_of(eclipse, curve));
}

double number_in_header(const fs::path& frame, const char* name) {
  const auto value = algebra::number_in(texture::read_attribute(frame, name).value_or(""));
  if (!value) throw algebra::Error(fmt::format("{}: its header has no {}", frame.string(), name));
  return *value;
}

double exposure_scale_of(const Development& development, const fs::path& frame) {
  return scale_of(development,
                  {number_in_header(frame, "expTime"), number_in_header(frame, "aperture"),
                   number_in_header(frame, "isoSpeed")});
}

/// Adds the light of one exposed frame to a multiple exposure, which is empty before the first frame.
void expose(const Development& development, texture::Image& film, const fs::path& frame) {
  const auto image = texture::read_image(frame);
  if (film.values.empty()) film = texture::Image(image.width, image.height, image.channels);
  if (image.width != film.width || image.height != film.height || image.channels != film.channels)
    throw algebra::Error(fmt::format("{}: {} x {} pixels, allowed {} x {}, as the first frame",
                                     frame.string(), image.width, image.height, film.width,
                                     film.height));
  const auto scale = static_cast<float>(exposure_scale_of(development, frame));
  const bool sky = seen_by(frame).sky_cd_m2 > 0;
  for (std::size_t i = 0; i < film.values.size(); ++i) {
    float& value = film.values[i];
    value = sky ? std::max(value, scale * image.values[i]) : value + scale * image.values[i];
  }
}

/// Writes a multiple exposure: a single picture developed from the sum of linear frames, each scaled by its exposure.
///
///     value = Σ s L        s: scale for a frame's exposure, L: value of a pixel in that frame
///
/// If the frames show the sky, each pixel is instead the greatest s L, as in the lighten mode of photo editors, because
/// a sum would add the sky many times.
///
/// Omits   occlusion where images of the Moon overlap
/// Throws  Error  when a frame cannot be read, differs in size from the first, or has no exposure in its header
void write_composite(const fs::path& path, const Film& film,
                     const std::vector<std::size_t>& frames) {
  texture::Image exposed;
  for (const auto frame : frames) expose(film.development, exposed, film.linear_frame(frame));
  const auto& development = film.development;
  auto header = film.record.film_header();
  header["coppermoon:view"] = development.display + ", " + development.view;
  texture::write_png(path, shown(development, 1, exposed, space_of(film.content)), development.bits,
                     header);
}

}  // namespace

std::vector<fs::path> FilmFiles::all() const {
  auto files = curves;
  for (const auto* file : {&contact_sheet, &composite, &movie, &stage})
    if (!file->empty()) files.push_back(*file);
  return files;
}

void require_sound(const FilmFiles& files, const Shard& shard) {
  if (files.all().empty()) return;
  if (shard.parts != 1)
    throw algebra::Error(fmt::format("shard = {}/{}, allowed 1/1 for what needs every frame",
                                     shard.part, shard.parts));
  for (const auto& curve : files.curves) require_plot_ending(curve, "a curve", true);
  require_ending(files.contact_sheet, "contact sheet", ".png");
  require_ending(files.composite, "composite", ".png");
  require_movie_ending(files.movie);
  require_ending(files.stage, "stage", ".usda");
}

void require_makeable(const FilmFiles& files, const Film& film) {
  for (const auto& curve : files.curves) require_place_for(curve, film);
  for (const auto* file : {&files.contact_sheet, &files.movie, &files.composite, &files.stage})
    require_place_for(*file, film);
  require_product(film.products.pictures, files.contact_sheet, "contact sheet", "pictures");
  if (!files.contact_sheet.empty()) texture::sheet_font();
  require_product(film.products.frames, files.composite, "composite", "frames");
  require_product(film.products.pictures, files.movie, "movie", "pictures");
  if (!files.movie.empty()) require_ffmpeg();
  if (!files.stage.empty()) require_stage(files.stage, film);
}

void write_film_files(const FilmFiles& files, const Film& film, std::vector<std::size_t> frames,
                      const std::function<void(const fs::path&)>& made) {
  std::ranges::sort(frames);
  const auto tell = [&](const fs::path& file) {
    if (made) made(file);
  };
  const auto make = [&](const fs::path& file, const auto& write) {
    if (file.empty()) return;
    write(file, film, frames);
    tell(file);
  };
  if (!files.curves.empty()) {
    const auto curve = curve_of(film, frames);
    for (const auto& file : files.curves) {
      write_curve(file, film.moments.eclipse, curve);
      tell(file);
    }
  }
  make(files.contact_sheet, write_contact_sheet);
  make(files.composite, write_composite);
  make(files.movie, write_movie);
  make(files.stage, write_stage);
}

}  // namespace coppermoon::uses
