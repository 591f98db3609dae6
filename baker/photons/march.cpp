// SPDX-License-Identifier: MIT
#include "photons/march.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "algebra/error.h"

// Compiled once for each SIMD target, the best chosen at run time; vectors are members of structs
// here, which targets without a fixed width do not allow.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "photons/march.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#ifndef COPPERMOON_MARCH_START
#define COPPERMOON_MARCH_START
namespace coppermoon::photons {
namespace {

constexpr std::size_t most_lanes = 16, most_amounts = atmosphere::absorbers;

/// Rays of one vector, lane by lane: entry into the air, and results on leaving it.
template <class T>
struct Lanes {
  alignas(64) std::array<T, most_lanes> along_m, height_m, forward, upward;
  alignas(64) std::array<std::array<T, most_lanes>, most_amounts> amounts;
  alignas(64) std::array<T, most_lanes> steps;
};

/// Constants of a march, the same for all rays.
template <class T>
struct March {
  const MarchAir<T>& air;
  T refractivity, step_m;
};

}  // namespace
}  // namespace coppermoon::photons
#endif

HWY_BEFORE_NAMESPACE();
namespace coppermoon::photons {
namespace {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// State of rays under way. Straight lines along x, and the bent rays' small differences from them, are stored
/// separately; heights are altitudes instead of radii, and directions are n t less the straight line's.
template <class D>
struct Rays {
  using V = hn::Vec<D>;
  V along_m, height_m;              // of the straight lines
  V along_shift_m, height_shift_m;  // of the rays, from those
  V forward, upward;                // n t − (1, 0)
  V step_m;                         // 0 for a ray that has left
  V reduced_m, pull;                // q of the equation above; latest change of `upward`
  V lower_m, upper_m, layer;        // the layer of air they are in
  V steps;
};

template <class D>
struct Kernel {
  using T = hn::TFromD<D>;
  using V = hn::Vec<D>;
  using M = hn::Mask<D>;
  static constexpr D d{};
  const March<T>& march;
  V radius_inverse, half_radius_inverse, refractivity_over_radius;

  explicit Kernel(const March<T>& m)
      : march(m),
        radius_inverse(hn::Set(d, 1 / m.air.earth_radius_m)),
        half_radius_inverse(hn::Set(d, 1 / (2 * m.air.earth_radius_m))),
        refractivity_over_radius(hn::Set(d, m.refractivity / m.air.earth_radius_m)) {}

  V gather(const std::vector<T>& from, V index, std::size_t term = 0) const {
    const hn::RebindToSigned<D> di;
    return hn::GatherIndex(d, from.data() + term, hn::ConvertTo(di, index));
  }

  V reduced(V along_m, V height_m) const {
    const V square = hn::MulAdd(along_m, along_m, hn::Mul(height_m, height_m));
    return hn::MulAdd(square, half_radius_inverse, height_m);
  }

  V along(const Rays<D>& rays) const { return hn::Add(rays.along_m, rays.along_shift_m); }
  V height(const Rays<D>& rays) const { return hn::Add(rays.height_m, rays.height_shift_m); }

  /// Bends rays towards denser air, along x and y.
  void pull(Rays<D>& rays, V strength) const {
    const V upward = hn::Mul(strength, hn::MulAdd(height(rays), radius_inverse, hn::Set(d, 1)));
    rays.forward = hn::MulAdd(hn::Mul(strength, along(rays)), radius_inverse, rays.forward);
    rays.upward = hn::Add(rays.upward, upward);
    rays.pull = upward;
  }

  void add(std::array<T, most_lanes>& sum, V value, V weight) const {
    hn::Store(hn::MulAdd(value, weight, hn::Load(d, sum.data())), d, sum.data());
  }

  /// Looks up the air, bends the rays, and adds to their amounts.
  void kick(Rays<D>& rays, V length_m, Lanes<T>& lanes) const {
    const auto& air = march.air;
    const V bounded =
        hn::Min(hn::Max(rays.reduced_m, hn::Set(d, air.lowest_m)), hn::Set(d, air.highest_m));
    const V place = hn::MulAdd(bounded, hn::Set(d, air.cells_per_m),
                               hn::Add(rays.layer, hn::Set(d, air.cells_below_ground)));
    const V cell = hn::Floor(place), f = hn::Sub(place, cell);
    const V first = hn::Mul(cell, hn::Set(d, static_cast<T>(air.terms())));
    const V c0 = gather(air.cells, first, 0), c1 = gather(air.cells, first, 1),
            c2 = gather(air.cells, first, 2), c3 = gather(air.cells, first, 3);
    const V density = hn::MulAdd(hn::MulAdd(hn::MulAdd(c3, f, c2), f, c1), f, c0);
    const V two_c2 = hn::Add(c2, c2), three_c3 = hn::Mul(hn::Set(d, 3), c3);
    const V slope = hn::MulAdd(hn::MulAdd(three_c3, f, two_c2), f, c1);
    const V weight = hn::MulAdd(hn::Mul(hn::Set(d, march.refractivity), density), length_m,
                                length_m);  // n Δσ
    pull(rays, hn::Mul(hn::Mul(hn::Set(d, march.refractivity * air.cells_per_m), slope), weight));
    add(lanes.amounts[0], density, weight);
    for (std::size_t k = 0; k < air.others.size(); ++k) {
      const std::size_t term = MarchAir<T>::density_terms + 2 * k;
      const V value =
          hn::MulAdd(gather(air.cells, first, term + 1), f, gather(air.cells, first, term));
      add(lanes.amounts[k + 1], value, weight);
    }
  }

  /// Arrival of rays at a border between layers of the air within the latest step.
  struct Arrival {
    V border;  // number of the layer below it
    V sign;    // 1 upwards, −1 downwards
    V step_m;  // 0 for rays that do not arrive
    V left;    // fraction of the step beyond the border
    V rise;    // change of q in a whole step, absolute
  };

  /// Place of arrival within the step; q is taken to be a parabola along it.
  Arrival arrival(const Rays<D>& rays, V before_m, M crossing) const {
    const V zero = hn::Zero(d), one = hn::Set(d, 1);
    const M up = hn::And(crossing, hn::Ge(rays.reduced_m, rays.upper_m));
    const V border = hn::IfThenElse(up, rays.layer, hn::Max(zero, hn::Sub(rays.layer, one)));
    const V sign = hn::IfThenElse(up, one, hn::Neg(one));
    const V nearest_m = hn::IfThenElse(up, rays.upper_m, rays.lower_m);
    const V e = hn::IfThenElseZero(crossing, hn::Sub(nearest_m, before_m));
    const V g = hn::Mul(hn::Mul(rays.step_m, rays.step_m), half_radius_inverse);
    const V b = hn::Sub(hn::Sub(rays.reduced_m, before_m), g);
    const V four_ge = hn::Mul(hn::Mul(hn::Set(d, 4), g), e);
    const V rise = hn::Sqrt(hn::Max(zero, hn::MulAdd(b, b, four_ge)));
    const V below = hn::MulAdd(sign, rise, b);
    const M out_again = hn::And(up, hn::Lt(b, zero));
    const V gone = hn::Div(hn::IfThenElse(out_again, hn::Sub(rise, b), hn::Add(e, e)),
                           hn::IfThenElse(out_again, hn::Add(g, g), below));
    const V left = hn::IfThenElse(hn::Eq(below, zero), one, hn::Sub(one, gone));
    return {border, sign, hn::IfThenElseZero(crossing, rays.step_m),
            hn::Min(hn::Max(left, zero), one), rise};
  }

  /// Corrects the sums for jumps of the air, by the terms of Euler and Maclaurin (B₁ of the fraction left for
  /// values, B₂/2 for slopes), and moves the rays into the next layer.
  void cross(Rays<D>& rays, const Arrival& at, Lanes<T>& lanes) const {
    const auto& air = march.air;
    const V row = hn::Mul(at.border, hn::Set(d, static_cast<T>(air.terms_of_border())));
    const V density = gather(air.borders, row, 0), jump = gather(air.borders, row, 1),
            slope = gather(air.borders, row, 2), curvature = gather(air.borders, row, 3);
    const V refractivity = hn::Set(d, march.refractivity), half = hn::Set(d, T(0.5));
    const V weight = hn::MulAdd(hn::Mul(refractivity, density), at.step_m, at.step_m);
    const V square = hn::Mul(at.left, at.left);
    const V first = hn::Mul(hn::Mul(at.sign, hn::Sub(at.left, half)), weight);
    // FAULT Bernoulli's second number: T(1) / 6 => T(1) / 5
    const V bernoulli_2 = hn::Add(hn::Sub(square, at.left), hn::Set(d, T(1) / 6));
    const V second = hn::Mul(hn::Mul(hn::Mul(bernoulli_2, half), at.rise), weight);
    const V last = rays.pull;
    pull(rays, hn::Mul(refractivity, hn::MulAdd(slope, first, hn::Mul(curvature, second))));
    const V turn = hn::Mul(refractivity, hn::Mul(at.sign, hn::Mul(slope, at.step_m)));
    rays.pull = hn::Add(last, turn);
    const V moment = hn::MulSub(half, square, hn::Set(d, T(1) / 12));
    rays.height_shift_m = hn::MulAdd(hn::Mul(turn, at.step_m), moment, rays.height_shift_m);
    add(lanes.amounts[0], hn::Set(d, 1), hn::MulAdd(jump, first, hn::Mul(slope, second)));
    for (std::size_t k = 0; k < air.others.size(); ++k)
      add(lanes.amounts[k + 1], gather(air.borders, row, MarchAir<T>::border_terms + k), first);
    const V moved = hn::IfThenElseZero(hn::Gt(at.step_m, hn::Zero(d)), at.sign);
    enter(rays, hn::Add(rays.layer, moved));
  }

  void enter(Rays<D>& rays, V layer) const {
    rays.layer = layer;
    rays.lower_m = gather(march.air.lower_m, layer);
    rays.upper_m = gather(march.air.upper_m, layer);
    const V space = hn::Set(d, static_cast<T>(march.air.upper_m.size() - 1));
    rays.step_m = hn::IfThenElseZero(hn::Lt(layer, space), rays.step_m);
  }

  void drift(Rays<D>& rays, Lanes<T>& lanes) const {
    rays.along_m = hn::Add(rays.along_m, rays.step_m);
    rays.along_shift_m = hn::MulAdd(rays.step_m, rays.forward, rays.along_shift_m);
    rays.height_shift_m = hn::MulAdd(rays.step_m, rays.upward, rays.height_shift_m);
    rays.steps = hn::Add(rays.steps, rays.step_m);
    const V before_m = rays.reduced_m;
    // The step advances w = x − x'' Δσ² / 12.
    // FAULT a marched height off by a sixtieth of its last change: step_m / 12 => step_m / 10
    const V height_m = hn::MulAdd(rays.pull, hn::Set(d, march.step_m / 12), height(rays));
    rays.reduced_m = reduced(along(rays), height_m);
    while (true) {
      const M crossing =
          hn::Or(hn::Lt(rays.reduced_m, rays.lower_m), hn::Ge(rays.reduced_m, rays.upper_m));
      if (HWY_LIKELY(hn::AllFalse(d, crossing))) return;
      cross(rays, arrival(rays, before_m, crossing), lanes);
    }
  }

  /// Rays at the top of the air, at the beginning of a step into it.
  Rays<D> entering(Lanes<T>& lanes) const {
    const V zero = hn::Zero(d), step_m = hn::Set(d, march.step_m);
    const V space = hn::Set(d, static_cast<T>(march.air.upper_m.size() - 1));
    const V top = hn::Sub(space, hn::Set(d, 1));
    Rays<D> rays{hn::Load(d, lanes.along_m.data()),
                 hn::Load(d, lanes.height_m.data()),
                 zero,
                 zero,
                 hn::Load(d, lanes.forward.data()),
                 zero,
                 step_m,
                 zero,
                 zero,
                 zero,
                 zero,
                 space,
                 zero};
    rays.reduced_m = reduced(along(rays), height(rays));
    const V rise = hn::Mul(hn::Mul(hn::Abs(rays.along_m), step_m), radius_inverse);
    cross(rays, {top, hn::Set(d, -1), step_m, hn::Set(d, 1), rise}, lanes);
    rays.height_shift_m = rays.pull = zero;
    return rays;
  }

  void follow(Lanes<T>& lanes) const {
    for (auto& sum : lanes.amounts) sum.fill(0);
    Rays<D> rays = entering(lanes);
    do {
      drift(rays, lanes);
      kick(rays, rays.step_m, lanes);
    } while (!hn::AllTrue(d, hn::Eq(rays.step_m, hn::Zero(d))));
    hn::Store(rays.forward, d, lanes.forward.data());
    hn::Store(rays.upward, d, lanes.upward.data());
    hn::Store(rays.steps, d, lanes.steps.data());
  }
};

template <class T>
using Tag = hn::CappedTag<T, most_lanes>;

std::size_t lanes_of_double() { return hn::Lanes(Tag<double>()); }
std::size_t lanes_of_float() { return hn::Lanes(Tag<float>()); }
void follow_double(const March<double>& march, Lanes<double>& lanes) {
  Kernel<Tag<double>>(march).follow(lanes);
}
void follow_float(const March<float>& march, Lanes<float>& lanes) {
  Kernel<Tag<float>>(march).follow(lanes);
}

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace coppermoon::photons
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace coppermoon::photons {
namespace {

HWY_EXPORT(lanes_of_double);
HWY_EXPORT(lanes_of_float);
HWY_EXPORT(follow_double);
HWY_EXPORT(follow_float);

std::size_t lanes_of(double) { return HWY_DYNAMIC_DISPATCH(lanes_of_double)(); }
std::size_t lanes_of(float) { return HWY_DYNAMIC_DISPATCH(lanes_of_float)(); }
void follow_lanes(const March<double>& march, Lanes<double>& lanes) {
  HWY_DYNAMIC_DISPATCH(follow_double)(march, lanes);
}
void follow_lanes(const March<float>& march, Lanes<float>& lanes) {
  HWY_DYNAMIC_DISPATCH(follow_float)(march, lanes);
}

/// Points where straight lines of given impact heights meet the top of the air.
template <class T>
void set_out(const March<T>& march, std::span<const LimbPath> paths, Lanes<T>& lanes) {
  const auto& air = march.air;
  const double radius_m = air.earth_radius_m, inside = march.refractivity * air.density_at_top();
  for (std::size_t i = 0; i < most_lanes; ++i) {
    const double impact_m = paths[std::min(i, paths.size() - 1)].impact_height_m;
    const double u = impact_m - inside * (radius_m + impact_m);
    const double square = 2 * radius_m * (air.highest_m - u) - u * u;
    lanes.along_m[i] = static_cast<T>(-std::sqrt(std::max(0., square)));
    lanes.height_m[i] = static_cast<T>(u);
    lanes.forward[i] = static_cast<T>(inside);
  }
}

/// Returned  number of steps, all rays together
template <class T>
std::uint64_t followed(const March<T>& march, std::span<LimbPath> paths) {
  const std::size_t width = lanes_of(T{});
  Lanes<T> lanes;
  std::uint64_t steps = 0;
  for (std::size_t first = 0; first < paths.size(); first += width) {
    const auto group = paths.subspan(first, std::min(width, paths.size() - first));
    set_out(march, group, lanes);
    follow_lanes(march, lanes);
    for (std::size_t i = 0; i < group.size(); ++i) {
      group[i].bending_rad = std::atan2(-lanes.upward[i], 1 + lanes.forward[i]);
      group[i].amounts[atmosphere::air] = lanes.amounts[0][i];
      for (std::size_t k = 0; k < march.air.others.size(); ++k)
        group[i].amounts[march.air.others[k]] = lanes.amounts[k + 1][i];
      steps += static_cast<std::uint64_t>(lanes.steps[i] / march.step_m + T(0.5));
    }
  }
  return steps;
}

}  // namespace

Marcher::Marcher(const atmosphere::Column& column, double earth_radius_m, const Marching& marching)
    : column_(column), earth_radius_m_(earth_radius_m), step_m_(marching.step_m) {
  algebra::require_within("step [m]", step_m_, 1, 1e5);
  algebra::require_within("Earth's radius [m]", earth_radius_m, 1e6, 1e7);
  if (marching.precision == Precision::full) {
    air_ = march_air<double>(column, earth_radius_m);
    return;
  }
  constexpr double floats_in_a_metre = 8;  // so that sums of steps are exact over 2000 km
  step_m_ = std::round(step_m_ * floats_in_a_metre) / floats_in_a_metre;
  air_ = march_air<float>(column, earth_radius_m);
}

std::uint64_t Marcher::follow(std::span<const double> tangent_heights_m, double refractivity,
                              std::span<LimbPath> paths) const {
  algebra::require_within("refractivity", refractivity, 0, 1e-3);
  if (paths.size() != tangent_heights_m.size())
    throw algebra::Error(fmt::format("paths = {}, allowed {}, as many as tangent heights",
                                     paths.size(), tangent_heights_m.size()));
  const double bends = column_.refraction ? refractivity : 0;
  const double top_m = atmosphere::top_m(column_);
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const double h = tangent_heights_m[i];
    algebra::require_within("tangent height [m]", h, 0, top_m);
    paths[i] = {
        h, h + bends * atmosphere::density_ratio(column_, h).value * (earth_radius_m_ + h), 0, {}};
  }
  if (top_m == 0) return 0;
  return std::visit(
      [&]<class T>(const MarchAir<T>& air) {
        const March<T> march{air, static_cast<T>(bends), static_cast<T>(step_m_)};
        return followed(march, paths);
      },
      air_);
}

}  // namespace coppermoon::photons
#endif
