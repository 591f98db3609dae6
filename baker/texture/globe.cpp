// SPDX-License-Identifier: MIT
#include "texture/globe.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/globe.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "atmosphere/figure.h"
#include "eclipse/shadow_axis.h"
#include "surface/albedo_map.h"
#include "surface/ground.h"

HWY_BEFORE_NAMESPACE();
namespace coppermoon::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class D>
hn::VFromD<D> at_texel(D d, const TexelRow& row, const AlongRow& quantity, std::size_t i) {
  const auto constant = hn::MulAdd(hn::Set(d, quantity.cosine), hn::LoadU(d, row.cos_longitude + i),
                                   hn::Set(d, quantity.constant));
  return hn::MulAdd(hn::Set(d, quantity.sine), hn::LoadU(d, row.sin_longitude + i), constant);
}

/// A position between two neighbouring entries in a table.
template <class D>
struct Between {
  hn::VFromD<hn::RebindToSigned<D>> index;
  hn::VFromD<D> part;

  hn::VFromD<D> in(D d, const std::vector<double>& table) const {
    const auto a = hn::GatherIndex(d, table.data(), index),
               b = hn::GatherIndex(d, table.data() + 1, index);
    return hn::MulAdd(part, hn::Sub(b, a), a);
  }
};

/// Phase factor, interpolated in a table over sin(g/2). The phase angle g is at least the Earth's angular radius.
template <class D, class V = hn::VFromD<D>>
V phase_factor(D d, const Globe& globe, V cos_phase, V distance_squared, const float* surge) {
  const auto one = hn::Set(d, 1);
  const auto sine_squared =
      hn::Div(hn::Set(d, globe.earth_sine * globe.earth_sine), distance_squared);
  const auto cosine = hn::Min(cos_phase, hn::Sqrt(hn::Sub(one, sine_squared)));
  const auto half_sine =
      hn::Sqrt(hn::Max(hn::Mul(hn::Set(d, 0.5), hn::Sub(one, cosine)), hn::Zero(d)));
  const auto last = static_cast<double>(globe.phase_factors.size() - 1);
  const auto node = hn::Min(hn::Mul(half_sine, hn::Set(d, last)), hn::Set(d, last));
  const auto low = hn::Min(hn::Floor(node), hn::Set(d, last - 1));
  const Between<D> between{hn::ConvertTo(hn::RebindToSigned<D>(), low), hn::Sub(node, low)};
  const auto mean = between.in(d, globe.phase_factors);
  if (surge == nullptr) return mean;
  const auto stronger = hn::PromoteTo(d, hn::LoadU(hn::Rebind<float, D>(), surge));
  return hn::MulAdd(stronger, between.in(d, globe.surge_factors), mean);
}

/// Reflected light for albedo 1, relative to white ground. s and m are the dot products of the ground's normal with
/// globe.sun and globe.moon. `sun` and `earth` are distances from the ground, relative to those from the Moon's centre.
template <class D, class V = hn::VFromD<D>>
V reflected(D d, const Globe& globe, V s, V m, const float* surge) {
  const auto set = [d](double value) { return hn::Set(d, value); };
  const auto one = set(1), rho = set(globe.sun_ratio), kappa = set(globe.earth_ratio);
  const auto sun_squared = hn::MulAdd(hn::Mul(set(-2), rho), s, hn::MulAdd(rho, rho, one));
  const auto earth_squared = hn::MulAdd(hn::Mul(set(2), kappa), m, hn::MulAdd(kappa, kappa, one));
  const auto sun = hn::Sqrt(sun_squared), earth = hn::Sqrt(earth_squared);
  const auto cos_incidence = hn::Div(hn::Sub(s, rho), sun);
  const auto cos_emission = hn::Max(hn::Div(hn::Neg(hn::Add(m, kappa)), earth), hn::Zero(d));
  const auto towards_sun = hn::MulAdd(kappa, s, set(globe.sun_cos_earth));
  const auto along_both = hn::Sub(towards_sun, hn::MulAdd(rho, m, hn::Mul(rho, kappa)));
  const auto cos_phase = hn::Div(hn::Neg(along_both), hn::Mul(sun, earth));
  const auto& law = globe.law;
  const auto denominator =
      hn::MulAdd(set(law.incidence), cos_incidence,
                 hn::MulAdd(set(law.emission), cos_emission, set(law.constant)));
  const auto numerator = hn::Mul(set(law.scale * globe.inverse_square), cos_incidence);
  return hn::Mul(hn::Div(numerator, hn::Mul(denominator, sun_squared)),
                 phase_factor(d, globe, cos_phase, earth_squared, surge));
}

/// Computes the light of as many texels as D has lanes, starting with texel i.
template <class D>
bool light_lanes(D d, const Globe& globe, const TexelRow& row, std::size_t i,
                 const LitTexels& lit) {
  const hn::Rebind<float, D> floats;
  const auto albedo = hn::PromoteTo(d, hn::LoadU(floats, row.albedo + i));
  const auto s = at_texel(d, row, row.sun, i), m = at_texel(d, row, row.moon, i);
  const auto facing =
      hn::And(hn::Gt(s, hn::Set(d, globe.sun_ratio)), hn::Lt(m, hn::Set(d, globe.beyond_the_limb)));
  const auto is_lit = hn::And(facing, hn::Not(hn::Le(albedo, hn::Zero(d))));
  hn::StoreU(at_texel(d, row, row.east, i), d, &lit.east_m[i]);
  hn::StoreU(at_texel(d, row, row.north, i), d, &lit.north_m[i]);
  hn::StoreU(at_texel(d, row, row.depth, i), d, &lit.depth_m[i]);
  const bool none = hn::AllFalse(d, is_lit);
  const auto* surge = row.surge == nullptr ? nullptr : row.surge + i;
  const auto light = none ? hn::Zero(d) : hn::Mul(albedo, reflected(d, globe, s, m, surge));
  hn::StoreU(hn::IfThenElseZero(is_lit, light), d, &lit.reflected[i]);
  return !none;
}

bool light_all(const Globe& globe, const TexelRow& row, const LitTexels& lit) {
  const hn::ScalableTag<double> many;
  const hn::CappedTag<double, 1> one;
  const std::size_t lanes = hn::Lanes(many), count = lit.reflected.size();
  bool any = false;
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes) any = light_lanes(many, globe, row, i, lit) || any;
  for (; i < count; ++i) any = light_lanes(one, globe, row, i, lit) || any;
  return any;
}

}  // namespace coppermoon::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace coppermoon::texture {
namespace {

HWY_EXPORT(light_all);

constexpr std::size_t phase_steps = 4096;

Globe::Direction direction(const glm::dvec3& v, double constant = 0) {
  return {v.x, v.y, v.z, constant};
}

}  // namespace

Globe::Globe(const almanac::SkyState& sky, std::size_t texture_rows, surface::Photometry photometry,
             double limb)
    : rows(texture_rows), beyond_the_limb(limb), law(surface::cosine_law(photometry)) {
  const double radius_m = algebra::in_metres(almanac::lunar_radius);
  const glm::dvec3 to_sun_m = sky.sun_m - sky.moon_m;
  const double sun_m = glm::length(to_sun_m), earth_m = glm::length(sky.moon_m);
  const auto& turned = sky.selenographic_from_gcrs;
  sun = direction(turned * (to_sun_m / sun_m));
  moon = direction(turned * (sky.moon_m / earth_m));
  sun_ratio = radius_m / sun_m;
  earth_ratio = radius_m / earth_m;
  sun_cos_earth = glm::dot(to_sun_m, sky.moon_m) / (sun_m * earth_m);
  earth_sine = atmosphere::earth_equatorial_radius_m / earth_m;
  inverse_square = std::pow(almanac::astronomical_unit_m / sun_m, 2);
  const auto axis = eclipse::shadow_axis(sky);
  const auto centre_m = axis.shadow_from_gcrs * sky.moon_m;
  const auto frame_m = radius_m * turned * glm::transpose(axis.shadow_from_gcrs);
  east = direction(frame_m[0], centre_m.x);
  north = direction(frame_m[1], centre_m.y);
  depth = direction(frame_m[2], centre_m.z);
  for (std::size_t c = 0; c < 2 * rows; ++c) {
    const double longitude = algebra::in_radians(surface::texel_centre(0, c, rows).longitude);
    cos_longitude.push_back(std::cos(longitude));
    sin_longitude.push_back(std::sin(longitude));
  }
  for (std::size_t i = 0; i <= phase_steps; ++i) {
    const auto phase = algebra::radians(2 * std::asin(static_cast<double>(i) / phase_steps));
    phase_factors.push_back(surface::phase_factor(photometry, phase));
    surge_factors.push_back(phase_factors.back() * surface::surge_slope(photometry, phase));
  }
}

AlongRow Globe::along_row(std::size_t row, const Direction& v) const {
  const double latitude = algebra::in_radians(surface::texel_centre(row, 0, rows).latitude);
  const double cosine = std::cos(latitude);
  return {v.constant + v.z * std::sin(latitude), v.x * cosine, v.y * cosine};
}

bool light_texels(const Globe& globe, std::size_t row, std::size_t column,
                  std::span<const float> albedo, std::span<const float> surge,
                  const LitTexels& lit) {
  return HWY_DYNAMIC_DISPATCH(light_all)(
      globe,
      {globe.along_row(row, globe.sun), globe.along_row(row, globe.moon),
       globe.along_row(row, globe.east), globe.along_row(row, globe.north),
       globe.along_row(row, globe.depth), &globe.cos_longitude[column],
       &globe.sin_longitude[column], albedo.data(), surge.empty() ? nullptr : surge.data()},
      lit);
}

}  // namespace coppermoon::texture
#endif
