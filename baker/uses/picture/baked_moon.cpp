// SPDX-License-Identifier: MIT
#include "uses/picture/baked_moon.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <iterator>
#include <numeric>
#include <span>
#include <utility>

#include "algebra/error.h"
#include "files/name_to_share.h"
#include "uses/light/header.h"
#include "uses/light/photometer.h"
#include "uses/light/spectral_bands.h"
#include "uses/picture/texture_recipe.h"

namespace coppermoon::uses {
namespace {

using shadow::LightPart;
using texture::TexelQuantity;

std::vector<std::string> channel_names(colour::WorkingSpace space) {
  if (space == colour::WorkingSpace::ciexyz_d65) return {"X", "Y", "Z"};
  return {"R", "G", "B"};
}

/// Header attributes for placing a camera in front of the globe: sub-observer point, tilt of the axis, and distance.
texture::Attributes attitude(const LitMoon& moon) {
  const auto& sky = moon.sky;
  auto middle = sky.sub_earth;
  auto axis = sky.axis_position_angle;
  double distance_m = glm::length(sky.moon_m);
  texture::Attributes attributes;
  const auto put = [&](const char* name, double value) {
    attributes[std::string("coppermoon:") + name] = static_cast<float>(value);
  };
  if (moon.observer) {
    const auto view = almanac::view_from(*moon.observer, sky);
    const auto pole = glm::row(sky.selenographic_from_gcrs, 2);
    middle = view.sub_observer;
    axis = almanac::position_angle(sky.moon_m - view.position_m, pole, view.north);
    distance_m = algebra::in_metres(view.moon_distance);
    put("parallactic_angle", algebra::in_degrees(view.parallactic_angle));
    attributes["latitude"] = static_cast<float>(algebra::in_degrees(moon.observer->latitude));
    attributes["longitude"] = static_cast<float>(algebra::in_degrees(moon.observer->longitude));
    attributes["altitude"] = static_cast<float>(algebra::in_metres(moon.observer->elevation));
  }
  put("sub_observer_latitude", algebra::in_degrees(middle.latitude));
  put("sub_observer_longitude", algebra::in_degrees(middle.longitude));
  put("axis_position_angle", algebra::in_degrees(axis));
  put("distance_km", distance_m / 1e3);
  return attributes;
}

texture::Attributes header(const LitMoon& moon, const TextureContent& content,
                           const Baking& baking) {
  auto attributes = scene_linear_header(space_of(content), moon.sky.when);
  attributes["coppermoon:albedo_map"] = files::name_to_share(moon.request.albedo_map);
  attributes["coppermoon:relative_error"] = static_cast<float>(moon.light->error_found);
  attributes["coppermoon:recipe"] =
      baking.recipe ? baking.recipe(moon, content) : texture_recipe(moon, content);
  attributes.merge(attitude(moon));
  if (content.spectral_nm) {
    attributes["spectralLayoutVersion"] = std::string("1.0");
    attributes["emissiveUnits"] = std::string("W.m^-2.sr^-1");
  }
  return attributes;
}

constexpr std::size_t colour_count = 3;

/// A spectral band of a texel, computed as a weighted sum of the values that are looked up for the texel.
struct Band {
  std::size_t first = 0;
  std::vector<float> shares;
};

/// The channels in one part of a texture file, and the weights by which they are computed from the light's spectrum.
struct Channels {
  std::vector<std::string> names;
  algebra::Grid<double> weights;  // a row for each looked-up value, a column for each wavelength
  LightPart light = LightPart::all;
  std::vector<Band> bands = {};  // spectral channels, stored after the colour channels
};

/// Stacks two matrices, one below the other.
algebra::Grid<double> stacked(const algebra::Grid<double>& upper,
                              const algebra::Grid<double>& lower) {
  algebra::Grid<double> both(upper.rows() + lower.rows(), upper.columns());
  for (std::size_t r = 0; r < both.rows(); ++r)
    std::ranges::copy(r < upper.rows() ? upper.row(r) : lower.row(r - upper.rows()),
                      both.row(r).begin());
  return both;
}

algebra::Grid<double> each_by_itself(std::size_t count) {
  algebra::Grid<double> identity(count, count);
  for (std::size_t i = 0; i < count; ++i) identity(i, i) = 1;
  return identity;
}

std::vector<Band> bands_of(const algebra::Grid<double>& shares) {
  std::vector<Band> bands;
  for (std::size_t b = 0; b < shares.rows(); ++b) {
    const auto all = shares.row(b);
    const auto some = [](double share) { return share != 0; };
    const auto first = std::ranges::find_if(all, some);
    const auto end = std::find_if(all.rbegin(), std::make_reverse_iterator(first), some).base();
    bands.push_back({static_cast<std::size_t>(first - all.begin()), {first, end}});
  }
  return bands;
}

constexpr double spectrum_nm = 400;

/// Adds spectral channels named after their middle wavelengths, such as "S0.385,000000nm". If there are fewer simulated
/// wavelengths than bands, light is looked up by wavelength. With bands of 1 nm, this takes 95 % less memory.
Channels with_spectrum(Channels channels, double width_nm, int wavelengths,
                       const std::optional<atmosphere::Sightline>& sightline) {
  const auto edges = band_edges_nm();
  const auto count = static_cast<std::size_t>(std::lround(spectrum_nm / width_nm));
  const std::size_t bands = edges.size() - 1, each = bands / count;
  algebra::Grid<double> means(count, bands);
  for (std::size_t b = 0; b < each * count; ++b) means(b / each, b) = 1 / width_nm;
  const auto shares = at_wavelengths(moonlight_weights(means, sightline), wavelengths);
  const bool by_wavelength = shares.columns() < count;
  channels.weights =
      stacked(channels.weights, by_wavelength ? each_by_itself(shares.columns()) : shares);
  channels.bands = bands_of(by_wavelength ? shares : each_by_itself(count));
  for (std::size_t i = 0; i < count; ++i) {
    auto name = fmt::format("S0.{:.6f}nm", edges[i * each] + width_nm / 2);
    name[name.find('.', 3)] = ',';
    channels.names.push_back(name);
  }
  return channels;
}

/// Fills a texel: copies its three colours, computes its spectral bands, and sets negative bands to 0.
void write_bands(std::span<const Band> bands, std::span<const float> looked_up,
                 std::span<float> texel) {
  std::ranges::copy(looked_up.first(colour_count), texel.begin());
  for (std::size_t b = 0; b < bands.size(); ++b) {
    const auto light = looked_up.subspan(colour_count + bands[b].first);
    const auto& shares = bands[b].shares;
    texel[colour_count + b] =
        std::max(0.F, std::inner_product(shares.begin(), shares.end(), light.begin(), 0.F));
  }
}

texture::Rows with_bands(texture::Rows lit, std::size_t looked_up, std::vector<Band> bands) {
  return [lit = std::move(lit), looked_up, bands = std::move(bands)](std::size_t row,
                                                                     std::span<float> values) {
    const std::size_t channels = colour_count + bands.size(), texels = values.size() / channels;
    std::vector<float> light(texels * looked_up);
    lit(row, light);
    tbb::parallel_for(std::size_t{0}, texels, [&](std::size_t t) {
      write_bands(bands, std::span(light).subspan(t * looked_up, looked_up),
                  values.subspan(t * channels, channels));
    });
  };
}

shadow::Lookup light_in(const LitMoon& moon, const Channels& channels, colour::WorkingSpace space) {
  const auto weights = of_ground(moon.ground.get(), channels.weights,
                                 wavelengths_nm(static_cast<int>(channels.weights.columns())));
  auto light = moon.within ? moon.light->in_sums(weights, *moon.within, channels.light)
                           : shadow::Lookup(weights, channels.light);
  light.transform([&](auto values) {
    for (std::size_t first = 0; first < values.size(); first += channels.weights.rows())
      into_gamut_or_black(space, values.subspan(first, colour_count));
  });
  return light;
}

/// The data from which the rows of a texture part are computed. It stays in memory as long as rows may be requested.
struct LitGround {
  std::shared_ptr<const algebra::Grid<float>> albedo;
  std::shared_ptr<const surface::Ground> ground;
  shadow::Lookup light;
};

/// The quantity stored in a texture part, and the colours of sunlit ground, if any, by which the light is divided.
struct Held {
  TexelQuantity quantity;
  std::vector<double> sunlit = {};
};

texture::Part part(const LitMoon& moon, const std::string& name, const Channels& channels,
                   shadow::Lookup light, const Held& held, const Baking& baking) {
  const std::size_t width = texture_width_of(moon.request), rows = width / 2,
                    looked_up = light.channels() / (moon.ground ? 2 : 1);
  const std::shared_ptr<LitGround> ground(
      new LitGround{moon.albedo, moon.ground, std::move(light)});
  auto lit = texture::lit_rows(
      {*ground->albedo, moon.sky, ground->light, ground->ground.get()}, rows,
      {moon.request.photometry, baking.extent, held.quantity, held.sunlit}, baking.progress);
  const texture::Rows kept = [ground, lit](std::size_t row, std::span<float> values) {
    lit(row, values);
  };
  return {name,
          {width, rows, channels.names},
          channels.bands.empty() ? kept : with_bands(kept, looked_up, channels.bands)};
}

/// Brightness of sunlit lunar ground relative to sunlit white ground in each colour channel, for the mean Moon. If the
/// ground varies in colour, returns all channels for the reddest ground, then all channels for the bluest.
std::vector<double> ground_colours(const LitMoon& moon, const algebra::Grid<double>& of_moon,
                                   const algebra::Grid<double>& of_white) {
  const auto seen = of_ground(moon.ground.get(), of_moon, band_centres_nm());
  std::vector<double> colours_of_grounds;
  for (std::size_t c = 0; c < seen.rows(); ++c) {
    const auto ground = seen.row(c), white = of_white.row(c % of_white.rows());
    colours_of_grounds.push_back(std::reduce(ground.begin(), ground.end()) /
                                 std::reduce(white.begin(), white.end()));
  }
  return colours_of_grounds;
}

texture::Part albedo_part(const LitMoon& moon) {
  const std::size_t width = texture_width_of(moon.request);
  auto rows = texture::albedo_rows(*moon.albedo, width / 2);
  return {
      "albedo",
      {width, width / 2, {"Y"}},
      [kept = moon.albedo, rows](std::size_t row, std::span<float> values) { rows(row, values); }};
}

}  // namespace

void require_sound(const TextureContent& content) {
  const double width = content.spectral_nm.value_or(1);
  algebra::require_within("spectral band [nm]", width, 1, 100);
  if (std::fmod(spectrum_nm, width) != 0 || std::floor(width) != width)
    throw algebra::Error(fmt::format(
        "spectral band [nm] = {:g}, allowed whole numbers that go into 400 evenly, as 10", width));
}

colour::WorkingSpace space_of(const TextureContent& content) {
  return content.space.value_or(colour::WorkingSpace::linear_rec709);
}

texture::ExrType type_of(const TextureContent& content) {
  return content.type.value_or(content.spectral_nm ? texture::ExrType::floating
                                                   : texture::ExrType::half);
}

LitMoon lit_moon(const MoonRequest& request, const almanac::SkyState& sky,
                 const algebra::Progress& progress) {
  require_map(request);
  const std::size_t width = texture_width_of(request);
  const Purpose purpose{static_cast<double>(width * (width / 2)), reads_map(request)};
  std::shared_ptr<const algebra::Grid<float>> albedo;
  std::shared_ptr<const surface::Ground> ground;
  std::shared_ptr<const Moonlight> light;
  // The map and the light are computed at the same time. An error in one must not cancel the parallel loops of the
  // other, because the code after such a loop would continue with incomplete results.
  tbb::task_group together;
  std::exception_ptr of_map, of_light;
  const auto kept = [](std::exception_ptr& error, const auto& work) {
    try {
      work();
    } catch (...) {
      error = std::current_exception();
    }
  };
  together.run([&] {
    kept(of_map, [&] {
      albedo = std::make_shared<const algebra::Grid<float>>(normal_albedo(request));
      ground = ground_of(request, *albedo);
    });
  });
  together.run_and_wait([&] {
    kept(of_light, [&] {
      light = std::make_shared<const Moonlight>(
          request.unshadowed ? unshadowed_light(request.light, sky)
                             : light_on_the_moon(request.light, sky, purpose, progress));
    });
  });
  for (const auto& error : {of_light, of_map})
    if (error) std::rethrow_exception(error);
  return {request, sky, albedo, ground, light, light->range};
}

BakedMoon baked(const LitMoon& moon, const TextureContent& content, const Baking& baking) {
  const auto space = space_of(content);
  const auto names = channel_names(space);
  const auto response =
      colour::channel_weights(space, band_edges_nm(), moon.request.response.value_or(""));
  const auto of_moon = moonlight_weights(response, moon.sightline);
  const int wavelengths = moon.light->plan.work.bands;
  BakedMoon made{{}, header(moon, content, baking)};
  const auto add = [&](const std::string& name, const Channels& channels, shadow::Lookup light,
                       const Held& held) {
    made.parts.push_back(part(moon, name, channels, std::move(light), held, baking));
  };
  using enum TexelQuantity;
  const Channels colour{names, at_wavelengths(of_moon, wavelengths)};
  const auto whole = content.spectral_nm
                         ? with_spectrum(colour, *content.spectral_nm, wavelengths, moon.sightline)
                         : colour;
  add(content.passes ? "lit" : "", whole, light_in(moon, whole, space), {luminance});
  if (!content.passes) return made;
  for (const auto& [name, light] :
       {std::pair{"direct", LightPart::direct}, {"refracted", LightPart::refracted}}) {
    const Channels channels{names, colour.weights, light};
    add(name, channels, light_in(moon, channels, space), {luminance});
  }
  const auto grounds =
      ground_colours(moon, of_moon, white_ground_weights(response, moon.sightline));
  add("irradiance", colour, light_in(moon, colour, space), {irradiance, grounds});
  algebra::Grid<double> sunlit(grounds.size(), 1);
  std::ranges::copy(grounds, sunlit.values().begin());
  add("reflectance", colour, shadow::Lookup(sunlit), {reflectance});
  made.parts.push_back(albedo_part(moon));
  for (auto& share : std::span(made.parts).last(2)) {  // reflectance and albedo are pure ratios
    share.left_out = {"whiteLuminance", "coppermoon:unit", "chromaticities"};
    share.own = {{"colorInteropID", std::string("data")}};
  }
  return made;
}

std::array<double, 3> illuminance_seen(LitMoon moon, colour::WorkingSpace space) {
  constexpr std::size_t rows = 360;
  moon.request.texture_width = std::min(2 * rows, texture_width_of(moon.request));
  const auto texture = baked(moon, {.space = space}, {texture::Extent::seen_from_earth, {}});
  const auto& part = texture.parts.front();
  texture::Image image(part.layout.width, part.layout.height, part.layout.channels);
  part.rows(0, image.values);
  const auto from =
      moon.observer ? almanac::view_from(*moon.observer, moon.sky).position_m : glm::dvec3(0, 0, 0);
  const auto lux = irradiance_of_disc(image, moon.sky, from);
  return {lux[0], lux[1], lux[2]};
}

}  // namespace coppermoon::uses
