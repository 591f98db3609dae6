// SPDX-License-Identifier: MIT
#include "surface/moon_row.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "surface/moon_row.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for each instruction set
#include <hwy/highway.h>

#include <hwy/contrib/math/math-inl.h>
#include <algorithm>
#include <array>
#include <numbers>

HWY_BEFORE_NAMESPACE();
namespace coppermoon::surface::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<float, 16>;
using V = hn::Vec<D>;

/// Some texels: whole vectors, and at the end of a row as many as are left.
class Texels {
 public:
  Texels(std::size_t first, std::size_t last)
      : first_(first), count_(std::min(hn::Lanes(D()), last - first)) {}

  V load(std::span<const float> values) const {
    if (count_ == hn::Lanes(D())) return hn::LoadU(D(), &values[first_]);
    std::array<float, 16> some{};
    std::copy_n(&values[first_], count_, some.begin());
    return hn::LoadU(D(), some.data());
  }

  void store(V result, std::span<float> values) const {
    if (count_ == hn::Lanes(D())) return hn::StoreU(result, D(), &values[first_]);
    std::array<float, 16> some;
    hn::StoreU(result, D(), some.data());
    std::copy_n(some.begin(), count_, &values[first_]);
  }

 private:
  std::size_t first_, count_;
};

HWY_INLINE V number(float value) { return hn::Set(D(), value); }
HWY_INLINE V squared(V x) { return hn::Mul(x, x); }

struct Point {
  V x, y, z;
};

HWY_INLINE Point texel_at(const MoonRow& row, const Texels& texels) {
  return {texels.load(row.x), texels.load(row.y), texels.load(row.z)};
}

HWY_INLINE V dot(const Point& point, const glm::vec3& direction) {
  return hn::MulAdd(
      point.x, number(direction.x),
      hn::MulAdd(point.y, number(direction.y), hn::Mul(point.z, number(direction.z))));
}

/// Where a point is seen from a site: its angle's sine times its direction, and the sine itself.
struct Sight {
  V east, north, sine, cosine;
};

HWY_INLINE Sight sight_of(const Point& point, const Site& from) {
  const auto east = dot(point, from.east), north = dot(point, from.north);
  return {east, north, hn::Sqrt(hn::MulAdd(east, east, squared(north))), dot(point, from.up)};
}

/// The angle, 0 to π.
HWY_INLINE V distance(const Sight& at) {
  const D d;
  const auto along = hn::Abs(at.cosine);
  const auto low = hn::Min(at.sine, along), high = hn::Max(at.sine, along);
  auto angle = hn::Atan(d, hn::Div(low, high));
  angle = hn::IfThenElse(hn::Gt(at.sine, along),
                         hn::Sub(number(std::numbers::pi_v<float> / 2), angle), angle);
  return hn::IfThenElse(hn::Lt(at.cosine, hn::Zero(d)),
                        hn::Sub(number(std::numbers::pi_v<float>), angle), angle);
}

HWY_INLINE V smooth_step(float from, float to, V x) {
  const auto t = hn::Clamp(hn::Mul(hn::Sub(x, number(from)), number(1 / (to - from))),
                           hn::Zero(D()), number(1));
  return hn::Mul(squared(t), hn::NegMulAdd(number(2), t, number(3)));
}

float smooth(float from, float to, float x) {
  const float t = std::clamp((x - from) / (to - from), 0.0F, 1.0F);
  return t * t * (3 - 2 * t);
}

void paint_patch(const Patch& patch, const Columns& columns, MoonRow& row) {
  const D d;
  const float longest = std::max(patch.semi_east_rad, patch.semi_north_rad);
  // A small patch keeps its place and shape: it is bent by no more than a part of its size.
  const auto bending = number(std::min(1.0F, longest / 0.09F));
  const auto ragged = number(1.9F * smooth(0.015F, 0.06F, longest));
  const auto bent = [&](V straight, V moved) {
    return hn::MulAdd(bending, hn::Sub(moved, straight), straight);
  };
  for (std::size_t c = columns.first; c < columns.last; c += hn::Lanes(d)) {
    const Texels texels(c, columns.last);
    const auto here = texel_at(row, texels);
    const auto at =
        sight_of({bent(here.x, texels.load(row.bent_x)), bent(here.y, texels.load(row.bent_y)),
                  bent(here.z, texels.load(row.bent_z))},
                 patch.at);
    const auto shade = texels.load(row.shade);
    const auto u = hn::Mul(
        hn::MulAdd(at.east, number(patch.cos_turn), hn::Mul(at.north, number(patch.sin_turn))),
        number(1 / patch.semi_east_rad));
    const auto v = hn::Mul(
        hn::MulSub(at.north, number(patch.cos_turn), hn::Mul(at.east, number(patch.sin_turn))),
        number(1 / patch.semi_north_rad));
    const auto within = hn::Sqrt(hn::MulAdd(u, u, squared(v)));  // of sines: no more than of angles
    const auto edge = hn::Mul(ragged, shade), outermost = number(1 + patch.softness);
    if (hn::AllTrue(d, hn::Gt(hn::Add(within, edge), outermost))) continue;
    const auto stretch =
        hn::IfThenElse(hn::Gt(at.sine, number(1e-6F)), hn::Div(distance(at), at.sine), number(1));
    const auto cover = hn::Sub(number(1), smooth_step(1 - patch.softness, 1 + patch.softness,
                                                      hn::MulAdd(within, stretch, edge)));
    const auto albedo = texels.load(row.albedo);
    const auto shaded = hn::Mul(number(patch.albedo), hn::MulAdd(number(1.2F), shade, number(1)));
    texels.store(hn::MulAdd(cover, hn::Sub(shaded, albedo), albedo), row.albedo);
  }
}

void paint_old_crater(const OldCrater& crater, const Columns& columns, MoonRow& row) {
  const D d;
  for (std::size_t c = columns.first; c < columns.last; c += hn::Lanes(d)) {
    const Texels texels(c, columns.last);
    const auto r = hn::Mul(distance(sight_of(texel_at(row, texels), crater.at)),
                           number(1 / crater.radius_rad));
    const auto wall = hn::Max(hn::Zero(d), hn::NegMulAdd(hn::Abs(hn::Sub(r, number(0.9F))),
                                                         number(1 / 0.35F), number(1)));
    const auto floor = hn::Sub(number(1), smooth_step(0.4F, 0.8F, r));
    const auto relief = hn::NegMulAdd(number(0.45F), floor, wall);
    texels.store(
        hn::Mul(texels.load(row.albedo), hn::MulAdd(number(crater.contrast), relief, number(1))),
        row.albedo);
  }
}

/// Adds how strongly one ray shows.
HWY_INLINE V with_ray(const Ray& ray, const Sight& at, V away, V grain, V strength) {
  constexpr float cos_of_aside = 0.0707372F, sin_of_aside = 0.997495F;  // of 1.5
  constexpr float unseen = 20;
  const D d;
  const auto on_it = hn::Le(away, number(ray.length_rad));
  if (hn::AllFalse(d, on_it)) return strength;
  const auto across = hn::Abs(
                 hn::MulSub(at.east, number(ray.north), hn::Mul(at.north, number(ray.east)))),
             ahead = hn::MulAdd(at.north, number(ray.north), hn::Mul(at.east, number(ray.east)));
  const auto aside = hn::IfThenElse(hn::Gt(ahead, hn::Mul(number(cos_of_aside), at.sine)), across,
                                    hn::Mul(number(sin_of_aside), at.sine));
  const auto along = hn::Mul(away, number(1 / ray.length_rad));
  const auto wide =
      hn::Mul(hn::Mul(number(ray.half_width_rad), hn::MulAdd(number(1.8F), along, number(1))),
              hn::MulAdd(number(3), grain, number(1)));
  const auto steep = hn::Div(squared(aside), squared(wide));
  if (hn::AllFalse(d, hn::And(on_it, hn::Lt(steep, number(unseen))))) return strength;
  const auto more =
      hn::Mul(hn::Mul(number(ray.strength), hn::Exp(d, hn::Neg(hn::Min(steep, number(80))))),
              hn::NegMulAdd(along, along, number(1)));
  return hn::Add(strength, hn::IfThenElseZero(on_it, more));
}

void paint_ray_crater(const RayCrater& crater, const Columns& columns, MoonRow& row) {
  const D d;
  const auto one = number(1);
  for (std::size_t c = columns.first; c < columns.last; c += hn::Lanes(d)) {
    const Texels texels(c, columns.last);
    const auto at = sight_of(texel_at(row, texels), crater.at);
    const auto away = distance(at), grain = texels.load(row.grain);
    const auto r = hn::Mul(away, number(1 / crater.radius_rad));
    const auto inside = hn::Lt(r, one);
    const auto fall = hn::Exp(d, hn::Mul(number(-0.75F), hn::Min(hn::Sub(r, one), number(100))));
    const auto halo = hn::IfThenElse(inside, hn::MulAdd(number(0.3F), r, number(0.7F)),
                                     hn::Mul(fall, hn::MulAdd(number(3), grain, number(0.8F))));
    auto rays = hn::Zero(d);
    for (const auto& ray : crater.rays) rays = with_ray(ray, at, away, grain, rays);
    rays = hn::Mul(hn::Min(rays, one),
                   hn::Clamp(hn::MulAdd(number(4.5F), grain, number(0.62F)), number(0.1F), one));
    rays = hn::IfThenZeroElse(inside, hn::Mul(number(0.85F), rays));
    const auto strength = hn::Clamp(hn::Max(hn::Mul(number(0.85F), halo), rays), hn::Zero(d), one);
    const auto albedo = texels.load(row.albedo);
    const auto brighter = hn::Max(hn::Zero(d), hn::Sub(number(crater.albedo), albedo));
    texels.store(hn::MulAdd(strength, brighter, albedo), row.albedo);
  }
}

void normalise(MoonRow& row) {
  const D d;
  for (std::size_t c = 0; c < row.x.size(); c += hn::Lanes(d)) {
    const Texels texels(c, row.x.size());
    const auto x = texels.load(row.bent_x), y = texels.load(row.bent_y),
               z = texels.load(row.bent_z);
    const auto shorter =
        hn::Div(number(1), hn::Sqrt(hn::MulAdd(x, x, hn::MulAdd(y, y, squared(z)))));
    texels.store(hn::Mul(x, shorter), row.bent_x);
    texels.store(hn::Mul(y, shorter), row.bent_y);
    texels.store(hn::Mul(z, shorter), row.bent_z);
  }
}

}  // namespace coppermoon::surface::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace coppermoon::surface {

HWY_EXPORT(normalise);
HWY_EXPORT(paint_patch);
HWY_EXPORT(paint_old_crater);
HWY_EXPORT(paint_ray_crater);

void normalise_bent(MoonRow& row) { HWY_DYNAMIC_DISPATCH(normalise)(row); }

void paint(const Patch& patch, const Columns& columns, MoonRow& row) {
  HWY_DYNAMIC_DISPATCH(paint_patch)(patch, columns, row);
}

void paint(const OldCrater& crater, const Columns& columns, MoonRow& row) {
  HWY_DYNAMIC_DISPATCH(paint_old_crater)(crater, columns, row);
}

void paint(const RayCrater& crater, const Columns& columns, MoonRow& row) {
  HWY_DYNAMIC_DISPATCH(paint_ray_crater)(crater, columns, row);
}

}  // namespace coppermoon::surface
#endif
