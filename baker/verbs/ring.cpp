// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "algebra/error.h"
#include "almanac/instant.h"
#include "colour/working_space.h"
#include "eclipse/shadow_axis.h"
#include "photons/solar_disc.h"
#include "shadow/limb_ring.h"
#include "texture/write_image.h"
#include "verbs/baked_moon.h"
#include "verbs/light_options.h"
#include "verbs/moon_options.h"
#include "verbs/number_list.h"
#include "verbs/pixels.h"
#include "verbs/recipe.h"
#include "verbs/spectral_bands.h"
#include "verbs/verbs.h"

namespace coppermoon::verbs {
namespace {

using algebra::in_degrees;
using std::numbers::pi;

constexpr std::size_t columns = 1440, rows = 256;
constexpr int bands = 40;

struct Options {
  std::string instant, on, output;
  double scale = 1;
  LightOptions light;  ///< of which only the air is asked for
};

almanac::SelenographicPoint place_of(const Options& options, const almanac::SkyState& sky) {
  if (options.on.empty()) return sky.sub_earth;
  const auto numbers = number_list(options.on).value_or(std::vector<double>{});
  if (numbers.size() != 2)
    throw algebra::Error(
        fmt::format("place on the Moon = {}, allowed LATITUDE,LONGITUDE in degrees (north, east), "
                    "as -43.3,-11.2",
                    options.on));
  algebra::require_within("lunar latitude [deg]", numbers[0], -90, 90);
  algebra::require_within("lunar longitude [deg]", numbers[1], -360, 360);
  return {algebra::degrees(numbers[0]), algebra::degrees(numbers[1])};
}

/// Who stands on the Moon and looks at the Earth; GCRS axes.
struct Lookout {
  almanac::SelenographicPoint place;
  glm::dvec3 position_m, zenith, celestial_pole;

  glm::dvec3 earthward() const { return -glm::normalize(position_m); }
  algebra::Angle earth_altitude() const {
    return algebra::radians(std::asin(glm::dot(earthward(), zenith)));
  }
  /// On the sky, about the Earth's centre.
  algebra::Angle position_angle(const glm::dvec3& direction) const {
    return almanac::position_angle(earthward(), direction, celestial_pole);
  }
};

Lookout lookout_at(const almanac::SelenographicPoint& place, const almanac::SkyState& sky) {
  const auto zenith =
      glm::transpose(sky.selenographic_from_gcrs) * almanac::selenographic_direction(place);
  return {place, sky.moon_m + algebra::in_metres(almanac::lunar_radius) * zenith, zenith,
          glm::row(sky.equator_from_gcrs, 2)};
}

void require_earth_in_sight(const Lookout& lookout) {
  const double altitude_deg = in_degrees(lookout.earth_altitude());
  if (altitude_deg > 0) return;
  throw algebra::Error(fmt::format(
      "at {:.2f},{:.2f} on the Moon the Earth stands {:.1f} degrees "
      "below the horizon, allowed above",
      in_degrees(lookout.place.latitude), in_degrees(lookout.place.longitude), -altitude_deg));
}

void require_umbra(const Lookout& lookout, const atmosphere::Atmosphere& air,
                   const shadow::Arrangement& arrangement, const eclipse::ShadowPlace& there) {
  double direct = 1;
  shadow::DirectLight(air, arrangement, std::array{550.})
      .ratios(algebra::in_metres(there.axis_distance), algebra::in_radians(there.position_angle),
              algebra::in_metres(there.depth), {&direct, 1});
  if (direct <= 0) return;
  throw algebra::Error(fmt::format(
      "{:.2g} of the Sun's light comes straight to {:.2f},{:.2f} on the Moon, allowed 0: the ring "
      "is seen from the umbra",
      direct, in_degrees(lookout.place.latitude), in_degrees(lookout.place.longitude)));
}

/// The Sun's mean radiance in the pictures' space [cd/m²], by wavelength, times a scale.
shadow::ChannelWeights sun_weights(double scale) {
  auto weights = white_ground_weights(colour::channel_weights(picture_space, band_edges_nm()));
  const double radii = almanac::astronomical_unit_m / photons::solar_radius_m;
  for (double& weight : weights.values()) weight *= scale * radii * radii;  // of E/π
  return at_wavelengths(weights, bands);
}

/// Angles from the Earth's centre between which the strip lies.
struct Strip {
  double inner_rad, outer_rad;

  double angle(std::size_t row) const {
    return std::lerp(outer_rad, inner_rad, (static_cast<double>(row) + 0.5) / rows);
  }
};

Strip strip_of(const shadow::LimbRing& ring) {
  const auto [lowest, highest] = ring.extent();
  if (!(highest > lowest))
    throw algebra::Error("this air bends no sunlight to that place: the ring is black");
  return {std::asin(lowest / ring.distance_m()), std::asin(highest / ring.distance_m())};
}

/// Given  north_rad  position angle of the shadow frame's Y on the sky, where east is against X
///        weights    of radiance over the Sun's mean, (channel, wavelength)
texture::Image image_of(const shadow::LimbRing& ring, const Strip& strip, double north_rad,
                        const shadow::ChannelWeights& weights) {
  texture::Image image(columns, rows, {"R", "G", "B"});
  tbb::parallel_for(std::size_t{0}, rows, [&](std::size_t row) {
    const double impact_m = ring.distance_m() * std::sin(strip.angle(row));
    std::vector<double> radiance(bands);
    for (std::size_t column = 0; column < columns; ++column) {
      const double angle = 2 * pi * (static_cast<double>(column) + 0.5) / columns;
      ring.radiance(north_rad - angle, impact_m, radiance);
      std::array<double, 3> channels{};
      for (std::size_t c = 0; c < channels.size(); ++c)
        for (std::size_t w = 0; w < radiance.size(); ++w)
          channels[c] += weights(c, w) * radiance[w];
      into_gamut_or_black(picture_space, channels);
      for (std::size_t c = 0; c < channels.size(); ++c)
        image(row, column, c) = static_cast<float>(channels[c]);
    }
  });
  return image;
}

/// How the strip and the Earth stand on the sky, by name; position angles about the Earth's centre,
/// from celestial north, where the Earth's north is, through east.
using Figures = std::vector<std::pair<std::string, double>>;

Figures figures_of(const Lookout& lookout, const glm::dvec3& sun_m, const Strip& strip) {
  return {{"lunar_latitude", in_degrees(lookout.place.latitude)},
          {"lunar_longitude", in_degrees(lookout.place.longitude)},
          {"inner_angle", strip.inner_rad * 180 / pi},
          {"outer_angle", strip.outer_rad * 180 / pi},
          {"earth_distance_km", glm::length(lookout.position_m) / 1e3},
          {"earth_altitude", in_degrees(lookout.earth_altitude())},
          {"earth_north_position_angle", 0},
          {"zenith_position_angle", in_degrees(lookout.position_angle(lookout.zenith))},
          {"sun_position_angle", in_degrees(lookout.position_angle(sun_m - lookout.position_m))}};
}

texture::Attributes header(const almanac::Instant& when, const Figures& figures,
                           const std::string& recipe) {
  const auto xy = colour::chromaticities(picture_space);
  texture::Attributes attributes{
      {"chromaticities", std::vector<float>(xy.begin(), xy.end())},
      {"whiteLuminance", 1.F},
      {"capDate", capture_date(when)},
      {"utcOffset", 0.F},
      {"coppermoon:version", std::string(COPPERMOON_VERSION)},
      {"coppermoon:colour_space", std::string(colour::name(picture_space))},
      {"coppermoon:unit", std::string("cd/m^2")},
      {"coppermoon:recipe", recipe}};
  for (const auto& [name, value] : figures)
    attributes["coppermoon:" + name] = static_cast<float>(value);
  return attributes;
}

void require_sound(const Options& options) {
  if (std::filesystem::path(options.output).extension() != ".exr")
    throw algebra::Error(fmt::format("{}: a ring ends in .exr", options.output));
  require_place_for(options.output);
  algebra::require_within("scale", options.scale, 1e-9, 1e9);
}

void run(const CLI::App& verb, const Options& options) {
  require_sound(options);
  const auto sky = almanac::sky_at(almanac::instant_from_utc(options.instant));
  const auto lookout = lookout_at(place_of(options, sky), sky);
  require_eclipse(sky.when);
  require_earth_in_sight(lookout);
  const auto axis = eclipse::shadow_axis(sky);
  const auto there = eclipse::place_in_shadow(axis, lookout.position_m);
  const auto air = atmosphere_of(options.light.air, axis.sun_declination);
  const auto arrangement = arrangement_of(options.light, algebra::in_metres(axis.sun_distance),
                                          {algebra::in_metres(there.depth)});
  require_umbra(lookout, air, arrangement, there);
  const shadow::LimbRing ring(air, arrangement, there, wavelengths_nm(bands));
  const auto strip = strip_of(ring);
  const auto north = lookout.position_angle(glm::row(axis.shadow_from_gcrs, 1));
  auto figures = figures_of(lookout, sky.sun_m, strip);
  figures.emplace_back("scale", options.scale);
  texture::write_exr(options.output,
                     image_of(ring, strip, algebra::in_radians(north), sun_weights(options.scale)),
                     header(sky.when, figures, recipe_of(verb)), {texture::ExrType::floating});
  for (const auto& [name, value] : figures) fmt::print("{:<30}{:.6f}\n", name, value);
}

}  // namespace

void add_ring(CLI::App& program) {
  auto* verb = add_verb(program, "ring",
                        "The Earth's ring of sunsets, seen from the eclipsed Moon: a strip, cd/m²");
  const auto options = std::make_shared<Options>();
  add_flag(*verb, "instant,--instant", options->instant, "ISO 8601 UTC, as 2008-02-21T03:08:26Z")
      .required();
  add_flag(*verb, "--on", options->on,
           "LAT,LON of a place on the Moon [degrees north, east]; without: where the Earth "
           "stands in the zenith");
  add_flag(*verb, "-o,--output", options->output,
           "an .exr; columns: position angle on the sky about the Earth's centre, from "
           "north through east; rows: even in the angle from it, which the header has for "
           "the outer edge, on top, and the inner")
      .writes_file()
      .required();
  add_flag(*verb, "--scale", options->scale,
           "what cd/m² are multiplied with, 1e-9 to 1e9; POV-Ray reads no more than 65504");
  add_air_options(*verb, options->light.air);
  add_recipe_option(*verb);
  on_run(*verb, [verb, options] { run(*verb, *options); });
}

}  // namespace coppermoon::verbs
