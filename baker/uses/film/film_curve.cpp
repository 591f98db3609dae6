// SPDX-License-Identifier: MIT
#include "uses/film/film_curve.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <cmath>

#include "algebra/error.h"
#include "almanac/calendar.h"
#include "files/whole_file.h"
#include "texture/bake.h"
#include "texture/resize.h"
#include "uses/picture/gnuplot.h"
#include "uses/light/photometer.h"
#include "uses/light/spectral_bands.h"

namespace coppermoon::uses {
namespace {

using Curve = std::vector<CurvePoint>;

constexpr std::size_t rows = 180;

/// All that the points of a curve share.
struct Survey {
  const Film& film;
  Photometer meter;
  algebra::Grid<float> albedo;
  std::shared_ptr<const surface::Ground> ground;
  shadow::Lookup shadowed, sunlit;

  CurvePoint point(std::size_t frame) const {
    const auto sky = film.sky(frame);
    const auto& light = range_at(*film.light, sky) ? shadowed : sunlit;
    const auto disc = measured(meter,
                               texture::bake({albedo, sky, light, ground.get()}, meter.channels,
                                             rows, film.moon.photometry),
                               sky);
    return {frame, sky.when, disc.magnitudes[1], disc.mean_luminance_cd_m2};
  }
};

double hours(const eclipse::Eclipse& eclipse, const almanac::Instant& when) {
  return almanac::seconds_between(eclipse.greatest, when) / 3600;
}

/// A number, or nothing for one that is none.
std::string number(double value, int decimals) {
  return std::isfinite(value) ? fmt::format("{:.{}f}", value, decimals) : "";
}

std::string as_csv(const eclipse::Eclipse& eclipse, const Curve& curve) {
  std::string text = "frame,instant,hours_from_greatest,V_magnitude,mean_luminance_cd_m2\n";
  for (const auto& point : curve)
    text += fmt::format("{},{},{:.6f},{},{:.6g}\n", point.frame, almanac::utc_text(point.when, eclipse.calendar, 3),
                        hours(eclipse, point.when), number(point.V_magnitude, 4),
                        point.mean_luminance_cd_m2);
  return text;
}

/// A line across both panels at each contact between two hours, its name above the first.
std::string contact_marks(const eclipse::Eclipse& eclipse, double from, double to) {
  std::string marks;
  for (const auto& [name, when] : contacts_of(eclipse)) {
    const double at = hours(eclipse, when);
    if (at < from || at > to) continue;
    marks += fmt::format(
        "set arrow from first {0:.5f}, graph 0 to first {0:.5f}, graph 1 nohead lc rgb '#bbbbbb'\n"
        "set label '{1}' at first {0:.5f}, graph 1.05 center font ',11'\n",
        at, name);
  }
  return marks;
}

std::string plot_script(const eclipse::Eclipse& eclipse, const Curve& curve) {
  const double first = hours(eclipse, curve.front().when), last = hours(eclipse, curve.back().when),
               margin = std::max(1e-3, (last - first) / 50), from = first - margin,
               to = last + margin;
  const auto table = as_csv(eclipse, curve);
  return fmt::format(R"(set datafile separator ','
$curve << EOD
{}EOD
set multiplot title '{}' font ',15'
set lmargin 12
set rmargin 4
set grid lt 1 lc rgb '#eeeeee'
set xrange [{:.5f}:{:.5f}]
set key off
set origin 0, 0.47
set size 1, 0.46
set bmargin 1
set tmargin 2
set format x ''
set ylabel 'V magnitude'
set yrange [*:*] reverse
{}plot $curve using 3:4 with linespoints pt 7 ps 0.4 lw 2 lc rgb '#b0432b'
unset label
set origin 0, 0
set size 1, 0.49
set bmargin 4
set tmargin 1
set format x '%g'
set xlabel 'hours from greatest eclipse'
set ylabel 'mean luminance of the disc [cd/m^2]'
set yrange [*:*] noreverse
set logscale y
set format y '10^{{%L}}'
plot $curve using 3:5 with linespoints pt 7 ps 0.4 lw 2 lc rgb '#b0432b'
unset multiplot
)",
                     table.substr(table.find('\n') + 1), name_of(eclipse), from, to,
                     contact_marks(eclipse, from, to));
}

}  // namespace

void require_curve_ending(const std::filesystem::path& path) {
  const auto ending = path.extension();
  if (ending != ".csv" && ending != ".svg" && ending != ".png")
    throw algebra::Error(fmt::format("{}: a curve ends in .csv, .svg or .png", path.string()));
}

Curve light_curve(const Film& film, const std::vector<std::size_t>& frames) {
  const auto meter = photometer();
  const auto albedo = texture::resized(normal_albedo(film.moon), rows);
  const auto ground = ground_of(film.moon, albedo);
  const auto weights =
      ground ? reddest_and_bluest(meter.weights, band_centres_nm()) : meter.weights;
  const Survey survey{
      film, meter, albedo, ground, film.light->in_channels(weights), shadow::Lookup(weights)};
  Curve curve(frames.size());
  tbb::parallel_for(std::size_t{0}, frames.size(),
                    [&](std::size_t i) { curve[i] = survey.point(frames[i]); });
  return curve;
}

void write_curve(const std::filesystem::path& path, const eclipse::Eclipse& eclipse,
                 const Curve& curve) {
  require_curve_ending(path);
  if (path.extension() == ".csv")
    files::write_whole(path, as_csv(eclipse, curve));
  else
    write_plot(path,
               path.extension() == ".png"
                   ? "pngcairo size 1100,760 font 'sans,12'"
                   : "svg size 1100,760 background rgb 'white' font 'sans-serif,13'",
               plot_script(eclipse, curve));
}

}  // namespace coppermoon::uses
