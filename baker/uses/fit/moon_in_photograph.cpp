// SPDX-License-Identifier: MIT
#include "uses/fit/moon_in_photograph.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <numeric>
#include <unordered_set>

#include "algebra/error.h"
#include "almanac/sky.h"
#include "colour/picture_part.h"
#include "uses/compare/comparison.h"
#include "uses/picture/pixels.h"

namespace coppermoon::uses {
namespace {

using Channel = algebra::Grid<float>;

/// Level above which a channel may be clipped. It is lower than all clipping levels used in binning.
constexpr float nearly_clipped = 0.84F;

/// Quantisation step near black of channel `k`, in linear light; 0 if the channel has more than 8 bits.
double step_of(const texture::Image& photo, std::size_t k) {
  constexpr std::size_t most = 256;
  std::unordered_set<float> values{photo(0, 0, k)};
  float last = photo(0, 0, k);
  for (std::size_t r = 0; r < photo.height; ++r)
    for (std::size_t c = 0; c < photo.width; ++c)
      if (const float value = photo(r, c, k); value != last) {
        values.insert(last = value);
        if (values.size() > most) return 0;
      }
  return 1 / 12.92 / 255;
}

/// Value of the pixel that replaces a square of pixels when a picture is shrunk.
float shrunk_pixel(const texture::Image& photo, std::size_t top, std::size_t left, std::size_t k,
                   std::size_t side) {
  float sum = 0, most = 0;
  std::size_t black = 0;
  for (std::size_t r = top; r < top + side; ++r)
    for (std::size_t c = left; c < left + side; ++c) {
      const float value = photo(r, c, k);
      sum += value;
      most = std::max(most, value);
      black += value <= 0;
    }
  const auto all = side * side;
  return most > nearly_clipped ? most : 2 * black > all ? 0 : sum / static_cast<float>(all);
}

/// Luminance of a picture, resized by a factor of 1 or less.
Channel smaller(const Channel& luminance, double size) {
  const auto extent = [&](std::size_t pixels) {
    return static_cast<std::size_t>(static_cast<double>(pixels) * size);
  };
  return size == 1 ? luminance
                   : colour::resampled(luminance, {.scale = size}, extent(luminance.rows()),
                                       extent(luminance.columns()));
}

/// Finds the Moon's disc in a photograph. If noise hides the limb, half and a quarter of the picture's size are tried.
colour::Disc disc_in(const Channel& luminance) {
  const auto side = static_cast<double>(std::min(luminance.rows(), luminance.columns()));
  for (const double size : {1., 0.5, 0.25}) {
    if (size < 1 && size * side < colour::least_side_px) break;
    if (const auto disc = colour::limb_of(smaller(luminance, size)))
      return {disc->x_px / size, disc->y_px / size, disc->radius_px / size};
  }
  throw algebra::Error(
      "no Moon found, allowed is one with a quarter of its limb in the picture, neither clipped "
      "nor "
      "lost in noise");
}

/// Luminance of a scene's Moon with as much glow as a lens usually scatters.
Channel glowing(const FitScene& scene) {
  constexpr double share = 0.03;
  auto luminance = scene.usual;
  for (std::size_t i = 0; i < luminance.values().size(); ++i) {
    const auto& glow = scene.glow.values()[i];
    float& value = luminance.values()[i];
    value = static_cast<float>(
        (1 - share) * value +
        share * std::inner_product(glow.begin(), glow.end(), luminance_of_rec709.begin(), 0.));
  }
  return luminance;
}

/// Registers the luminance of a rendered scene with that of a photograph. If this fails, the photograph is also
/// tried at half and at a quarter of its size, unless `roughly` is set.
colour::Registration registered_by(const Channel& luminance, const Channel& render,
                                   const FitScene& scene, const MoonPart& moon,
                                   const std::optional<double>& scale, bool roughly) {
  std::exception_ptr first;
  for (double size = 1;; size /= 2) {
    try {
      colour::KnownBefore known{.scale = scale, .roughly = roughly};
      // fine registration finds both discs by their limbs, so that both have similar errors
      if (roughly) known.in_render = scene.disc;
      if (size == 1) known.in_photo = moon.disc;
      if (scale) *known.scale *= size;
      auto found = colour::registered(smaller(luminance, size), render, known);
      found.render_to_photo =
          colour::composed(found.render_to_photo, colour::inverse({.scale = size}));
      for (double* of_disc :
           {&found.in_photo.x_px, &found.in_photo.y_px, &found.in_photo.radius_px})
        *of_disc /= size;
      return found;
    } catch (const algebra::Error&) {
      if (!first) first = std::current_exception();
      if (roughly || size <= 0.25) std::rethrow_exception(first);
    }
  }
}

/// Size of the photograph's or the scene's pixels, whichever are larger, in units of the scene's pixels.
double larger_pixel(const colour::Registration& registration) {
  return 1 / std::min(1., registration.render_to_photo.scale);
}

}  // namespace

algebra::Grid<float> clipped_in(const texture::Image& photo, float saturated) {
  Channel clipped(photo.height, photo.width);
  for (std::size_t i = 0; i < clipped.values().size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      if (photo.values[photo.channels.size() * i + k] >= saturated) clipped.values()[i] = 1;
  return clipped;
}

MoonPart moon_part(const texture::Image& photo, float saturated) {
  constexpr double margin = 1.8, least_radius_px = 0.75 * fit_disc_share * fit_side_px;
  const auto disc = disc_in(luminance_of(photo));
  const auto window = colour::window_about({disc.x_px, disc.y_px, margin * disc.radius_px},
                                           photo.height, photo.width);
  const auto by =
      static_cast<std::size_t>(std::max(1., std::floor(disc.radius_px / least_radius_px)));
  MoonPart part{.photo = {window.columns / by, window.rows / by, photo.channels},
                .shrunk = static_cast<double>(by),
                .saturated = saturated};
  for (std::size_t r = 0; r < part.photo.height; ++r)
    for (std::size_t c = 0; c < part.photo.width; ++c)
      for (std::size_t k = 0; k < photo.channels.size(); ++k)
        part.photo(r, c, k) = shrunk_pixel(photo, window.top + r * by, window.left + c * by, k, by);
  part.luminance = part.clipped = luminance_of(part.photo);
  const auto clipped = clipped_in(part.photo, std::min(nearly_clipped, saturated));
  const float most = *std::ranges::max_element(part.luminance.values());
  for (std::size_t i = 0; i < clipped.values().size(); ++i)
    if (clipped.values()[i] > 0) part.clipped.values()[i] = most, part.is_burnt = true;
  if (saturated < nearly_clipped) part.luminance = part.clipped;
  const auto within = [&](double at, std::size_t from) {
    return (at - static_cast<double>(from)) / part.shrunk;
  };
  part.disc = {within(disc.x_px, window.left), within(disc.y_px, window.top),
               disc.radius_px / part.shrunk};
  for (std::size_t k = 0; k < part.steps.size(); ++k) part.steps[k] = step_of(photo, k);
  return part;
}

std::string reason_with_shares(const MoonPart& moon, const std::string& reason) {
  constexpr double half = 0.5;
  const auto clipped = clipped_in(moon.photo, nearly_clipped);
  double all = 0, bright = 0, dark = 0;
  for (std::size_t r = 0; r < moon.photo.height; ++r)
    for (std::size_t c = 0; c < moon.photo.width; ++c) {
      const double away = std::hypot(static_cast<double>(c) + 0.5 - moon.disc.x_px,
                                     static_cast<double>(r) + 0.5 - moon.disc.y_px);
      if (away > moon.disc.radius_px) continue;
      ++all;
      bright += clipped(r, c);
      dark += moon.luminance(r, c) < colour::least_displayed;
    }
  if (bright + dark < half * all) return reason;
  return fmt::format(
      "{}; {:.0f} % of the Moon is clipped and {:.0f} % dark, half of it or more should be neither "
      "clipped nor lost in noise",
      reason, 100 * bright / all, 100 * dark / all);
}

colour::Registration registration_of(const FitScene& scene, const MoonPart& moon,
                                     const std::optional<double>& scale, Registering how) {
  constexpr double well = 0.8, very_well = 0.97;
  std::optional<colour::Registration> best;
  std::exception_ptr first;
  const auto attempt = [&](const Channel& luminance, const Channel& render) {
    try {
      const auto found =
          registered_by(luminance, render, scene, moon, scale, how == Registering::rough);
      if (!best || found.correlation > best->correlation) best = found;
    } catch (const algebra::Error&) {
      if (!first) first = std::current_exception();
    }
  };
  const auto is_found = [&](double enough) { return best && best->correlation >= enough; };
  attempt(moon.luminance, scene.usual);
  if (how == Registering::of_clipped && !is_found(well) &&
      !std::ranges::equal(moon.clipped.values(), moon.luminance.values()))
    attempt(moon.clipped, scene.usual);
  if (moon.is_burnt && !scene.glow.empty() && !is_found(very_well) && !lies_in_umbra(scene.sky))
    attempt(moon.clipped, glowing(scene));
  if (!best) std::rethrow_exception(first);
  return *best;
}

double off_limb_km(const FitScene& scene, const colour::Registration& registration) {
  constexpr double of_limb = 0.3;
  const auto& limb = registration.in_photo;
  const auto middle =
      colour::moved(registration.render_to_photo, {scene.disc.x_px, scene.disc.y_px});
  const double apart_px =
      std::hypot(middle.x - limb.x_px, middle.y - limb.y_px) / registration.render_to_photo.scale;
  return std::max(0., apart_px - of_limb * larger_pixel(registration)) * fit_pixel_km;
}

double place_error_km(const FitScene& scene, const colour::Registration& registration,
                      bool in_its_air) {
  constexpr double in_umbra = 0.3, with_crescent = 0.8, of_known_air = 0.2, by_noise = 2;
  const double pixels = std::hypot(in_its_air                 ? of_known_air
                                   : lies_in_umbra(scene.sky) ? in_umbra
                                                              : with_crescent,
                                   by_noise * (1 - registration.correlation));
  return std::hypot(pixels * larger_pixel(registration) * fit_pixel_km,
                    off_limb_km(scene, registration));
}

}  // namespace coppermoon::uses
