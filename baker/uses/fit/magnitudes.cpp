// SPDX-License-Identifier: MIT
#include "uses/fit/magnitudes.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <sstream>
#include <string_view>

#include "algebra/error.h"
#include "algebra/number.h"
#include "algebra/table.h"
#include "eclipse/shadow_axis.h"
#include "files/whole_file.h"
#include "surface/albedo_map.h"
#include "texture/bake.h"
#include "uses/light/photometer.h"

namespace coppermoon::uses {
namespace {

constexpr std::size_t map_rows = 128, most_bytes = 1 << 20;

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  for (std::size_t begin = 0; begin <= line.size();) {
    const auto end = std::min(line.find(',', begin), line.size());
    const auto cell = line.substr(begin, end - begin);
    const auto from = cell.find_first_not_of(" \t\r"), to = cell.find_last_not_of(" \t\r");
    cells.push_back(from == std::string::npos ? "" : cell.substr(from, to - from + 1));
    begin = end + 1;
  }
  return cells;
}

std::size_t band_named(const std::string& name) {
  const auto bands = photometric_bands();
  const auto band = std::ranges::find(bands, name, &PhotometricBand::name);
  if (band == bands.end()) throw algebra::Error(fmt::format("band = {}, allowed B, V or R", name));
  return static_cast<std::size_t>(band - bands.begin());
}

double number_in(const std::string& cell, const char* what, double least, double most) {
  const auto number = algebra::number_in(cell);
  if (!number) throw algebra::Error(fmt::format("{} = {}, allowed a number", what, cell));
  algebra::require_within(what, *number, least, most);
  return *number;
}

/// Throws if a column name is missing, repeated or unknown.
void require_columns(const std::vector<std::string>& names) {
  const auto count = [&](std::string_view name) { return std::ranges::count(names, name); };
  const auto errors = count("error");
  if (count("instant") == 1 && count("band") == 1 && count("magnitude") == 1 && errors <= 1 &&
      std::ssize(names) == 3 + errors)
    return;
  throw algebra::Error(
      fmt::format("columns = {}, allowed instant, band, magnitude and, if you like, error, each "
                  "once, with commas between",
                  fmt::join(names, ",")));
}

MeasuredMagnitude measured_in(const std::vector<std::string>& cells,
                              const std::vector<std::string>& names) {
  // whole numbers are not accepted as errors, because they could be the digits after a decimal comma
  constexpr double least_error = 1e-3, most_error = 0.99;
  if (cells.size() < names.size()) throw algebra::Error("a line of fewer columns than the first");
  if (cells.size() > names.size())
    throw algebra::Error(
        fmt::format("{} columns, allowed {} as in the first line, and decimal points, no commas, "
                    "in numbers",
                    cells.size(), names.size()));
  const auto cell = [&](std::string_view name) {
    const auto at = std::ranges::find(names, name) - names.begin();
    return at < std::ssize(cells) ? cells[static_cast<std::size_t>(at)] : "";
  };
  const auto instant = almanac::instant_from_utc(cell("instant"));
  band_named(cell("band"));
  MeasuredMagnitude measured{instant, cell("band"),
                             number_in(cell("magnitude"), "magnitude", -30, 30)};
  if (const auto error = cell("error"); !error.empty())
    measured.error = number_in(error, "error of a magnitude", least_error, most_error);
  return measured;
}

/// Texels of the Moon's map that are visible from the Earth's centre, all in one bin, weighted by their visible area.
std::vector<LitPlace> places_of(const MoonRequest& moon, const almanac::SkyState& sky) {
  const shadow::Lookup whole(shadow::ChannelWeights(1, 1, 1.));
  const auto lit =
      texture::bake({normal_albedo(moon), sky, whole}, {"Y"}, map_rows, moon.photometry);
  const auto axis = eclipse::shadow_axis(sky);
  const auto earth = sky.selenographic_from_gcrs * -sky.moon_m /
                     algebra::in_metres(almanac::lunar_radius);  // vector to Earth [lunar radii]
  std::vector<LitPlace> places;
  for (std::size_t r = 0; r < map_rows; ++r)
    for (std::size_t c = 0; c < 2 * map_rows; ++c) {
      const auto texel = surface::texel_centre(r, c, map_rows);
      const auto ground = almanac::selenographic_direction(texel);
      const double seen = glm::dot(ground, glm::normalize(earth - ground)) *
                          std::cos(algebra::in_radians(texel.latitude)) * lit(r, c, 0);
      if (seen > 0) places.push_back({eclipse::place_of_ground(axis, sky, ground), seen, 0});
    }
  return places;
}

/// Magnitudes that the Moon would have if the Earth cast no shadow on it.
std::vector<double> unshadowed_magnitudes(const MoonRequest& moon, const almanac::SkyState& sky,
                                          const Photometer& meter) {
  const shadow::Lookup whole(meter.weights);
  const auto lit =
      texture::bake({normal_albedo(moon), sky, whole}, meter.channels, map_rows, moon.photometry);
  return measured(meter, lit, sky).magnitudes;
}

}  // namespace

std::vector<MeasuredMagnitude> read_magnitudes(const std::string& file) {
  const auto text = files::beginning_of(file, most_bytes + 1);
  if (text.size() > most_bytes)
    throw algebra::Error(
        fmt::format("{}: a list of more than {} bytes, allowed up to that", file, most_bytes));
  std::istringstream lines(std::string(algebra::utf8_text(text, file)));
  std::vector<std::string> names;
  std::vector<MeasuredMagnitude> all;
  std::size_t number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (line.starts_with('#') || line.find_first_not_of(" \t\r") == std::string::npos) continue;
    try {
      const auto cells = cells_of(line);
      if (names.empty())
        require_columns(names = cells);
      else
        all.push_back(measured_in(cells, names));
    } catch (const algebra::Error& error) {
      throw algebra::Error(fmt::format("{}:{}: {}", file, number, error.what()));
    }
  }
  if (all.empty()) throw algebra::Error(fmt::format("{}: holds no magnitudes", file));
  return all;
}

DataSet data_of(const MoonRequest& moon, Unknowns unknowns, const almanac::SkyState& sky,
                const std::vector<MeasuredMagnitude>& of_one_instant,
                const algebra::Progress& progress) {
  require_eclipse(sky.when);
  const auto meter = photometer();
  const LitBins whole_disc{meter.weights, places_of(moon, sky), 1};
  FittedLight light(moon.light, unknowns, std::span(&sky, 1), std::span(&whole_disc, 1),
                    FittedAirs::fine, progress);
  const auto unshadowed = unshadowed_magnitudes(moon, sky, meter);
  std::vector<double> whole;
  for (std::size_t k = 0; k < meter.weights.rows(); ++k) {
    const auto row = meter.weights.row(k);
    whole.push_back(std::reduce(row.begin(), row.end()));
  }
  const auto goodness = [=](const algebra::Grid<double>& found) {
    constexpr double computed = 0.02;
    double sum = 0;
    for (const auto& seen : of_one_instant) {
      const auto k = band_named(seen.band);
      const double magnitude =
          unshadowed[k] - 2.5 * std::log10(std::max(1e-12, found(0, k)) / whole[k]);
      sum +=
          std::pow(magnitude - seen.magnitude, 2) / (seen.error * seen.error + computed * computed);
    }
    return GoodnessOfFit{sum};
  };
  return {std::move(light), goodness, of_one_instant.size()};
}

}  // namespace coppermoon::uses
