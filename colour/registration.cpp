// SPDX-License-Identifier: MIT
#include "colour/registration.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>
#include <vector>

#include "algebra/error.h"
#include "colour/disc_features.h"
#include "colour/moon_limb.h"
#include "colour/picture_part.h"

namespace coppermoon::colour {
namespace {

using Values = algebra::Grid<float>;
using std::numbers::pi;

constexpr double within_limb = 0.92, beyond_limb = 1.2;             // [disc radii]
constexpr double least_correlation = 0.4, least_of_markings = 0.3;  // up to 0.29 occurs by chance

/// Sums for a weighted correlation.
struct Sums {
  double w = 0, x = 0, y = 0, xx = 0, yy = 0, xy = 0;

  void add(double weight, double a, double b) {
    w += weight;
    x += weight * a;
    y += weight * b;
    xx += weight * a * a;
    yy += weight * b * b;
    xy += weight * a * b;
  }
  /// Correlation coefficient; 0 if there is no variance.
  double correlation() const {
    const double spread = (w * xx - x * x) * (w * yy - y * y);
    return spread > 0 ? (w * xy - x * y) / std::sqrt(spread) : 0;
  }
};

/// Rotation, scale and shift between two discs of the same size, each in the middle of its grid.
struct Pose {
  bool mirrored = false;
  std::array<double, 4> parts{};  ///< rotation [rad], logarithm of scale, shifts in x and y [radii]
};

double middle_of(const DiscFeatures& features) {
  return 0.5 * static_cast<double>(features.contrast.columns());
}

/// A pixel in the photograph's disc.
struct Seen {
  glm::dvec2 at;        ///< column and row
  double away_squared;  ///< square of the distance from the disc's centre [pixels²]
  double weight, contrast;
};

/// Features of the photograph's and the render's disc, scaled to the same radius.
struct Pair {
  DiscFeatures photo, render;
  double radius_px;
  std::vector<Seen> seen = {};                                ///< pixels in `photo` with a weight
  algebra::Grid<std::array<double, 2>> weight_contrast = {};  ///< at each pixel of `render`
  double last_column, last_row;                               ///< in the grids of `render`

  Pair(DiscFeatures of_photo, DiscFeatures of_render, double radius)
      : photo(std::move(of_photo)),
        render(std::move(of_render)),
        radius_px(radius),
        weight_contrast(render.weight.rows(), render.weight.columns()),
        last_column(static_cast<double>(render.weight.columns()) - 1),
        last_row(static_cast<double>(render.weight.rows()) - 1) {
    const double middle = middle_of(photo), reach = beyond_limb * radius_px;
    for (std::size_t r = 0; r < photo.contrast.rows(); ++r)
      for (std::size_t c = 0; c < photo.contrast.columns(); ++c) {
        const glm::dvec2 at(static_cast<double>(c), static_cast<double>(r)),
            out = at + 0.5 - middle;
        const double weight = photo.weight(r, c), squared = glm::dot(out, out);
        if (weight > 0 && squared <= reach * reach)
          seen.push_back({at, squared, weight, photo.contrast(r, c)});
      }
    for (std::size_t i = 0; i < weight_contrast.values().size(); ++i)
      weight_contrast.values()[i] = {render.weight.values()[i], render.contrast.values()[i]};
  }

  /// Weight and contrast of the render at a point, interpolated as in between_pixels.
  std::array<double, 2> rendered(const glm::dvec2& pixel) const {
    const double x = pixel.x - 0.5, y = pixel.y - 0.5;
    if (!(x >= 0 && y >= 0 && x < last_column && y < last_row))
      return {between_pixels(render.weight, pixel), between_pixels(render.contrast, pixel)};
    const auto column = static_cast<int>(x), row = static_cast<int>(y);
    const double across = x - column, down = y - row;
    const std::size_t columns = weight_contrast.columns();
    const auto* at =
        &weight_contrast(static_cast<std::size_t>(row), static_cast<std::size_t>(column));
    const auto &a = at[0], &b = at[1], &c = at[columns], &d = at[columns + 1];
    std::array<double, 2> upper, lower, values;
    for (std::size_t k = 0; k < 2; ++k) upper[k] = a[k] + across * (b[k] - a[k]);
    for (std::size_t k = 0; k < 2; ++k) lower[k] = c[k] + across * (d[k] - c[k]);
    for (std::size_t k = 0; k < 2; ++k) values[k] = upper[k] + down * (lower[k] - upper[k]);
    return values;
  }
};

/// The similarity that maps the render's grid to the photograph's for a given pose.
Similarity similarity_of(const Pair& pair, const Pose& pose) {
  const auto& [turn, growth, x, y] = pose.parts;
  Similarity similarity{std::exp(growth), turn, 0, 0, pose.mirrored};
  const double from = middle_of(pair.render), to = middle_of(pair.photo);
  const auto centre = moved(similarity, {from, from});
  similarity.x_px = to + pair.radius_px * x - centre.x;
  similarity.y_px = to + pair.radius_px * y - centre.y;
  return similarity;
}

/// Calls `act` for each photograph pixel that has weight in both pictures and lies within `out_to` radii of the disc's
/// centre. Passes the squared distance from the centre (1 at that limit), the weights' product and both contrasts.
void for_all_shared(const Pair& pair, const Pose& pose, double out_to, const auto& act) {
  const auto back = inverse(similarity_of(pair, pose));
  const auto corner = moved(back, {0.5, 0.5}), across = moved(back, {1.5, 0.5}) - corner,
             down = moved(back, {0.5, 1.5}) - corner;
  const double reach = out_to * pair.radius_px;
  for (const auto& [at, away_squared, here, contrast] : pair.seen) {
    if (away_squared > reach * reach) continue;
    const auto [of_render, rendered] = pair.rendered(corner + at.x * across + at.y * down);
    const double weight = here * of_render;
    if (weight > 0) act(away_squared / (reach * reach), weight, contrast, rendered);
  }
}

/// Correlation of the contrasts of both discs for a given pose, out to a share of their radius.
double correlation(const Pair& pair, const Pose& pose, double out_to) {
  Sums sums;
  for_all_shared(pair, pose, out_to,
                 [&](double, double weight, double a, double b) { sums.add(weight, a, b); });
  return sums.correlation();
}

/// Correlation of markings alone: the mean of each ring around the centre is subtracted, because any bright ball
/// darkens towards its limb.
double correlation_of_markings(const Pair& pair, const Pose& pose) {
  constexpr std::size_t count = 24;
  std::array<Sums, count> rings;
  for_all_shared(pair, pose, within_limb, [&](double squared, double weight, double a, double b) {
    const auto ring = static_cast<std::size_t>(std::sqrt(squared) * count);
    rings[std::min(count - 1, ring)].add(weight, a, b);
  });
  Sums all{.w = 1};
  for (const auto& ring : rings) {
    if (!(ring.w > 0)) continue;
    all.xx += ring.xx - ring.x * ring.x / ring.w;
    all.yy += ring.yy - ring.y * ring.y / ring.w;
    all.xy += ring.xy - ring.x * ring.y / ring.w;
  }
  return all.correlation();
}

/// A disc in polar coordinates, with a row for each ring and a column for each degree.
struct Rings {
  Values contrast, weight;
};

Rings rings_of(const DiscFeatures& features, double radius_px) {
  constexpr std::size_t rings = 20, degrees = 360;
  Rings made{Values(rings, degrees), Values(rings, degrees)};
  const double middle = middle_of(features);
  for (std::size_t i = 0; i < rings; ++i)
    for (std::size_t d = 0; d < degrees; ++d) {
      const double share = within_limb * (static_cast<double>(i) + 0.5) / rings;
      const double angle = static_cast<double>(d) * pi / 180, away = share * radius_px;
      const glm::dvec2 at(middle + away * std::cos(angle), middle + away * std::sin(angle));
      made.contrast(i, d) = static_cast<float>(between_pixels(features.contrast, at));
      made.weight(i, d) = static_cast<float>(share * between_pixels(features.weight, at));
    }
  return made;
}

double correlation(const Rings& photo, const Rings& render, std::size_t turn, bool mirrored) {
  Sums sums;
  for (std::size_t i = 0; i < photo.contrast.rows(); ++i)
    for (std::size_t d = 0; d < 360; ++d) {
      const std::size_t there = (mirrored ? 540 + turn - d : 360 + d - turn) % 360;
      sums.add(photo.weight(i, d) * render.weight(i, there), photo.contrast(i, d),
               render.contrast(i, there));
    }
  return sums.correlation();
}

/// Up to four poses with the rotations at which the correlation of the rings peaks, the best first.
std::vector<Pose> likely_poses(const Pair& pair) {
  constexpr std::size_t some = 4;
  const auto photo = rings_of(pair.photo, pair.radius_px),
             render = rings_of(pair.render, pair.radius_px);
  std::vector<std::pair<double, Pose>> peaks;
  for (const bool mirrored : {false, true}) {
    std::array<double, 360> all{};
    for (std::size_t turn = 0; turn < 360; ++turn)
      all[turn] = correlation(photo, render, turn, mirrored);
    for (std::size_t turn = 0; turn < 360; ++turn)
      if (all[turn] > all[(turn + 359) % 360] && all[turn] >= all[(turn + 1) % 360])
        peaks.push_back({all[turn], {mirrored, {static_cast<double>(turn) * pi / 180, 0, 0, 0}}});
  }
  std::ranges::sort(peaks, std::greater{}, [](const auto& peak) { return peak.first; });
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < std::min(some, peaks.size()); ++i) poses.push_back(peaks[i].second);
  return poses;
}

using Parts = std::array<double, 4>;

Parts between(const Parts& a, const Parts& b, double share) {
  Parts c{};
  for (std::size_t k = 0; k < c.size(); ++k) c[k] = a[k] + share * (b[k] - a[k]);
  return c;
}

struct Corner {
  Parts at;
  double height;
};

/// One step of the simplex method towards a maximum. Source: Nelder & Mead (1965), Computer Journal 7, 308.
void climb(std::array<Corner, 5>& simplex, const std::function<double(const Parts&)>& height) {
  std::ranges::sort(simplex, std::greater{}, &Corner::height);
  Parts middle{};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < 4; ++k) middle[k] += simplex[i].at[k] / 4;
  auto& lowest = simplex.back();
  const auto tried = [&](double share) {
    const auto at = between(lowest.at, middle, share);
    return Corner{at, height(at)};
  };
  const auto reflected = tried(2);
  if (reflected.height > simplex.front().height) {
    const auto further = tried(3);
    lowest = further.height > reflected.height ? further : reflected;
  } else if (reflected.height > simplex[3].height) {
    lowest = reflected;
  } else if (const auto nearer = tried(reflected.height > lowest.height ? 1.5 : 0.5);
             nearer.height > std::max(reflected.height, lowest.height)) {
    lowest = nearer;
  } else {
    for (std::size_t i = 1; i < simplex.size(); ++i) {
      const auto at = between(simplex[i].at, simplex.front().at, 0.5);
      simplex[i] = {at, height(at)};
    }
  }
}

/// The pose of greatest correlation near a first guess. If `of_its_scale`, the guess's scale is kept. Steps shrink from
/// `begin` [disc radii, rad] to `end_px` pixels at the limb.
Pose refined(const Pair& pair, Pose pose, bool of_its_scale, double begin, double end_px) {
  constexpr std::size_t growth = 1;
  const auto height = [&](const Parts& parts) {
    return correlation(pair, {pose.mirrored, parts}, beyond_limb);
  };
  std::array<Corner, 5> simplex;
  for (std::size_t i = 0; i < simplex.size(); ++i) {
    auto at = pose.parts;
    if (i > 0 && !(of_its_scale && i - 1 == growth)) at[i - 1] += begin;
    simplex[i] = {at, height(at)};
  }
  const auto wide = [&] {
    double most = 0;
    for (const auto& corner : simplex)
      for (std::size_t k = 0; k < 4; ++k)
        most = std::max(most, std::abs(corner.at[k] - simplex[0].at[k]) * pair.radius_px);
    return most;
  };
  for (int step = 0; step < 150 && wide() > end_px; ++step) climb(simplex, height);
  pose.parts = std::ranges::max_element(simplex, {}, &Corner::height)->at;
  return pose;
}

/// Adjusts a pose's rotation by up to 1.5 degrees so that markings correlate best. The limb is left out, as it says
/// nothing about rotation, and its blur favours poses whose pixels fall between those of the photograph.
Pose turned(const Pair& pair, Pose pose) {
  for (const double step : {0.5 * pi / 180, 0.1 * pi / 180}) {
    const auto before = pose;
    double most = -1;
    for (int i = -3; i <= 3; ++i) {
      auto tried = before;
      tried.parts[0] += i * step;
      const double alike = correlation_of_markings(pair, tried);
      if (alike > most) most = alike, pose = tried;
    }
  }
  return pose;
}

/// The Moon with some sky around it, binned as far as possible while its features remain resolved.
struct CloseUp {
  Values picture;
  Disc disc;
  Similarity to_whole;
};

Disc disc_in(const Values& picture, const char* name) {
  if (const auto disc = limb_of(picture)) return *disc;
  throw algebra::Error(std::string(name) +
                       ": no Moon found, allowed is one with a quarter of its limb in the picture");
}

CloseUp close_up(const Values& picture, const Disc& disc) {
  // The margin is in disc radii. 640 pixels are 4 times the disc's radius in the finest grid.
  constexpr double margin = 1.4, enough_px = 640;
  const double by = std::max(1., std::floor(disc.radius_px / enough_px));
  const auto part = window_about({disc.x_px, disc.y_px, margin * disc.radius_px}, picture.rows(),
                                 picture.columns());
  const auto left = static_cast<double>(part.left), top = static_cast<double>(part.top);
  return {reduced(picture, part, static_cast<std::size_t>(by)),
          {(disc.x_px - left) / by, (disc.y_px - top) / by, disc.radius_px / by},
          {by, 0, left, top}};
}

/// The photograph's and the render's disc. Features of both have the same radius and the photograph's tonal range.
struct Discs {
  CloseUp photo, render;
  double clipped;  ///< saturated share of the photograph's disc

  Pair at_radius(double most_px) const {
    const double radius_px = std::min({most_px, photo.disc.radius_px, render.disc.radius_px});
    TonalRange range{.clipped = clipped, .deeply = is_deep(render.picture, render.disc, clipped)};
    auto seen = features_of(photo.picture, photo.disc, radius_px, range);
    range.floor = seen.floor;
    auto rendered = features_of(render.picture, render.disc, radius_px, range);
    return {std::move(seen), std::move(rendered), radius_px};
  }
};

}  // namespace

Registration registered(const Values& photo, const Values& render, const KnownBefore& known) {
  const auto in_render = known.in_render ? *known.in_render : disc_in(render, "render");
  auto in_photo = known.in_photo ? *known.in_photo : disc_in(photo, "photograph");
  const bool of_its_scale = known.scale.has_value();
  if (of_its_scale) in_photo.radius_px = *known.scale * in_render.radius_px;
  const Discs discs{close_up(photo, in_photo), close_up(render, in_render),
                    clipped_share(photo, in_photo)};
  const auto coarse = discs.at_radius(40);
  Pose best;
  double most = -1;
  for (const auto& likely : likely_poses(coarse)) {
    const auto pose = refined(coarse, likely, of_its_scale, 0.015, 0.1);
    const double alike = correlation(coarse, pose, within_limb);
    if (alike > most) most = alike, best = pose;
  }
  const auto fine = known.roughly ? coarse : discs.at_radius(160);
  if (!known.roughly) best = turned(fine, refined(fine, best, of_its_scale, 0.003, 0.005));
  const double alike = correlation(fine, best, within_limb);
  algebra::require_within("correlation of photograph and render", alike, least_correlation, 1);
  algebra::require_within("correlation of markings on photograph and render",
                          correlation_of_markings(fine, best), least_of_markings, 1);
  const auto from_render = composed(inverse(discs.render.to_whole), fine.render.from_picture),
             to_photo = composed(inverse(fine.photo.from_picture), discs.photo.to_whole);
  auto found = composed(composed(from_render, similarity_of(fine, best)), to_photo);
  found.rotation_rad = std::remainder(found.rotation_rad, 2 * pi);
  return {found, alike, in_photo};
}

}  // namespace coppermoon::colour
