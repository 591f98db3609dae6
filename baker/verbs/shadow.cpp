// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>

#include "algebra/error.h"
#include "algebra/interpolation.h"
#include "almanac/instant.h"
#include "eclipse/shadow_axis.h"
#include "verbs/gnuplot.h"
#include "verbs/light_options.h"
#include "verbs/moon_options.h"
#include "verbs/number_list.h"
#include "verbs/recipe.h"
#include "verbs/shadow_strip.h"
#include "verbs/verbs.h"

namespace coppermoon::verbs {
namespace {

struct Options {
  std::string instant, plot, lookup, wavelengths = "450,550,650", axis_distances;
  LightOptions light;
  std::optional<double> moon_distance_km, sun_distance_km, position_angle_deg;
  bool json = false;
};

std::vector<double> required_list(const std::string& text, const char* what) {
  const auto list = number_list(text);
  if (!list)
    throw algebra::Error(fmt::format("{} = {}, allowed numbers with commas between", what, text));
  return *list;
}

std::vector<double> wavelengths_of(const Options& options) {
  const auto list = required_list(options.wavelengths, "wavelengths [nm]");
  if (list.empty()) throw algebra::Error("wavelengths [nm] = none, allowed one or more");
  return list;
}

/// The ratio and its standard error over (axis distance, wavelength), direct light included.
struct Across {
  std::vector<double> wavelengths_nm;
  std::vector<double> axis_distances_m;
  algebra::Grid<double> ratio, standard_error;
};

/// Where the shadow is cut: how far behind the Earth, under what Sun.
struct Cut {
  double sun_distance_m, depth_m;
  algebra::Angle sun_declination{};  ///< of an equinox, where no moment is given
  std::optional<almanac::SkyState> sky{};
};

Cut cut_of(const Options& options) {
  if (options.moon_distance_km && options.sun_distance_km)
    if (options.instant.empty())
      return {*options.sun_distance_km * 1e3, *options.moon_distance_km * 1e3};
  if (options.instant.empty())
    throw WrongUsage("instant, or both --moon-distance-km and --sun-distance-km is required");
  const auto sky = almanac::sky_at(almanac::instant_from_utc(options.instant));
  const auto axis = eclipse::shadow_axis(sky);
  const double depth_km = algebra::in_kilometres(eclipse::place_in_shadow(axis, sky.moon_m).depth);
  if (!options.moon_distance_km && depth_km <= 0)
    throw algebra::Error(
        fmt::format("at {} the Moon is on the Sun's side of the Earth; --moon-distance-km says how "
                    "far the shadow is cut",
                    options.instant));
  return {options.sun_distance_km.value_or(algebra::in_kilometres(axis.sun_distance)) * 1e3,
          options.moon_distance_km.value_or(depth_km) * 1e3, axis.sun_declination, sky};
}

std::vector<double> distances_of(const Options& options, const atmosphere::Atmosphere& air,
                                 const shadow::Arrangement& arrangement) {
  std::vector<double> distances;
  for (const double km : required_list(options.axis_distances, "axis distances [km]")) {
    algebra::require_within("axis distance [km]", km, 0, 1e5);
    if (!distances.empty() && km * 1e3 <= distances.back())
      throw algebra::Error(
          fmt::format("axis distance [km] = {:g}, allowed above {:g}, the one before", km,
                      distances.back() / 1e3));
    distances.push_back(km * 1e3);
  }
  if (!distances.empty()) return distances;
  constexpr double spacing_m = 100e3;
  const double reach = shadow::refracted_reach_m(arrangement, air, arrangement.depths_m[0]);
  for (double d = 0; d < reach + spacing_m; d += spacing_m) distances.push_back(d);
  return distances;
}

/// A solver's values at other distances: straight lines, nothing beyond the last.
algebra::Grid<double> at_distances(const shadow::RefractedLight& light,
                                   const algebra::Grid<double>& values,
                                   const std::vector<double>& distances_m) {
  algebra::Grid<double> there(distances_m.size(), values.columns());
  std::vector<double> column(values.rows());
  for (std::size_t w = 0; w < values.columns(); ++w) {
    for (std::size_t d = 0; d < values.rows(); ++d) column[d] = values(d, w);
    for (std::size_t d = 0; d < distances_m.size(); ++d)
      if (distances_m[d] <= light.axis_distances_m.back())
        there(d, w) = algebra::interpolated(light.axis_distances_m, column, distances_m[d]);
  }
  return there;
}

/// The sectors' mean, or the two nearest to a position angle.
std::vector<double> sector_shares(std::size_t sectors, std::optional<double> position_angle_deg) {
  if (!position_angle_deg) return std::vector<double>(sectors, 1 / static_cast<double>(sectors));
  const double at = *position_angle_deg / 360 * static_cast<double>(sectors);
  const double part = at - std::floor(at);
  const auto first = static_cast<std::size_t>(std::floor(at)) % sectors;
  std::vector<double> shares(sectors);
  shares[first] += 1 - part;
  shares[(first + 1) % sectors] += part;
  return shares;
}

Across across(const Options& options, const atmosphere::Atmosphere& air,
              const shadow::Arrangement& arrangement) {
  Across result{wavelengths_of(options), distances_of(options, air, arrangement), {}, {}};
  const auto& distances = result.axis_distances_m;
  const auto light =
      refracted_light(options.light, air, arrangement, result.wavelengths_nm, distances);
  const shadow::DirectLight direct(air, arrangement, result.wavelengths_nm);
  result.ratio = algebra::Grid<double>(distances.size(), result.wavelengths_nm.size());
  result.standard_error = result.ratio;
  const auto shares = sector_shares(light.sectors, options.position_angle_deg);
  std::vector<double> clear(result.wavelengths_nm.size());
  for (std::size_t s = 0; s < shares.size(); ++s) {
    const double angle =
        2 * std::numbers::pi * static_cast<double>(s) / static_cast<double>(shares.size());
    const auto refracted = at_distances(light, light.ratio[s], distances),
               error = at_distances(light, light.standard_error[s], distances);
    for (std::size_t d = 0; d < distances.size(); ++d) {
      direct.ratios(distances[d], angle, arrangement.depths_m[0], clear);
      for (std::size_t w = 0; w < clear.size(); ++w) {
        result.ratio(d, w) += shares[s] * (refracted(d, w) + clear[w]);
        result.standard_error(d, w) =
            std::hypot(result.standard_error(d, w), shares[s] * error(d, w));
      }
    }
  }
  return result;
}

nlohmann::ordered_json rows_of(const algebra::Grid<double>& grid) {
  auto rows = nlohmann::ordered_json::array();
  for (std::size_t r = 0; r < grid.rows(); ++r)
    rows.push_back(std::vector<double>(grid.row(r).begin(), grid.row(r).end()));
  return rows;
}

std::vector<double> in_kilometres(const std::vector<double>& metres) {
  std::vector<double> kilometres;
  for (const double m : metres) kilometres.push_back(m / 1e3);
  return kilometres;
}

std::string as_csv(const Across& result) {
  std::string text = "axis_distance_km";
  for (const double nm : result.wavelengths_nm)
    text += fmt::format(",irradiance_ratio_{:g}nm,standard_error_{:g}nm", nm, nm);
  text += '\n';
  for (std::size_t d = 0; d < result.axis_distances_m.size(); ++d) {
    text += fmt::format("{:g}", result.axis_distances_m[d] / 1e3);
    for (std::size_t w = 0; w < result.wavelengths_nm.size(); ++w)
      text += fmt::format(",{:.6g},{:.3g}", result.ratio(d, w), result.standard_error(d, w));
    text += '\n';
  }
  return text;
}

std::string plot_script(const Across& result) {
  const std::string table = as_csv(result);
  std::string script = fmt::format(
      "set logscale y\n"
      "set format y '10^{{%L}}'\nset grid\nset key bottom right\n"
      "set xlabel 'distance from the shadow axis [km]'\nset ylabel 'irradiance over sunlight'\n"
      "$data << EOD\n{}EOD\nset datafile separator ','\nplot",
      table.substr(table.find('\n') + 1));
  for (std::size_t w = 0; w < result.wavelengths_nm.size(); ++w)
    script += fmt::format("{} $data using 1:{} with lines linewidth 2 title '{:g} nm'",
                          w == 0 ? "" : ",", 2 * w + 2, result.wavelengths_nm[w]);
  return script + "\n";
}

/// Where no distance is given, the plane stands in the middle of the ground that is lit.
void make_lookup(const Options& options, StripShadow shadow, const std::string& recipe) {
  if (!options.moon_distance_km)
    shadow.arrangement.depths_m[0] -= algebra::in_metres(almanac::lunar_radius) / 2;
  const auto facts = write_shadow_strip(options.lookup, shadow, options.light, recipe);
  if (options.json)
    fmt::print("{}\n", facts.dump(2));
  else
    fmt::print("{}: {} x {} texels, {:.2f} km each, to {:.0f} km from the axis\n", options.lookup,
               facts["columns"].get<int>(), facts["rows"].get<int>(),
               facts["step_km"].get<double>(), facts["end_km"].get<double>());
}

void run(const CLI::App& verb, const Options& options) {
  if (!options.plot.empty()) require_place_for(options.plot);
  const auto start = std::chrono::steady_clock::now();
  const auto cut = cut_of(options);
  const auto air = atmosphere_of(options.light.air, cut.sun_declination);
  const auto arrangement = arrangement_of(options.light, cut.sun_distance_m, {cut.depth_m});
  if (!options.lookup.empty())
    return make_lookup(options, {air, arrangement, cut.sky}, recipe_of(verb));
  const auto result = across(options, air, arrangement);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (!options.plot.empty())
    write_plot(options.plot, "pngcairo size 1000,640", plot_script(result));
  if (!options.json) {
    fmt::print("{}", as_csv(result));
    return;
  }
  const nlohmann::ordered_json all{
      {"moon_distance_km", arrangement.depths_m[0] / 1e3},
      {"sun_distance_km", arrangement.sun_distance_m / 1e3},
      {"solver", options.light.solver == "photons" ? "photons" : "quadrature"},
      {"seconds", seconds},
      {"wavelengths_nm", result.wavelengths_nm},
      {"axis_distance_km", in_kilometres(result.axis_distances_m)},
      {"irradiance_ratio", rows_of(result.ratio)},
      {"standard_error", rows_of(result.standard_error)}};
  fmt::print("{}\n", all.dump(2));
}

}  // namespace

void add_shadow(CLI::App& program) {
  auto* verb =
      add_verb(program, "shadow", "Irradiance across the shadow, over unobstructed sunlight");
  const auto options = std::make_shared<Options>();
  add_flag(*verb, "instant,--instant", options->instant,
           "ISO 8601 UTC, for the distances of that moment");
  add_flag(*verb, "--wavelengths", options->wavelengths, "[nm], 380 to 780, commas between");
  add_flag(*verb, "--axis-distances", options->axis_distances, "[km], increasing, commas between");
  add_flag(*verb, "--moon-distance-km", options->moon_distance_km,
           "from the Earth's centre, along the shadow axis");
  add_flag(*verb, "--sun-distance-km", options->sun_distance_km, "from the Earth's centre");
  add_flag(*verb, "--position-angle", options->position_angle_deg,
           "about the axis, from celestial north through east [degrees]; without: the mean "
           "of all")
      .within(0, 360);
  add_flag(*verb, "--plot", options->plot, "a .png that gnuplot draws").writes_file();
  add_flag(*verb, "--lookup", options->lookup,
           "a strip for shaders instead, .exr or .cube, and a .json beside it: light of "
           "linear Rec.709 over sunlight, by distance from the axis and position angle")
      .writes_file()
      .excludes("--plot");
  add_switch(*verb, "--json", options->json, "one JSON document on stdout");
  add_light_options(*verb, options->light);
  add_recipe_option(*verb);
  on_run(*verb, [verb, options] { run(*verb, *options); });
}

}  // namespace coppermoon::verbs
