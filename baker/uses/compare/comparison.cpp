// SPDX-License-Identifier: MIT
#include "uses/compare/comparison.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <map>
#include <numeric>

#include "algebra/error.h"
#include "colour/difference.h"
#include "colour/glow.h"
#include "colour/working_space.h"
#include "eclipse/shadow_axis.h"
#include "povray_scenes/scene_camera.h"
#include "uses/picture/camera_request.h"
#include "uses/picture/disc_outline.h"
#include "uses/picture/pixels.h"

namespace coppermoon::uses {
namespace {

using Pixels = std::vector<SharedPixel>;

const glm::dmat3& xyz_from_rgb() {
  static const glm::dmat3 matrix =
      glm::inverse(colour::channels_from_xyz(colour::WorkingSpace::linear_rec709));
  return matrix;
}

double luminance(const glm::dvec3& rgb) { return (xyz_from_rgb() * rgb).y; }

glm::dvec3 pixel_of(const texture::Image& image, std::size_t row, std::size_t column) {
  return {image(row, column, 0), image(row, column, 1), image(row, column, 2)};
}

/// CIE 1976 chromaticity u', v' (CIE 15:2004, 8.2.1.1), or nullopt if the colour is black.
std::optional<std::array<double, 2>> uv_of(const glm::dvec3& rgb) {
  const auto xyz = xyz_from_rgb() * rgb;
  const double whole = xyz.x + 15 * xyz.y + 3 * xyz.z;
  if (!(whole > 0)) return std::nullopt;
  return std::array{4 * xyz.x / whole, 9 * xyz.y / whole};
}

/// CIELAB colour of a pixel as displayed, with each channel clipped to the range 0 to 1.
colour::Lab developed(const glm::dvec3& rgb) {
  return colour::lab_from_xyz(xyz_from_rgb() * glm::clamp(rgb, 0., 1.));
}

/// Running sums over pixels, from which a Difference is computed.
struct Sums {
  Difference difference;
  glm::dvec3 photo{0}, render{0};
  double delta_e = 0;

  void add(const SharedPixel& pixel, double exposure) {
    if (pixel.clipped) {
      ++difference.clipped;
      return;
    }
    ++difference.pixels;
    if (!(luminance(pixel.photo) > 0)) ++difference.black;
    photo += pixel.photo;
    render += exposure * pixel.render_cd_m2;
    delta_e +=
        colour::delta_e_2000(developed(pixel.photo), developed(exposure * pixel.render_cd_m2));
  }
  Difference result() const {
    auto made = difference;
    if (made.pixels == 0 || 2 * made.black > made.pixels) return made;
    const double seen = luminance(photo), expected = luminance(render);
    if (seen > 0 && expected > 0) made.stops = std::log2(seen / expected);
    made.photo_uv = uv_of(photo);
    made.render_uv = uv_of(render);
    made.delta_e_2000 = delta_e / static_cast<double>(made.pixels);
    return made;
  }
};

/// Blackens everything outside the Moon's disc, because registration would mistake stars there for the limb.
texture::Image moon_alone(texture::Image frame, const povray_scenes::SceneCamera& camera) {
  const auto disc = disc_outline(camera);
  if (!disc) return frame;
  tbb::parallel_for(std::size_t{0}, frame.height, [&](std::size_t r) {
    for (std::size_t c = 0; c < frame.width; ++c) {
      if (covered_share(*disc, static_cast<double>(c) + 0.5, static_cast<double>(r) + 0.5) > 0)
        continue;
      for (std::size_t k = 0; k < frame.channels.size(); ++k) frame(r, c, k) = 0;
    }
  });
  return frame;
}

texture::Image glowing(texture::Image frame, double share,
                       const povray_scenes::SceneCamera& camera) {
  if (share == 0) return frame;
  return image_of(colour::with_glow(pixels_of(frame), share, pixel_rad_of(camera)));
}

/// Values above this fraction of the brightest value count as clipped.
constexpr float of_brightest = 0.99F;

float brightest_of(const texture::Image& image) {
  const auto greater = [](float a, float b) { return std::max(a, b); };
  return tbb::parallel_reduce(
      tbb::blocked_range(image.values.begin(), image.values.end()), image.values.front(),
      [&](const auto& part, float most) {
        return std::accumulate(part.begin(), part.end(), most, greater);
      },
      greater);
}

bool any_channel_reaches(const glm::dvec3& rgb, double value) {
  return std::max({rgb.r, rgb.g, rgb.b}) >= value;
}

/// Median. If the number of values is even, the larger of the two middle values. Reorders `values`.
double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Distance from the shadow's axis to the lunar ground that is seen at a pixel [km], or nullopt if the pixel is farther
/// than 0.97 lunar radii from the disc's centre.
std::optional<double> axis_distance_km(const almanac::SkyState& sky,
                                       const eclipse::ShadowAxis& axis,
                                       const povray_scenes::Sight& sight, const glm::dvec2& pixel) {
  constexpr double least_emission_cosine = 0.25;  // reached at 0.97 of the disc's radius
  const auto ground = povray_scenes::ground_at(sight, pixel);
  if (!ground ||
      glm::dot(*ground, glm::normalize(sight.position - *ground)) < least_emission_cosine)
    return std::nullopt;
  return algebra::in_kilometres(eclipse::place_of_ground(axis, sky, *ground).axis_distance);
}

/// Light of a photograph over the disc, averaged over square blocks of pixels, and of the render at the same places.
/// Blocks are no larger than the render's pixels, unless the photograph would then have over a million blocks.
Pixels shared_pixels(const texture::Image& photo, const texture::Image& render,
                     const almanac::SkyState& sky, const povray_scenes::SceneCamera& camera,
                     const colour::Similarity& render_to_photo) {
  constexpr double enough = 1e6;
  const auto axis = eclipse::shadow_axis(sky);
  const auto sight = povray_scenes::sight_of(camera);
  const float clipped = of_brightest * brightest_of(photo);
  const auto width = static_cast<double>(camera.width), height = static_cast<double>(camera.height);
  const auto side = static_cast<std::size_t>(std::max(
      {1., render_to_photo.scale,
       std::sqrt(static_cast<double>(photo.width) * static_cast<double>(photo.height) / enough)}));
  const auto to_blocks =
      colour::composed(render_to_photo, {.scale = 1 / static_cast<double>(side)});
  const auto back = colour::inverse(to_blocks);
  const std::array channels{channel_of(render, 0), channel_of(render, 1), channel_of(render, 2)};
  const std::array there{colour::Resampled(channels[0], to_blocks),
                         colour::Resampled(channels[1], to_blocks),
                         colour::Resampled(channels[2], to_blocks)};
  Pixels pixels;
  for (std::size_t r = 0; r < photo.height / side; ++r)
    for (std::size_t c = 0; c < photo.width / side; ++c) {
      const auto from =
          colour::moved(back, {static_cast<double>(c) + 0.5, static_cast<double>(r) + 0.5});
      if (from.x < 1 || from.y < 1 || from.x > width - 1 || from.y > height - 1) continue;
      const auto distance_km = axis_distance_km(sky, axis, sight, from);
      if (!distance_km) continue;
      SharedPixel shared{*distance_km,
                         glm::dvec3(0),
                         {there[0].at(r, c), there[1].at(r, c), there[2].at(r, c)},
                         false};
      for (std::size_t i = 0; i < side * side; ++i) {
        const auto seen = pixel_of(photo, r * side + i / side, c * side + i % side);
        shared.photo += seen / static_cast<double>(side * side);
        shared.clipped |= any_channel_reaches(seen, clipped);
      }
      pixels.push_back(shared);
    }
  return pixels;
}

/// Exposure that makes the render as bright as the photograph. It is the median ratio of the two over all pixels of the
/// photograph that are not clipped and have more than 1 % of the brightest pixel's luminance.
double fitted_exposure(const Pixels& pixels) {
  constexpr double least_share = 0.01;
  double most = 0;
  for (const auto& pixel : pixels) most = std::max(most, luminance(pixel.photo));
  std::vector<double> ratios;
  for (const auto& pixel : pixels) {
    const double seen = luminance(pixel.photo), expected = luminance(pixel.render_cd_m2);
    if (!pixel.clipped && expected > 0 && seen > least_share * most)
      ratios.push_back(seen / expected);
  }
  if (ratios.empty())
    throw algebra::Error("no pixel of the disc is lit in both pictures and not clipped");
  return median(ratios);
}

/// Median light beside the Moon's disc, by channel: light of sky and lens, and noise. If the picture ends before, 0.
glm::dvec3 light_beside(const texture::Image& picture, const colour::Disc& disc) {
  constexpr double inner = 1.1, outer = 1.5;  // radii of the disc
  std::array<std::vector<double>, 3> light;
  for (std::size_t r = 0; r < picture.height; ++r)
    for (std::size_t c = 0; c < picture.width; ++c) {
      const double radii = std::hypot(static_cast<double>(c) + 0.5 - disc.x_px,
                                      static_cast<double>(r) + 0.5 - disc.y_px) /
                           disc.radius_px;
      if (radii > inner && radii < outer)
        for (std::size_t k = 0; k < 3; ++k) light[k].push_back(picture(r, c, k));
    }
  glm::dvec3 middle(0);
  for (int k = 0; k < 3; ++k)
    if (auto& all = light[static_cast<std::size_t>(k)]; !all.empty()) middle[k] = median(all);
  return middle;
}

/// Light of the sky that lies over the Moon in the photograph, but not in the frame.
glm::dvec3 added_sky(const texture::Image& photo, const texture::Image& frame,
                     const colour::Registration& found) {
  const auto& [x, y, radius] = found.in_photo;
  const auto centre = colour::moved(colour::inverse(found.render_to_photo), {x, y});
  const auto in_frame =
      light_beside(frame, {centre.x, centre.y, radius / found.render_to_photo.scale});
  return in_frame == glm::dvec3(0) ? light_beside(photo, found.in_photo) : glm::dvec3(0);
}

/// Light of a rendered pixel after a camera's colour conversion, in linear Rec.709.
glm::dvec3 written(const CameraColours& colours, const glm::dvec3& rgb) {
  const auto xyz = xyz_from_rgb() * rgb;
  const auto by = rec709_by(colours, std::array{xyz.x, xyz.y, xyz.z}, 0);
  return {by[0], by[1], by[2]};
}

constexpr double step_of_light = 0.1;  // step of the logarithm of light

/// Pixels whose rendered light in one channel lies within the same step.
struct LightStep {
  std::vector<double> displayed;
  double of_red = 0, of_blue = 0;  ///< sums over pixels of (light from camera red or blue) / light
};

/// Pixels grouped by rendered light, in steps of its logarithm. A key is the number of the step, and the channel.
std::map<std::pair<long, int>, LightStep> light_steps(const Pixels& pixels,
                                                      const CameraColours& colours) {
  std::map<std::pair<long, int>, LightStep> steps;
  for (const auto& pixel : pixels) {
    if (pixel.clipped) continue;
    const auto xyz = xyz_from_rgb() * pixel.render_cd_m2;
    for (int k = 0; k < 3; ++k) {
      const auto parts =
          parts_of(static_cast<std::size_t>(k), colours, std::array{xyz.x, xyz.y, xyz.z});
      const double light = parts.r + parts.g + parts.b;
      if (!(light > 0)) continue;
      auto& step = steps[{std::lround(std::log(light) / step_of_light), k}];
      step.displayed.push_back(pixel.photo[k]);
      step.of_red += parts.r / light;
      step.of_blue += parts.b / light;
    }
  }
  return steps;
}

/// Converts the photograph's displayed values to scene-linear light, and gives the render the camera's colours.
void undo(const CameraWriting& writing, Pixels& pixels) {
  const colour::ToneTable table(writing.curve);
  for (auto& pixel : pixels) {
    for (int k = 0; k < 3; ++k) pixel.photo[k] = double{table(static_cast<float>(pixel.photo[k]))};
    pixel.render_cd_m2 = written(writing.colours, pixel.render_cd_m2);
  }
}

}  // namespace

algebra::Grid<float> luminance_of(const texture::Image& light) {
  const float most = brightest_of(light), clipped = of_brightest * most;
  algebra::Grid<float> grid(light.height, light.width);
  tbb::parallel_for(std::size_t{0}, light.height, [&](std::size_t r) {
    for (std::size_t c = 0; c < light.width; ++c) {
      const auto pixel = pixel_of(light, r, c);
      grid(r, c) =
          any_channel_reaches(pixel, clipped) ? most : static_cast<float>(luminance(pixel));
    }
  });
  return grid;
}

texture::Image resampled(const texture::Image& image, const colour::Similarity& similarity,
                         std::size_t rows, std::size_t columns) {
  texture::Image other(columns, rows, {"R", "G", "B"});
  for (std::size_t k = 0; k < 3; ++k) {
    const auto there = colour::resampled(channel_of(image, k), similarity, rows, columns);
    for (std::size_t i = 0; i < there.values().size(); ++i)
      other.values[3 * i + k] = there.values()[i];
  }
  return other;
}

std::vector<Difference> differences(const Pixels& pixels, double exposure, std::size_t bins) {
  double nearest = std::numeric_limits<double>::infinity(), furthest = 0;
  for (const auto& pixel : pixels) {
    nearest = std::min(nearest, pixel.axis_distance_km);
    furthest = std::max(furthest, pixel.axis_distance_km);
  }
  const double width = std::max(furthest - nearest, 1e-9) / static_cast<double>(bins);
  std::vector<Sums> sums(bins + 1);
  for (std::size_t i = 0; i < bins; ++i)
    sums[i].difference = {.from_km = nearest + width * static_cast<double>(i),
                          .to_km = nearest + width * static_cast<double>(i + 1)};
  sums[bins].difference = {.from_km = nearest, .to_km = furthest};
  for (const auto& pixel : pixels) {
    const auto bin = static_cast<std::size_t>((pixel.axis_distance_km - nearest) / width);
    sums[std::min(bin, bins - 1)].add(pixel, exposure);
    sums[bins].add(pixel, exposure);
  }
  std::vector<Difference> made;
  for (const auto& sum : sums) made.push_back(sum.result());
  return made;
}

CameraWriting fitted_writing(const Pixels& pixels, const CameraColours& colours,
                             const glm::dvec3& sky) {
  constexpr double error = 0.03, unknown = 10, of_colours = 0.3;
  constexpr double settled = 1e-3, most_change = 0.3, times_sky = 3;
  constexpr std::size_t many = 10, least = 3, most_rounds = 20;
  const auto darkest = glm::max(glm::dvec3(colour::least_displayed), times_sky * sky);
  using Vector = Eigen::Vector<double, 3 + colour::tone_numbers>;
  CameraWriting found{{}, colours};
  auto& gains = found.colours.gains;
  for (std::size_t round = 0; round < most_rounds; ++round) {
    Eigen::Matrix<double, Vector::RowsAtCompileTime, Vector::RowsAtCompileTime> normal;
    normal.setIdentity();  // because the prior is a unit Gaussian
    Vector sums = Vector::Zero();
    sums[1] = std::log(colours.gains.r / gains.r) / of_colours;
    sums[2] = std::log(colours.gains.b / gains.b) / of_colours;
    std::size_t steps = 0;
    for (auto& [light, step] : light_steps(pixels, found.colours)) {
      const auto count = static_cast<double>(step.displayed.size());
      const double middle = median(step.displayed);
      if (step.displayed.size() < many || middle <= darkest[light.second] ||
          middle >= colour::most_displayed)
        continue;
      const double residual = std::log(middle) + colour::tone_logarithm({}, middle) -
                              step_of_light * static_cast<double>(light.first);
      Vector row = Vector::Zero();
      row[0] = unknown;
      row[1] = of_colours * step.of_red / count;
      row[2] = of_colours * step.of_blue / count;
      std::ranges::copy(colour::tone_derivatives(middle), row.begin() + 3);
      normal += row * row.transpose() / (error * error);
      sums += row * residual / (error * error);
      ++steps;
    }
    if (steps < least)
      throw algebra::Error(fmt::format(
          "{} steps of light to find a tone curve by, allowed {} or more: too much of the "
          "photograph is clipped or black",
          steps, least));
    const Vector solved = normal.llt().solve(sums);
    std::transform(solved.begin() + 3, solved.end(), found.curve.numbers.begin(), std::negate());
    const double red = std::clamp(of_colours * solved[1], -most_change, most_change),
                 blue = std::clamp(of_colours * solved[2], -most_change, most_change);
    gains *= glm::dvec3(std::exp(red), 1, std::exp(blue));
    if (std::max(std::abs(red), std::abs(blue)) < settled) break;
  }
  return found;
}

Comparison compared(const texture::Image& photo, const texture::Image& frame,
                    const almanac::SkyState& sky, const povray_scenes::SceneCamera& camera,
                    const ComparisonRequest& request) {
  const auto& [exposure, colours, glow, bins] = request;
  algebra::require_within("bins", static_cast<double>(bins), 1, 1000);
  if (frame.width != camera.width || frame.height != camera.height)
    throw algebra::Error(fmt::format("a frame of {} x {} pixels, allowed {} x {}, as its camera's",
                                     frame.width, frame.height, camera.width, camera.height));
  auto moon = glowing(moon_alone(frame, camera), glow, camera);
  const auto registration = colour::registered(luminance_of(photo), luminance_of(moon));
  auto pixels = shared_pixels(photo, moon, sky, camera, registration.render_to_photo);
  std::optional<CameraWriting> writing;
  if (colours) {
    for (auto& pixel : pixels)
      pixel.clipped |= any_channel_reaches(pixel.photo, colour::most_displayed);
    writing = fitted_writing(pixels, *colours, added_sky(photo, frame, registration));
    undo(*writing, pixels);
    auto light = pixels_of(moon);
    for (auto& rgb : light.values()) {
      const auto by = written(writing->colours, {rgb[0], rgb[1], rgb[2]});
      rgb = {static_cast<float>(by.r), static_cast<float>(by.g), static_cast<float>(by.b)};
    }
    moon = image_of(light);
  }
  const double fitted = fitted_exposure(pixels);
  const double used = exposure ? colour::exposure_scale(*exposure) : fitted;
  auto found = differences(pixels, used, bins);
  for (float& value : moon.values) value *= static_cast<float>(used);
  return {registration, used, fitted, std::move(found), std::move(moon), writing};
}

}  // namespace coppermoon::uses
