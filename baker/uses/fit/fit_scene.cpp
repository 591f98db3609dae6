// SPDX-License-Identifier: MIT
#include "uses/fit/fit_scene.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <numeric>

#include "colour/camera_spectra.h"
#include "colour/display.h"
#include "colour/glow.h"
#include "colour/working_space.h"
#include "eclipse/shadow_axis.h"
#include "eclipse/shadow_cone.h"
#include "povray_scenes/scene_camera.h"
#include "surface/albedo_map.h"
#include "texture/bake.h"
#include "uses/fit/lit_bins.h"
#include "uses/light/moonlight.h"
#include "uses/light/spectral_bands.h"
#include "uses/picture/camera_request.h"
#include "uses/picture/pixels.h"

namespace coppermoon::uses {
namespace {

using Channel = algebra::Grid<float>;
using std::numbers::pi;

constexpr std::size_t texture_rows = 512;

/// Least cosine of the emission angle of ground to be fitted. Nearer the limb, map errors and blur are larger.
constexpr double least_cosine = 0.4;

constexpr std::size_t bin_count = 16;

ViewRequest close_view(ViewRequest view, const almanac::SkyState& sky) {
  const double disc =
      2 * std::asin(algebra::in_metres(almanac::lunar_radius) / glm::length(sky.moon_m));
  view.field_deg = disc / fit_disc_share * 180 / pi;
  view.width = view.height = fit_side_px;
  return view;
}

/// Map of the Moon's ground as the Sun lights it, in white light and without the Earth's shadow.
Channel sunlit_map(const MoonRequest& moon, const FitGroundwork& groundwork,
                   const almanac::SkyState& sky) {
  const auto* ground = groundwork.ground.get();
  const shadow::Lookup whole(shadow::ChannelWeights(ground ? 2 : 1, 1, 1.));
  const auto image =
      texture::bake({groundwork.albedo, sky, whole, ground}, {"Y"}, texture_rows, moon.photometry);
  return channel_of(image, 0);
}

/// The ground that a pixel shows, and its place in the shadow.
struct Ground {
  std::size_t pixel;
  glm::dvec3 ground;
  double cos_emission;
  eclipse::ShadowPlace place;
};

std::vector<Ground> grounds_of(const povray_scenes::SceneCamera& camera,
                               const almanac::SkyState& sky) {
  const auto sight = povray_scenes::sight_of(camera);
  const auto axis = eclipse::shadow_axis(sky);
  std::vector<Ground> grounds;
  for (std::size_t r = 0; r < fit_side_px; ++r)
    for (std::size_t c = 0; c < fit_side_px; ++c) {
      const auto ground = povray_scenes::ground_at(
          sight, {static_cast<double>(c) + 0.5, static_cast<double>(r) + 0.5});
      if (!ground) continue;
      grounds.push_back({r * fit_side_px + c, *ground,
                         glm::dot(*ground, glm::normalize(sight.position - *ground)),
                         eclipse::place_of_ground(axis, sky, *ground)});
    }
  return grounds;
}

/// Projects a map onto a picture. Each pixel gets the map's value at the ground that the pixel shows.
Channel picture_of(const Channel& map, const std::vector<Ground>& grounds) {
  Channel picture(fit_side_px, fit_side_px);
  for (const auto& ground : grounds)
    picture.values()[ground.pixel] =
        static_cast<float>(surface::sampled(map, almanac::selenographic_point(ground.ground)));
  return picture;
}

/// Assigns the pixels well within the limb to bins, which are equal steps of distance from the shadow's axis.
void bin(FitScene& scene, const Channel& sunlit, const std::vector<Ground>& grounds,
         const surface::Ground* by_place) {
  double least = 1e12, most = 0;
  const auto inner = [](const Ground& ground) { return ground.cos_emission >= least_cosine; };
  for (const auto& ground : grounds) {
    if (!inner(ground)) continue;
    least = std::min(least, algebra::in_metres(ground.place.axis_distance));
    most = std::max(most, algebra::in_metres(ground.place.axis_distance));
  }
  scene.bins = bin_count;
  scene.distances_km.assign(bin_count, 0);
  std::vector<double> counts(bin_count);
  for (const auto& [pixel, ground, cos_emission, place] : grounds) {
    const double bright = sunlit.values()[pixel];
    if (cos_emission < least_cosine || bright <= 0) continue;
    const double share = (algebra::in_metres(place.axis_distance) - least) / (most - least);
    const auto step =
        std::min(static_cast<std::size_t>(share * static_cast<double>(bin_count)), bin_count - 1);
    const double colour =
        by_place ? surface::sampled(by_place->colour, almanac::selenographic_point(ground)) : 0;
    scene.grounds.push_back({pixel, ground, bright, colour, step});
    scene.distances_km[step] += algebra::in_kilometres(place.axis_distance);
    ++counts[step];
  }
  for (std::size_t b = 0; b < bin_count; ++b) scene.distances_km[b] /= std::max(1., counts[b]);
}

/// Request for the light that is used to register photographs. This light needs to be accurate only to 5 %.
LightRequest to_register(const LightRequest& light) {
  LightRequest coarse;
  coarse.air = light.air;
  coarse.limb_darkening = light.limb_darkening;
  coarse.scattered_light = light.scattered_light;
  coarse.starlight = light.starlight;
  coarse.wish = {.tolerance = 0.05};
  return coarse;
}

/// X, Y, Z of each pixel that shows ground, in the air assumed before the fit, as seen from space. All ground is moved
/// away from the shadow's axis by `moved_km`.
std::vector<std::array<double, 3>> usual_light(const FitGroundwork& groundwork,
                                               const Channel& sunlit,
                                               const std::vector<Ground>& grounds,
                                               double moved_km = 0) {
  std::vector<std::array<double, 3>> all;
  for (const auto& ground : grounds) {
    auto place = ground.place;
    place.axis_distance = place.axis_distance + algebra::kilometres(moved_km);
    groundwork.usual.read(place, all.emplace_back());
    for (double& value : all.back()) value *= sunlit.values()[ground.pixel];
  }
  return all;
}

algebra::Grid<double> xyz_of_moonlight(const std::optional<std::string>& response,
                                       const std::optional<atmosphere::Sightline>& sightline = {}) {
  return moonlight_weights(colour::channel_weights(colour::WorkingSpace::ciexyz_d65,
                                                   band_edges_nm(), response.value_or("")),
                           sightline);
}

/// Picture of the Moon in linear Rec.709, seen through the air above the observer.
colour::Image moon_in_rgb(const FitScene& scene, const std::optional<std::string>& response,
                          const std::vector<Ground>& grounds,
                          std::span<const std::array<double, 3>> light) {
  const auto here = sunlight_of(scene.weights), in_space = sunlight_of(xyz_of_moonlight(response));
  colour::Image moon(fit_side_px, fit_side_px);
  for (std::size_t i = 0; i < grounds.size(); ++i) {
    const auto rgb = rec709_of(light[i]);
    for (std::size_t k = 0; k < 3; ++k)
      moon.values()[grounds[i].pixel][k] = static_cast<float>(rgb[k] * here[k] / in_space[k]);
  }
  return moon;
}

/// Ratio of a picture's light to the light without the shadow: a grid (bin, channel). Bins are steps of axis distance.
algebra::Grid<double> over_sunlit(const FitScene& scene, const colour::Image& picture) {
  algebra::Grid<double> values(scene.bins, 3);
  std::vector<double> sunlit(scene.bins);
  for (const auto& ground : scene.grounds) {
    sunlit[ground.bin] += ground.sunlit;
    for (std::size_t k = 0; k < 3; ++k) values(ground.bin, k) += picture.values()[ground.pixel][k];
  }
  for (std::size_t b = 0; b < scene.bins; ++b)
    for (double& value : values.row(b)) value = sunlit[b] > 0 ? value / sunlit[b] : 0;
  return values;
}

/// Change of ln(light) per km in each bin and channel. In `moved`, all ground lies `moved_km` farther from the axis.
algebra::Grid<double> slopes_to(const colour::Image& moved, double moved_km,
                                const FitScene& scene) {
  auto slopes = over_sunlit(scene, moved);
  const auto usual = scene.usual_values.values();
  for (std::size_t i = 0; i < usual.size(); ++i)
    slopes.values()[i] = usual[i] > 0 ? std::log(slopes.values()[i] / usual[i]) / moved_km : 0;
  return slopes;
}

/// Weights of bands that give X, Y, Z of moonlight: three rows for the given response, three for the filters of each
/// other known camera, and three for the CIE 1931 observer. Each band has a column.
algebra::Grid<double> through_all_filters(const std::optional<std::string>& response) {
  std::vector<algebra::Grid<double>> all{xyz_of_moonlight(response)};
  auto names = colour::camera_spectra_names();
  names.push_back("colorimetric");
  for (const auto& name : names)
    if (name != response) all.push_back(xyz_of_moonlight(name));
  algebra::Grid<double> weights(3 * all.size(), all.front().columns());
  for (std::size_t i = 0; i < weights.rows(); ++i)
    std::ranges::copy(all[i / 3].row(i % 3), weights.row(i).begin());
  return weights;
}

/// For each other camera, a grid (bin, channel) of ln(light through its filters / light through the assumed response).
std::vector<algebra::Grid<double>> differences_by_filters(const FitScene& scene,
                                                          const shadow::Lookup& by_filters) {
  algebra::Grid<double> sums(scene.bins, by_filters.channels());
  std::vector<double> xyz(by_filters.channels());
  for (const auto& lit : lit_bins(scene, scene.sky).places) {
    by_filters.read(lit.place, xyz);
    for (std::size_t i = 0; i < xyz.size(); ++i) sums(lit.bin, i) += lit.sunlit * xyz[i];
  }
  const auto logarithms = [&](std::size_t bin, std::size_t camera) {
    auto rgb = rec709_of(sums.row(bin).subspan(3 * camera, 3));
    const double least = least_of_brightest * *std::ranges::max_element(rgb);
    for (double& value : rgb) value = std::log(std::max(value, least));
    return rgb;
  };
  std::vector<algebra::Grid<double>> all(by_filters.channels() / 3 - 1,
                                         algebra::Grid<double>(scene.bins, 3));
  for (std::size_t b = 0; b < scene.bins; ++b) {
    const auto own = logarithms(b, 0);
    for (std::size_t camera = 0; camera < all.size(); ++camera) {
      const auto other = logarithms(b, camera + 1);
      for (std::size_t k = 0; k < 3; ++k) all[camera](b, k) = other[k] - own[k];
    }
  }
  return all;
}

}  // namespace

std::array<double, 3> sunlight_of(const algebra::Grid<double>& weights) {
  std::array<double, 3> xyz{};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto row = weights.row(k);
    xyz[k] = std::reduce(row.begin(), row.end());
  }
  return rec709_of(xyz);
}

FitGroundwork groundwork_of(const MoonRequest& moon, std::span<const almanac::SkyState> skies,
                            bool response_assumed) {
  const auto light = to_register(moon.light);
  const auto usual = skies.size() == 1 ? light_on_the_moon(light, skies.front())
                                       : light_on_the_way(light, moon_on_its_way(light, skies));
  auto albedo = normal_albedo(moon);
  auto ground = ground_of(moon, albedo);
  FitGroundwork groundwork{std::move(albedo), std::move(ground),
                           usual.in_channels(xyz_of_moonlight(moon.response))};
  if (response_assumed)
    groundwork.by_filters = usual.in_channels(through_all_filters(moon.response));
  return groundwork;
}

FitScene fit_scene(const MoonRequest& moon, const FitGroundwork& groundwork,
                   const ViewRequest& view, const almanac::SkyState& sky) {
  constexpr double step_km = 2;
  require_eclipse(sky.when);
  const auto seen = view_of(close_view(view, sky), sky);
  FitScene scene;
  scene.sky = sky;
  scene.weights = xyz_of_moonlight(moon.response, seen.sightline);
  scene.pixel_rad = pixel_rad_of(seen.camera);
  const auto grounds = grounds_of(seen.camera, sky);
  const auto sunlit = picture_of(sunlit_map(moon, groundwork, sky), grounds);
  const double middle = fit_side_px / 2.;
  scene.disc = {middle, middle, std::sqrt(static_cast<double>(grounds.size()) / pi)};
  bin(scene, sunlit, grounds, groundwork.ground.get());
  const auto light = usual_light(groundwork, sunlit, grounds);
  scene.usual = Channel(fit_side_px, fit_side_px);
  for (std::size_t i = 0; i < grounds.size(); ++i)
    scene.usual.values()[grounds[i].pixel] = static_cast<float>(light[i][1]);
  scene.moon = moon_in_rgb(scene, moon.response, grounds, light);
  scene.usual_values = over_sunlit(scene, scene.moon);
  const auto moved = usual_light(groundwork, sunlit, grounds, step_km);
  scene.place_slopes = slopes_to(moon_in_rgb(scene, moon.response, grounds, moved), step_km, scene);
  if (groundwork.by_filters)
    scene.by_filters = differences_by_filters(scene, *groundwork.by_filters);
  return scene;
}

colour::Image glow_of(const FitScene& scene) {
  constexpr float share = 0.5;  // any share of glow will do, because it cancels out
  auto glow = colour::with_glow(scene.moon, share, scene.pixel_rad);
  for (std::size_t i = 0; i < glow.values().size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      glow.values()[i][k] = (glow.values()[i][k] - (1 - share) * scene.moon.values()[i][k]) / share;
  return glow;
}

bool lies_in_umbra(const almanac::SkyState& sky) {
  const auto axis = eclipse::shadow_axis(sky);
  const auto moon = eclipse::place_in_shadow(axis, sky.moon_m);
  const auto edge = eclipse::shadow_radii(eclipse::ShadowConvention::danjon, axis, moon).umbra;
  return algebra::in_metres(moon.axis_distance + almanac::lunar_radius) <
         algebra::in_metres(eclipse::axis_distance_at(edge, moon));
}

}  // namespace coppermoon::uses
