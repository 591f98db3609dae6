// SPDX-License-Identifier: MIT
#include "uses/explore/exploration.h"

#include <fmt/format.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>
#include <set>
#include <span>
#include <vector>

#include "algebra/error.h"
#include "almanac/gazetteer.h"
#include "atmosphere/astronomical_refraction.h"
#include "colour/display.h"
#include "colour/exposure.h"
#include "photons/limb_darkening.h"
#include "photons/solar_disc.h"
#include "surface/ground.h"
#include "texture/bake.h"
#include "uses/explore/limb_rays.h"
#include "uses/explore/motion.h"
#include "uses/light/danjon_air.h"
#include "uses/light/header.h"
#include "uses/light/photometer.h"
#include "uses/light/spectral_bands.h"
#include "uses/picture/clear_sky.h"
#include "uses/picture/local_time.h"
#include "uses/picture/view.h"

namespace coppermoon::uses {
namespace {

using nlohmann::ordered_json;

/// Number of wavelengths with which the page computes light, and of terms for the Sun's brightness across its disc.
constexpr int bands = 40, sun_terms = 3;

/// Time that the page covers before the first contact and after the last [s].
constexpr double margin_s = 600;

constexpr std::size_t map_rows = 1024;
/// Largest lunar longitude that libration can bring into view [degrees].
constexpr double seen_longitude = 99;

constexpr std::size_t cities = 1500;
constexpr double least_feature_km = 60;

std::vector<std::string> views_shown() {
  auto views = colour::views();
  std::erase_if(views, [](const auto& view) { return view == "Raw" || view == "Log"; });
  return views;
}

/// Milliseconds since 1970 as counted by JavaScript's Date, which ignores leap seconds.
double unix_ms(const almanac::Instant& when) {
  const auto text = almanac::utc_text(when, 3);
  const auto date = text.substr(0, text.find('T'));
  int year = 0;
  unsigned month = 0, day = 0;
  std::sscanf(date.c_str(), "%d-%u-%u", &year, &month, &day);
  const std::chrono::sys_days midnight =
      std::chrono::year{year} / std::chrono::month{month} / std::chrono::day{day};
  return static_cast<double>(midnight.time_since_epoch().count()) * 86400e3 +
         almanac::seconds_between(almanac::instant_from_utc(date), when) * 1e3;
}

/// Opposition surge that is coded as 255 in the ground map. Its negative is coded as 0.
constexpr double widest_surge = 0.8;
constexpr std::size_t ground_rows = 180, ground_columns = 198;

/// Adds maps of the visible ground's colour and opposition surge, each coded in 256 equal steps.
ordered_json add_ground(PageArrays& arrays, const surface::Ground* ground) {
  constexpr std::size_t columns = 2 * ground_rows, first = (columns - ground_columns) / 2;
  std::vector<std::uint8_t> coded;
  const auto add = [&](double value, double widest) {
    const double step = 127.5 * (1 + std::clamp(value / widest, -1., 1.));
    coded.push_back(static_cast<std::uint8_t>(std::lround(step)));
  };
  std::vector<float> colour(columns * ground_rows), surge(colour.size());
  if (ground != nullptr) {
    texture::albedo_rows(ground->colour, ground_rows)(0, colour);
    texture::albedo_rows(ground->surge, ground_rows)(0, surge);
  }
  for (std::size_t r = 0; r < ground_rows; ++r)
    for (std::size_t c = first; c < first + ground_columns; ++c) {
      add(colour[r * columns + c], surface::strongest_colour);
      add(surge[r * columns + c], widest_surge);
    }
  arrays.add("ground", {ground_rows, ground_columns, 2}, coded);
  return {{"surge", widest_surge},
          {"firstLongitude", -180. + static_cast<double>(first)},
          {"longitudes", ground_columns}};
}

/// Adds the visible ground's albedo map, coded in 256 logarithmic steps.
ordered_json add_map(PageArrays& arrays, const MoonRequest& request) {
  const auto albedo = normal_albedo(request);
  const auto ground = ground_of(request, albedo);
  const auto rows = texture::albedo_rows(albedo, map_rows);
  constexpr std::size_t columns = 2 * map_rows;
  std::vector<float> map(columns * map_rows);
  rows(0, map);
  const auto first = static_cast<std::size_t>((180 - seen_longitude) / 360 * columns);
  const std::size_t width = columns - 2 * first;
  constexpr float darkest = 0.005F;
  std::vector<float> seen;
  for (std::size_t r = 0; r < map_rows; ++r)
    for (std::size_t c = 0; c < width; ++c)
      seen.push_back(std::max(darkest, map[r * columns + first + c]));
  const auto [least, most] = std::ranges::minmax(seen);
  const double low = std::log(least), range = std::max(1e-6, std::log(most) - low);
  std::vector<std::uint8_t> coded;
  for (const float value : seen)
    coded.push_back(static_cast<std::uint8_t>(std::lround(255 * (std::log(value) - low) / range)));
  arrays.add("map", {map_rows, width}, coded);
  return {{"logLow", low},
          {"logRange", range},
          {"ground", add_ground(arrays, ground.get())},
          {"firstLongitude", -180 + 360. * static_cast<double>(first) / columns},
          {"longitudes", 360. * static_cast<double>(width) / columns}};
}

/// Adds the brightness across the Sun's disc, and the weights of the wavelengths in the channels red, green, blue and
/// V. There are two sets of weights, one for the Moon's reddest ground and one for its bluest.
ordered_json add_sunlight(PageArrays& arrays, bool limb_darkening,
                          const std::vector<double>& wavelengths) {
  const auto terms = photons::disc_terms(wavelengths, limb_darkening, sun_terms);
  std::vector<double> functions;
  for (const auto& function : terms.functions)
    functions.insert(functions.end(), function.begin(), function.end());
  arrays.add("sun.terms", {terms.functions.size(), 6}, functions);
  arrays.add("sun.brightness", terms.brightness);
  const auto layers = photons::disc_layers(wavelengths, limb_darkening);
  arrays.add("sun.layers", {layers.radius.size()}, layers.radius);
  arrays.add("sun.layerBrightness", layers.brightness);
  const auto colours = at_wavelengths(
      moonlight_weights(colour::channel_weights(picture_space, band_edges_nm())), bands);
  const auto meter = photometer();
  const auto magnitudes = at_wavelengths(meter.weights, bands);
  algebra::Grid<double> weights(4, wavelengths.size());
  for (std::size_t c = 0; c < weights.rows(); ++c)
    std::ranges::copy(c < colours.rows() ? colours.row(c) : magnitudes.row(V_band),
                      weights.row(c).begin());
  arrays.add("weights", reddest_and_bluest(weights, wavelengths));
  return {{"radiusKm", photons::solar_radius_m / 1e3},
          {"auKm", almanac::astronomical_unit_m / 1e3},
          {"V", photometric_bands()[V_band].solar_magnitude},
          {"VAt1au", meter.sunlight[V_band]}};
}

/// Adds the vertical optical depths of molecules, ozone and aerosol above sea level in the observer's default air.
void add_observer_air(PageArrays& arrays, const std::vector<double>& wavelengths) {
  const ViewRequest usual;
  const atmosphere::ObserverAir air{.ozone_du = usual.observer_ozone_du,
                                    .aerosol_optical_depth = usual.observer_aerosol};
  algebra::Grid<double> depths(3, wavelengths.size());
  for (std::size_t w = 0; w < wavelengths.size(); ++w) {
    const auto at = atmosphere::vertical_depths(air, algebra::nanometres(wavelengths[w]));
    depths(0, w) = at.rayleigh;
    depths(1, w) = at.ozone;
    depths(2, w) = at.aerosol;
  }
  arrays.add("observer.depths", depths);
}

/// Adds tables of the clear sky's light around the Moon [log2 cd/m², linear Rec.709] for observers at two elevations.
/// The light without moonlight is tabulated by the Sun's altitude and by the Moon's altitude above the antisolar point.
/// Airglow on a dark night and scattered moonlight are tabulated by the square root of the Moon's altitude. All
/// altitudes are without refraction.
///
/// Returned  first value and step of each variable of the tables [degrees]
ordered_json add_sky(PageArrays& arrays, almanac::SkyState sky) {
  constexpr std::array elevations_km{0., 4.};
  constexpr std::size_t sun_nodes = 45, beside_nodes = 5, up_nodes = 20;
  constexpr double lowest_sun = -20, sun_step = 0.5, lowest_beside = -2.5, beside_step = 1.25,
                   up_step = 0.5, moon_V = -12.7;
  std::vector<double> dark, airglow, moonlit;
  const auto add = [](std::vector<double>& logs, const Rgb& light, const Rgb& without = {}) {
    for (std::size_t k = 0; k < light.size(); ++k)
      logs.push_back(std::log2(std::max(1e-9, light[k] - without[k])));
  };
  for (const double km : elevations_km) {
    const almanac::Observer place{{}, {}, algebra::kilometres(km)};
    const auto stand = almanac::view_from(place, sky);
    const auto air = air_over(place, {});
    // light of the sky around the Moon, with the Sun in the north and the Moon in the south
    const auto sky_over = [&](double sun_deg, double moon_deg, double V) {
      const auto put = [&](double distance_m, double altitude_deg, double to_north) {
        const double altitude = algebra::in_radians(algebra::degrees(altitude_deg));
        return stand.position_m + distance_m * (std::cos(altitude) * to_north * stand.north +
                                                std::sin(altitude) * stand.zenith);
      };
      sky.sun_m = put(almanac::astronomical_unit_m, sun_deg, 1);
      sky.moon_m = put(384.4e6, moon_deg, -1);
      const auto seen = atmosphere::apparent_altitude(algebra::degrees(moon_deg));
      return ClearSky(place, sky, air, V).light(in_sky(seen, algebra::degrees(180)));
    };
    constexpr double none = std::numeric_limits<double>::infinity(), night = -40;
    for (std::size_t i = 0; i < sun_nodes; ++i)
      for (std::size_t j = 0; j < beside_nodes; ++j) {
        const double sun = lowest_sun + sun_step * double(i);
        add(dark, sky_over(sun, lowest_beside + beside_step * double(j) - sun, none));
      }
    for (std::size_t i = 0; i < up_nodes; ++i) {
      const double moon = std::min(90., up_step * up_step * double(i * i));
      const auto without = sky_over(night, moon, none);
      add(airglow, without);
      add(moonlit, sky_over(night, moon, moon_V), without);
    }
  }
  const auto places = elevations_km.size();
  arrays.add("sky.dark", {places, sun_nodes, beside_nodes, 3}, dark);
  arrays.add("sky.airglow", {places, up_nodes, 3}, airglow);
  arrays.add("sky.moonlit", {places, up_nodes, 3}, moonlit);
  return {{"elevations", elevations_km},
          {"sun", {lowest_sun, sun_step}},
          {"beside", {lowest_beside, beside_step}},
          {"up", {0, up_step}},
          {"moonV", moon_V}};
}

/// Nodes per axis of a display view's table, at equal steps of log2(1 + gain x) / stops from 0 to 1; x: channel value.
constexpr int table_size = 33;
constexpr double table_gain = 1024, table_stops = 17;

/// Adds the table of display colours for one view of the sRGB display.
void add_view(PageArrays& arrays, const std::string& view) {
  const auto level = [](int i) {
    return static_cast<float>((std::exp2(table_stops * i / (table_size - 1.)) - 1) / table_gain);
  };
  colour::Image colours(table_size * table_size, table_size);
  for (int b = 0; b < table_size; ++b)
    for (int g = 0; g < table_size; ++g)
      for (int r = 0; r < table_size; ++r)
        colours(static_cast<std::size_t>(b * table_size + g), static_cast<std::size_t>(r)) = {
            level(r), level(g), level(b)};
  std::vector<std::uint8_t> bytes;
  for (const auto& row = colour::developed(colours, picture_space, {1, view});
       const auto& pixel : row.values())
    for (const float channel : pixel)
      bytes.push_back(static_cast<std::uint8_t>(std::lround(255 * std::clamp(channel, 0.F, 1.F))));
  arrays.add("view." + view, {table_size, table_size, table_size, 3}, bytes);
}

ordered_json photometry_of(surface::Photometry photometry) {
  const auto law = surface::cosine_law(photometry);
  constexpr int steps = 60;
  constexpr double most_degrees = 6;
  ordered_json phase, surge;
  for (int i = 0; i <= steps; ++i) {
    const auto at = algebra::degrees(most_degrees * i / steps);
    phase.push_back(surface::phase_factor(photometry, at));
    surge.push_back(surface::phase_factor(photometry, at) * surface::surge_slope(photometry, at));
  }
  return {{"scale", law.scale},
          {"incidence", law.incidence},
          {"emission", law.emission},
          {"constant", law.constant},
          {"phaseDegrees", most_degrees},
          {"phase", phase},
          {"surge", surge}};
}

void add_names(PageArrays& arrays) {
  std::string text;
  for (const auto& city : almanac::largest_cities(cities))
    text += fmt::format("{}\t{}\t{:.2f}\t{:.2f}\t{:.0f}\t{}\n", city.name, city.region,
                        algebra::in_degrees(city.place.latitude),
                        algebra::in_degrees(city.place.longitude),
                        algebra::in_metres(city.place.elevation), city.time_zone);
  arrays.add("cities", text);
  text.clear();
  for (const auto& feature : almanac::lunar_features())
    if (algebra::in_kilometres(feature.diameter) >= least_feature_km)
      text += fmt::format("{}\t{:.2f}\t{:.2f}\t{:.0f}\n", feature.name,
                          algebra::in_degrees(feature.middle.latitude),
                          algebra::in_degrees(feature.middle.longitude),
                          algebra::in_kilometres(feature.diameter));
  arrays.add("features", text);
}

/// Names of the contacts, and their times [ms since 1970].
ordered_json contacts_in_ms(const eclipse::Eclipse& eclipse) {
  ordered_json all;
  for (const auto& [name, when] : eclipse::contacts_of(eclipse))
    all.push_back({{"name", name}, {"ms", unix_ms(when)}});
  return all;
}

/// Change of cloud and aerosol (`cleared`) for each step of Danjon's scale; empty if the air does not vary by latitude.
ordered_json danjon_steps(const atmosphere::Atmosphere& air, const almanac::SkyState& sky) {
  ordered_json steps = ordered_json::array();
  if (air.belts.empty()) return steps;
  DanjonScale scale(air, sky);
  for (int l = 0; l <= 4; ++l) steps.push_back(scale.clearness(l));
  return steps;
}

/// Abbreviations of the cities' time zones at two moments, such as {"America/Chicago": ["CDT", "CDT"]}.
ordered_json zones_at(const almanac::Instant& from, const almanac::Instant& to) {
  std::set<std::string> names;
  for (const auto& city : almanac::largest_cities(cities)) names.insert(city.time_zone);
  ordered_json zones = ordered_json::object();
  for (const auto& name : names) try {
      zones[name] = {local_time(from, name).abbreviation, local_time(to, name).abbreviation};
    } catch (const algebra::Error&) {  // unknown time zones are left out
    }
  return zones;
}

ordered_json place_of(const ExploreRequest& request) {
  if (!request.observer) return {};
  return {{"name", request.place},
          {"latitude", algebra::in_degrees(request.observer->latitude)},
          {"longitude", algebra::in_degrees(request.observer->longitude)},
          {"elevationKm", algebra::in_kilometres(request.observer->elevation)},
          {"timeZone", request.time_zone}};
}

}  // namespace

Exploration exploration_of(const eclipse::Eclipse& eclipse, const ExploreRequest& request,
                           const algebra::Progress& progress) {
  Exploration made{title(eclipse), {}, {}};
  const auto sky = almanac::sky_at(eclipse.greatest);
  const auto moments = eclipse::contacts_of(eclipse);
  const auto from = almanac::later(moments.front().second, -margin_s),
             to = almanac::later(moments.back().second, margin_s);
  const auto& light = request.moon.light;
  const auto moon = shadowed_moon(light, sky);
  const auto& air = moon.air;
  const auto arrangement = arrangement_of(moon, {algebra::in_metres(moon.centre.depth)});
  const auto wavelengths = wavelengths_nm(bands);
  PageArrays map, scattered;
  ordered_json limb, albedo, motion, danjon;
  auto& arrays = made.arrays;
  tbb::parallel_invoke([&] { albedo = add_map(map, request.moon); },
                       [&] { motion = motion_between(from, to); },
                       [&] { danjon = danjon_steps(air, sky); },
                       [&] { add_scattered_light(scattered, air, arrangement, wavelengths); },
                       [&] { limb = add_limb_rays(arrays, air, wavelengths); });
  if (progress) progress(0.8);
  arrays.append(map);
  arrays.append(scattered);
  const auto sun = add_sunlight(arrays, arrangement.limb_darkening, wavelengths);
  add_observer_air(arrays, wavelengths);
  const auto sky_nodes = add_sky(arrays, sky);
  const auto views = views_shown();
  for (const auto& view : views)
    if (view != "Un-tone-mapped" && view != "Hue-preserving") add_view(arrays, view);
  add_names(arrays);
  made.facts = {{"title", made.title},
                {"version", version()},
                {"greatest", almanac::utc_text(eclipse.greatest)},
                {"umbralMagnitude", eclipse.umbral_magnitude},
                {"penumbralMagnitude", eclipse.penumbral_magnitude},
                {"fromMs", unix_ms(from)},
                {"zones", zones_at(from, to)},
                {"contacts", contacts_in_ms(eclipse)},
                {"motion", motion},
                {"moonRadiusKm", algebra::in_kilometres(almanac::lunar_radius)},
                {"earth",
                 {{"equatorialKm", air.earth.equatorial_radius_m / 1e3},
                  {"polarKm", air.earth.polar_radius_m / 1e3},
                  {"opaqueKm", atmosphere::earth_equatorial_radius_m / 1e3},
                  {"sunDeclination", air.earth.sun_declination_rad}}},
                {"wavelengths", wavelengths},
                {"limb", limb},
                {"sun", sun},
                {"map", albedo},
                {"photometry", photometry_of(request.moon.photometry)},
                {"danjon", danjon},
                {"scatters", scattered_light_of(light) != ScatteredLight::off},
                {"dated", !air.belts.empty()},
                {"haze", air.columns()[0]->tropospheric_optical_depth},
                {"exposureScale", colour::exposure_scale({1, 1, 100})},
                {"views", views},
                {"viewTable", {{"size", table_size}, {"gain", table_gain}, {"stops", table_stops}}},
                {"sky", sky_nodes},
                {"place", place_of(request)},
                {"reddening", ViewRequest{}.reddening},
                {"options", request.options}};
  if (progress) progress(1);
  return made;
}

}  // namespace coppermoon::uses
