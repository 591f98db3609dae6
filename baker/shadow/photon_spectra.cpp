// SPDX-License-Identifier: MIT
#include "shadow/photon_spectra.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shadow/photon_spectra.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <hwy/contrib/math/math-inl.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shadow/sectors.h"

HWY_BEFORE_NAMESPACE();
namespace coppermoon::shadow::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using algebra::Grid;

using Floats = hn::CappedTag<float, 16>;
using Vector = hn::Vec<Floats>;
using Whole = hn::RebindToSigned<Floats>;
constexpr Floats floats;

HWY_INLINE Vector at(const Between& place, std::size_t width, std::size_t w) {
  const auto first = hn::LoadU(floats, place.first + w);
  const auto next = hn::LoadU(floats, place.first + width + w);
  return hn::Mul(hn::Set(floats, place.factor),
                 hn::MulAdd(hn::Set(floats, place.along), hn::Sub(next, first), first));
}

void interpolate(std::span<const Between> places, Grid<float>& rows) {
  const std::size_t width = rows.columns();
  for (std::size_t i = 0; i < places.size(); ++i) {
    float* row = rows.row(i).data();
    for (std::size_t w = 0; w < width; w += hn::Lanes(floats))
      hn::StoreU(at(places[i], width, w), floats, row + w);
  }
}

void multiply(std::span<const Between> places, Grid<float>& rows) {
  const std::size_t width = rows.columns();
  for (std::size_t i = 0; i < places.size(); ++i) {
    float* row = rows.row(i).data();
    for (std::size_t w = 0; w < width; w += hn::Lanes(floats))
      hn::StoreU(hn::Mul(hn::LoadU(floats, row + w), at(places[i], width, w)), floats, row + w);
  }
}

/// Position angle [rad] from the y axis towards x, −π to π.
HWY_INLINE Vector position_angle(Vector x, Vector y) {
  constexpr float pi = std::numbers::pi_v<float>;
  const auto across = hn::Abs(x), along = hn::Abs(y);
  const auto larger = hn::Max(hn::Max(across, along), hn::Set(floats, 1e-30f));
  const auto least = hn::Atan(floats, hn::Div(hn::Min(across, along), larger));
  const auto quarter =
      hn::IfThenElse(hn::Gt(across, along), hn::Sub(hn::Set(floats, pi / 2), least), least);
  const auto half =
      hn::IfThenElse(hn::Lt(y, hn::Zero(floats)), hn::Sub(hn::Set(floats, pi), quarter), quarter);
  return hn::CopySign(half, x);
}

HWY_INLINE Vector sector_of(Vector x, Vector y, std::size_t sectors) {
  const auto all = hn::Set(floats, static_cast<float>(sectors));
  const auto turn =
      hn::Mul(position_angle(x, y), hn::Set(floats, 0.5f / std::numbers::pi_v<float>));
  const auto nearest = hn::Floor(hn::MulAdd(turn, all, hn::Set(floats, 0.5f)));
  return hn::IfThenElse(hn::Lt(nearest, hn::Zero(floats)), hn::Add(nearest, all), nearest);
}

/// Row of the tally, within one plane, in which each wavelength of a photon lands.
HWY_INLINE hn::Vec<Whole> row_of(Vector x, Vector y, const Rings& rings) {
  const auto distance = hn::Sqrt(hn::MulAdd(x, x, hn::Mul(y, y)));
  const auto beyond = hn::Set(floats, static_cast<float>(rings.rings));
  const auto ring =
      hn::Min(hn::Floor(hn::Mul(distance, hn::Set(floats, 1 / rings.width_m))), beyond);
  if (rings.sectors == 1) return hn::ConvertTo(Whole(), ring);
  const auto rows_a_sector = hn::Set(floats, static_cast<float>(rings.rings + 1));
  return hn::ConvertTo(Whole(), hn::MulAdd(sector_of(x, y, rings.sectors), rows_a_sector, ring));
}

HWY_INLINE void add_to(std::size_t cell, Vector light, std::size_t w, Tally& tally) {
  float* sums = tally.light.row(cell).data() + w;
  hn::StoreU(hn::Add(hn::LoadU(floats, sums), light), floats, sums);
  tally.touched[cell] = 1;
}

/// Adds the light of a vector of wavelengths to the tally, once for each row where it lands (mostly one or two rows).
HWY_INLINE void add(hn::Vec<Whole> rows, Vector light, std::size_t first_row, std::size_t w,
                    Tally& tally) {
  const Whole whole;
  std::int32_t row = hn::GetLane(rows);
  auto here = hn::Eq(rows, hn::Set(whole, row));
  if (hn::AllTrue(whole, here))
    return add_to(first_row + static_cast<std::size_t>(row), light, w, tally);
  HWY_ALIGN std::int32_t all[16];
  hn::Store(rows, whole, all);
  for (auto left = hn::Not(here);; left = hn::AndNot(here, left)) {
    add_to(first_row + static_cast<std::size_t>(row),
           hn::IfThenElseZero(hn::RebindMask(floats, here), light), w, tally);
    if (hn::AllFalse(whole, left)) return;
    row = all[hn::FindKnownFirstTrue(whole, left)];
    here = hn::Eq(rows, hn::Set(whole, row));
  }
}

void gather(std::span<const Aside> photons, const Grid<float>& landing_m, const Grid<float>& light,
            const Rings& rings, std::size_t first_row, Tally& tally) {
  for (std::size_t i = 0; i < photons.size(); ++i) {
    const auto toward_x = hn::Set(floats, photons[i].toward_x);
    const auto toward_y = hn::Set(floats, photons[i].toward_y);
    const auto source_x = hn::Set(floats, photons[i].source_x_m);
    const auto source_y = hn::Set(floats, photons[i].source_y_m);
    for (std::size_t w = 0; w < landing_m.columns(); w += hn::Lanes(floats)) {
      const auto r = hn::LoadU(floats, landing_m.row(i).data() + w);
      const auto x = hn::MulSub(r, toward_x, source_x), y = hn::MulSub(r, toward_y, source_y);
      add(row_of(x, y, rings), hn::LoadU(floats, light.row(i).data() + w), first_row, w, tally);
    }
  }
}

/// Adds one row of light to `sums` and its squares to `squares`, and clears the row. Each step takes half a vector of
/// floats, because doubles are twice as wide.
void drain_row(std::span<float> light, std::span<double> sums, std::span<double> squares) {
  using Doubles = hn::CappedTag<double, 8>;
  const Doubles doubles;
  const hn::Rebind<float, Doubles> halves;
  std::size_t w = 0;
  for (; w + hn::Lanes(doubles) <= sums.size(); w += hn::Lanes(doubles)) {
    const auto x = hn::PromoteTo(doubles, hn::LoadU(halves, &light[w]));
    hn::StoreU(hn::Add(hn::LoadU(doubles, &sums[w]), x), doubles, &sums[w]);
    hn::StoreU(hn::MulAdd(x, x, hn::LoadU(doubles, &squares[w])), doubles, &squares[w]);
  }
  for (; w < sums.size(); ++w) {
    const double x = light[w];
    sums[w] += x;
    squares[w] += x * x;
  }
  std::fill(light.begin(), light.end(), 0.f);
}

void drain(Tally& tally, Grid<double>& sums, Grid<double>& squares) {
  for (std::size_t row = 0; row < tally.touched.size(); ++row) {
    if (tally.touched[row] == 0) continue;
    drain_row(tally.light.row(row), sums.row(row), squares.row(row));
    tally.touched[row] = 0;
  }
}

}  // namespace
}  // namespace coppermoon::shadow::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace coppermoon::shadow {

HWY_EXPORT(interpolate);
HWY_EXPORT(multiply);
HWY_EXPORT(gather);
HWY_EXPORT(drain);

void interpolate(std::span<const Between> places, algebra::Grid<float>& rows) {
  HWY_DYNAMIC_DISPATCH(interpolate)(places, rows);
}

void multiply(std::span<const Between> places, algebra::Grid<float>& rows) {
  HWY_DYNAMIC_DISPATCH(multiply)(places, rows);
}

std::size_t Rings::row(double x_m, double y_m) const {
  const auto ring = static_cast<std::size_t>(std::hypot(x_m, y_m) / width_m);
  return Sectors{sectors}.nearest(std::atan2(x_m, y_m)) * (rings + 1) + std::min(ring, rings);
}

void gather(std::span<const Aside> photons, const algebra::Grid<float>& landing_m,
            const algebra::Grid<float>& light, const Rings& rings, std::size_t first_row,
            Tally& tally) {
  HWY_DYNAMIC_DISPATCH(gather)(photons, landing_m, light, rings, first_row, tally);
}

void drain(Tally& tally, algebra::Grid<double>& sums, algebra::Grid<double>& squares) {
  HWY_DYNAMIC_DISPATCH(drain)(tally, sums, squares);
}

}  // namespace coppermoon::shadow
#endif  // HWY_ONCE
