// SPDX-License-Identifier: MIT
#include "uses/film/film_curve.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <cmath>

#include "algebra/error.h"
#include "almanac/calendar.h"
#include "files/whole_file.h"
#include "texture/resize.h"
#include "uses/light/photometric_bands.h"
#include "uses/picture/curve_plot.h"
#include "uses/picture/moon_survey.h"
#include "uses/plot/plot.h"

namespace coppermoon::uses {
namespace {

using Curve = std::vector<CurvePoint>;

constexpr std::size_t rows = 180;  ///< of the textures that are measured

/// Number as text; empty where it is not finite.
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

/// Curve in one panel: hours against a column.
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

}  // namespace

void require_curve_ending(const std::filesystem::path& path) {
  require_plot_ending(path, "a curve", true);
}

Curve light_curve(const Film& film, const std::vector<std::size_t>& frames) {
  const MoonSurvey survey(film.moon, texture::resized(normal_albedo(film.moon), rows), *film.light);
  Curve curve(frames.size());
  tbb::parallel_for(std::size_t{0}, frames.size(), [&](std::size_t i) {
    const auto sky = film.sky(frames[i]);
    const auto disc = survey.brightness(sky);
    curve[i] = {frames[i], sky.when, disc.magnitudes[V_band], disc.mean_luminance_cd_m2};
  });
  return curve;
}

void write_curve(const std::filesystem::path& path, const eclipse::Eclipse& eclipse,
                 const Curve& curve) {
  require_curve_ending(path);
  if (path.extension() == ".csv")
    files::write_whole(path, as_csv(eclipse, curve));
  else
    write_plot(path, plot_of(eclipse, curve));
}

}  // namespace coppermoon::uses
