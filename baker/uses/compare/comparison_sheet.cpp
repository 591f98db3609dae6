// SPDX-License-Identifier: MIT
#include "uses/compare/comparison_sheet.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "colour/moon_limb.h"
#include "colour/picture_part.h"
#include "colour/similarity.h"
#include "colour/tone_curve.h"
#include "colour/working_space.h"
#include "uses/light/spectral_bands.h"
#include "uses/picture/development.h"

namespace coppermoon::uses {
namespace {

constexpr double margin = 1.12;  // ratio of half a panel's side to the disc's radius

/// Square part of the photograph around the Moon's disc, as shown in a panel.
struct Square {
  colour::Similarity from_photo;
  std::size_t side_px;
};

Square square_about(const colour::Disc& disc) {
  constexpr double most_px = 640;
  const double side = std::min(most_px, std::ceil(2 * margin * disc.radius_px)),
               scale = side / (2 * margin * disc.radius_px);
  return {{scale, 0, side / 2 - scale * disc.x_px, side / 2 - scale * disc.y_px},
          static_cast<std::size_t>(side)};
}

/// Cuts a square out of a photograph as scene-linear light. A large photograph is first averaged over blocks of pixels.
texture::Image seen_in(const Square& square, const texture::Image& photo, const Comparison& found) {
  auto disc = found.registration.in_photo;
  disc.radius_px = margin * disc.radius_px + 1;
  const auto part = colour::window_about(disc, photo.height, photo.width);
  const auto by = static_cast<std::size_t>(std::max(1., std::floor(1 / square.from_photo.scale)));
  const colour::ToneTable table(found.writing.value_or(CameraWriting{}).curve);
  texture::Image light(part.columns / by, part.rows / by, {"R", "G", "B"});
  tbb::parallel_for(std::size_t{0}, light.height, [&](std::size_t r) {
    for (std::size_t c = 0; c < light.width; ++c)
      for (std::size_t i = 0; i < by * by; ++i)
        for (std::size_t k = 0; k < 3; ++k) {
          const float value = photo(part.top + r * by + i / by, part.left + c * by + i % by, k);
          light(r, c, k) += (found.writing ? table(value) : value) / static_cast<float>(by * by);
        }
  });
  const colour::Similarity to_photo{static_cast<double>(by), 0, static_cast<double>(part.left),
                                    static_cast<double>(part.top)};
  return resampled(light, colour::composed(to_photo, square.from_photo), square.side_px,
                   square.side_px);
}

double luminance(const texture::Image& image, std::size_t row, std::size_t column) {
  const std::array<double, 3> rgb{image(row, column, 0), image(row, column, 1),
                                  image(row, column, 2)};
  return colour::luminance(picture_space, rgb);
}

/// Colour that shows a difference in brightness. It is red for positive, blue for negative and grey for no difference.
std::array<float, 3> colour_of(double stops) {
  constexpr double most = 2;
  const auto share = static_cast<float>(std::clamp(stops / most, -1., 1.));
  const float fade = 0.5F * (1 - std::abs(share));
  return {share > 0 ? 0.5F + 0.5F * share : fade, fade, share < 0 ? 0.5F - 0.5F * share : fade};
}

texture::Image difference_of(const texture::Image& photo, const texture::Image& render) {
  constexpr double dark = 1. / 2048;
  texture::Image picture(photo.width, photo.height, {"R", "G", "B"});
  for (std::size_t r = 0; r < photo.height; ++r)
    for (std::size_t c = 0; c < photo.width; ++c) {
      const double seen = luminance(photo, r, c), expected = luminance(render, r, c);
      if (seen < dark || expected < dark) continue;
      const auto pixel = colour_of(std::log2(seen / expected));
      for (std::size_t k = 0; k < 3; ++k) picture(r, c, k) = pixel[k];
    }
  return picture;
}

}  // namespace

texture::Image comparison_sheet(const texture::Image& photo, const Comparison& found) {
  const auto square = square_about(found.registration.in_photo);
  const auto seen = seen_in(square, photo, found),
             expected =
                 resampled(found.render,
                           colour::composed(found.registration.render_to_photo, square.from_photo),
                           square.side_px, square.side_px);
  const std::array panels{shown({}, 1, seen, picture_space), shown({}, 1, expected, picture_space),
                          difference_of(seen, expected)};
  texture::Image sheet(3 * seen.width, seen.height, {"R", "G", "B"});
  for (std::size_t p = 0; p < panels.size(); ++p)
    for (std::size_t r = 0; r < seen.height; ++r)
      for (std::size_t c = 0; c < seen.width; ++c)
        for (std::size_t k = 0; k < 3; ++k) sheet(r, p * seen.width + c, k) = panels[p](r, c, k);
  return sheet;
}

}  // namespace coppermoon::uses
