// SPDX-License-Identifier: MIT
#include "uses/study/fit_photograph.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <glm/geometric.hpp>
#include <numeric>

#include "algebra/error.h"
#include "eclipse/shadow_axis.h"
#include "povray_scenes/sight.h"
#include "surface/albedo_map.h"
#include "texture/bake.h"
#include "uses/light/spectral_bands.h"
#include "uses/picture/lit_scene.h"
#include "uses/picture/pixels.h"
#include "uses/study/comparison.h"

namespace coppermoon::uses {
namespace {

using Channel = algebra::Grid<float>;

/// The picture that photographs are brought to: its side and the Moon's share of it.
constexpr std::size_t side_px = 320;
constexpr double disc_share = 0.8;
constexpr std::size_t texture_rows = 512;

/// Light is compared where ground is seen less than this cosine from straight on: the map and the
/// limb's blur matter more beyond.
constexpr double least_cosine = 0.4;

constexpr std::size_t most_bins = 16;

ViewRequest close_view(ViewRequest view, const almanac::SkyState& sky) {
  const double disc =
      2 * std::asin(algebra::in_metres(almanac::lunar_radius) / glm::length(sky.moon_m));
  view.field_deg = disc / disc_share * 180 / std::numbers::pi;
  view.width = view.height = side_px;
  return view;
}

/// The texture of the ground without the shadow.
Channel sunlit_map(const MoonRequest& moon, const almanac::SkyState& sky) {
  const shadow::Lookup whole(shadow::ChannelWeights(1, 1, 1.));
  const auto image =
      texture::bake({normal_albedo(moon), sky, whole}, {"Y"}, texture_rows, moon.photometry);
  Channel map(image.height, image.width);
  std::ranges::copy(image.values, map.values().begin());
  return map;
}

/// Ground that a pixel shows, and its place in the shadow.
struct Ground {
  std::size_t pixel;
  almanac::SelenographicPoint point;
  double cos_emission;
  eclipse::ShadowPlace place;
};

std::vector<Ground> grounds_of(const povray_scenes::Camera& camera, const almanac::SkyState& sky) {
  const auto sight = povray_scenes::sight_of(camera);
  const auto axis = eclipse::shadow_axis(sky);
  std::vector<Ground> grounds;
  for (std::size_t r = 0; r < side_px; ++r)
    for (std::size_t c = 0; c < side_px; ++c) {
      const auto ground = povray_scenes::ground_at(
          sight, {static_cast<double>(c) + 0.5, static_cast<double>(r) + 0.5});
      if (!ground) continue;
      grounds.push_back({r * side_px + c, almanac::selenographic_point(*ground),
                         glm::dot(*ground, glm::normalize(sight.position - *ground)),
                         eclipse::place_of_ground(axis, sky, *ground)});
    }
  return grounds;
}

/// Picture in which each pixel is as bright as its ground.
Channel picture_of(const Channel& map, const std::vector<Ground>& grounds) {
  Channel picture(side_px, side_px);
  for (const auto& ground : grounds)
    picture.values()[ground.pixel] = static_cast<float>(surface::sampled(map, ground.point));
  return picture;
}

/// Puts the pixels well within the disc into even steps of axis distance.
void bin(FitScene& scene, const std::vector<Ground>& grounds) {
  double least = 1e12, most = 0;
  const auto inner = [](const Ground& ground) { return ground.cos_emission >= least_cosine; };
  for (const auto& ground : grounds) {
    if (!inner(ground)) continue;
    least = std::min(least, algebra::in_metres(ground.place.axis_distance));
    most = std::max(most, algebra::in_metres(ground.place.axis_distance));
  }
  scene.bins = most_bins;
  for (const auto& ground : grounds) {
    const double sunlit = scene.sunlit.values()[ground.pixel];
    if (!inner(ground) || sunlit <= 0) continue;
    const double share = (algebra::in_metres(ground.place.axis_distance) - least) / (most - least);
    const auto step = static_cast<std::size_t>(share * static_cast<double>(most_bins));
    scene.places.push_back({ground.place, sunlit, std::min(step, most_bins - 1)});
    scene.pixels.push_back(ground.pixel);
  }
}

/// Values of a channel's pixels around the disc.
std::vector<float> around_the_disc(const Channel& channel) {
  const double middle = side_px / 2., radius = disc_share * middle;
  std::vector<float> around;
  for (std::size_t r = 0; r < side_px; ++r)
    for (std::size_t c = 0; c < side_px; ++c) {
      const double away =
          std::hypot(static_cast<double>(r) + 0.5 - middle, static_cast<double>(c) + 0.5 - middle);
      if (away > 1.12 * radius && away < 1.24 * radius) around.push_back(channel(r, c));
    }
  return around;
}

/// Light that the sky adds, and how far it may be off.
struct Sky {
  double light = 0, doubt = 0;
};

/// Where noise is cut off at black nothing is taken off: the sky has at most what is left there.
Sky sky_in(const Channel& light, const Channel& black) {
  constexpr double much = 0.05;
  const auto mean = [](const std::vector<float>& all) {
    return std::reduce(all.begin(), all.end(), 0.) / static_cast<double>(all.size());
  };
  const double around = mean(around_the_disc(light));
  return mean(around_the_disc(black)) > much ? Sky{0, around} : Sky{around, 0};
}

/// The least step of a channel that has 256 values at most: sRGB's near black; else 0.
double step_of(const Channel& channel) {
  std::vector<float> values(channel.values().begin(), channel.values().end());
  std::ranges::sort(values);
  const auto end = std::unique(values.begin(), values.end());
  return end - values.begin() <= 256 ? 1 / 12.92 / 255 : 0;
}

/// One bin's light over its sunlight, and how well that is known.
struct Sum {
  double light = 0, sunlit = 0, residual = 0, black = 0;
  std::size_t pixels = 0, clipped = 0;

  /// Noise that is cut off at black, or light that is at saturation, is none to average over.
  bool sound() const {
    constexpr double few = 0.02;
    const auto all = static_cast<double>(pixels);
    return pixels >= 40 && static_cast<double>(clipped) <= 0.005 * all && black <= few * all;
  }
  double ratio() const { return light / sunlit; }
  /// Neighbouring pixels are in part as wrong as each other.
  double error() const {
    constexpr double alike = 1.5;
    const double variance = residual / static_cast<double>(pixels);
    return std::sqrt(alike * variance * static_cast<double>(pixels)) / sunlit;
  }
};

/// 1 where a channel is black.
Channel black_in(const Channel& light) {
  Channel black(light.rows(), light.columns());
  for (std::size_t i = 0; i < black.values().size(); ++i)
    black.values()[i] = light.values()[i] <= 0 ? 1 : 0;
  return black;
}

/// 1 where any channel is clipped.
Channel clipped_in(const texture::Image& photo) {
  constexpr float saturated = 0.97F;
  Channel clipped(photo.height, photo.width);
  for (std::size_t i = 0; i < clipped.values().size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      if (photo.values[photo.channels.size() * i + k] >= saturated) clipped.values()[i] = 1;
  return clipped;
}

/// A channel in the scene's picture.
struct Brought {
  Channel light, black;
};

std::vector<Sum> sums_of(const FitScene& scene, const Brought& channel, const Channel& clipped,
                         double sky) {
  const auto& light = channel.light;
  std::vector<Sum> sums(scene.bins);
  const auto lit = [&](std::size_t i) { return light.values()[scene.pixels[i]] - sky; };
  for (std::size_t i = 0; i < scene.places.size(); ++i) {
    const auto& [place, sunlit, bin] = scene.places[i];
    auto& sum = sums[bin];
    ++sum.pixels;
    sum.black += channel.black.values()[scene.pixels[i]];
    if (clipped.values()[scene.pixels[i]] > 1e-3F) {
      ++sum.clipped;
      continue;
    }
    sum.light += lit(i);
    sum.sunlit += sunlit;
  }
  for (std::size_t i = 0; i < scene.places.size(); ++i) {
    const auto& [place, sunlit, bin] = scene.places[i];
    auto& sum = sums[bin];
    if (clipped.values()[scene.pixels[i]] > 1e-3F || sum.sunlit == 0) continue;
    sum.residual += std::pow(lit(i) - sum.ratio() * sunlit, 2);
  }
  return sums;
}

/// Light by which the Moon is recognised: 5 % will do.
LightRequest to_recognise(const LightRequest& light) {
  LightRequest coarse;
  coarse.air = light.air;
  coarse.limb_darkening = light.limb_darkening;
  coarse.scattered_light = light.scattered_light;
  coarse.starlight = light.starlight;
  coarse.wish = {.tolerance = 0.05};
  return coarse;
}

}  // namespace

FitScene fit_scene(const MoonRequest& moon, const ViewRequest& view, const almanac::SkyState& sky) {
  require_eclipse(sky.when);
  const auto seen = view_of(close_view(view, sky), sky);
  FitScene scene;
  const auto grounds = grounds_of(seen.camera, sky);
  scene.sunlit = picture_of(sunlit_map(moon, sky), grounds);
  bin(scene, grounds);
  const auto usual =
      light_on_the_moon(to_recognise(moon.light), sky).in_channels(luminance_weights());
  scene.usual = scene.sunlit;
  std::vector<double> luminance(1);
  for (const auto& ground : grounds) {
    usual.read(ground.place, luminance);
    scene.usual.values()[ground.pixel] *= static_cast<float>(luminance[0]);
  }
  const auto xyz = moonlight_weights(
      colour::channel_weights(colour::WorkingSpace::ciexyz_d65, band_edges_nm()), seen.sightline);
  scene.light.emplace(moon.light, sky, xyz, scene.places, scene.bins);
  return scene;
}

namespace {

/// A photograph whose noise hides the limb is looked at from further away.
colour::Registration registration_of(const texture::Image& photo, const Channel& usual) {
  const auto luminance = luminance_of(photo);
  std::exception_ptr of_itself;
  for (double size = 1;; size /= 2) {
    const colour::Similarity smaller{.scale = size};
    const auto extent = [&](std::size_t pixels) {
      return static_cast<std::size_t>(static_cast<double>(pixels) * size);
    };
    try {
      auto found = colour::registered(
          size == 1
              ? luminance
              : colour::resampled(luminance, smaller, extent(photo.height), extent(photo.width)),
          usual);
      found.render_to_photo = colour::composed(found.render_to_photo, colour::inverse(smaller));
      return found;
    } catch (const algebra::Error&) {
      if (!of_itself) of_itself = std::current_exception();
      if (size <= 0.25) std::rethrow_exception(of_itself);
    }
  }
}

}  // namespace

BinnedPhotograph binned(const FitScene& scene, const texture::Image& photo) {
  constexpr double least_steps = 6, of_a_step = 0.3, least_skies = 5;
  BinnedPhotograph result{algebra::Grid<double>(scene.bins, 3),
                          algebra::Grid<double>(scene.bins, 3),
                          registration_of(photo, scene.usual)};
  const auto back = colour::inverse(result.registration.render_to_photo);
  const auto brought = [&](const Channel& channel) {
    return colour::resampled(channel, back, side_px, side_px);
  };
  const auto clipped = brought(clipped_in(photo));
  for (std::size_t k = 0; k < 3; ++k) {
    const auto channel = channel_of(photo, k);
    const Brought there{brought(channel), brought(black_in(channel))};
    const double step = step_of(channel);
    const auto sky = sky_in(there.light, there.black);
    const auto sums = sums_of(scene, there, clipped, sky.light);
    for (std::size_t b = 0; b < scene.bins; ++b) {
      const auto& sum = sums[b];
      const double mean = sum.light / static_cast<double>(std::max<std::size_t>(1, sum.pixels));
      if (!sum.sound() || mean <= least_steps * step || mean <= least_skies * sky.doubt) continue;
      result.values(b, k) = sum.ratio();
      result.errors(b, k) =
          std::hypot(sum.error(), std::hypot(of_a_step * step, sky.doubt) / mean * sum.ratio());
    }
  }
  return result;
}

}  // namespace coppermoon::uses
