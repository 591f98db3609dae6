// SPDX-License-Identifier: MIT
#include "shadow/marched_photons.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shadow/marched_photons.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <hwy/contrib/math/math-inl.h>

#include <algorithm>
#include <numbers>

#include "shadow/photon_rows.h"

#ifndef COPPERMOON_MARCHED_SPECTRA
#define COPPERMOON_MARCHED_SPECTRA
namespace coppermoon::shadow {
namespace {

/// Spectra of one part of the limb, (…, wavelength).
struct Spectra {
  const algebra::Grid<float>&refractivity, &shares, &extinction, &filter;
};

/// Output rows of one photon.
struct Written {
  float *impact_m, *bending_rad, *light;
};

}  // namespace
}  // namespace coppermoon::shadow
#endif

HWY_BEFORE_NAMESPACE();
namespace coppermoon::shadow {
namespace {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using algebra::Grid;

using Floats = hn::CappedTag<float, 16>;
using Vector = hn::Vec<Floats>;
constexpr Floats floats;

/// Weighted sum of rows at a vector of wavelengths.
HWY_INLINE Vector combined(const float* numbers, const Grid<float>& rows, std::size_t w) {
  const float* values = rows.values().data();
  auto sum = hn::Zero(floats);
  for (std::size_t k = 0; k < rows.rows(); ++k)  // none where nothing absorbs
    sum = hn::MulAdd(hn::Set(floats, numbers[k]),
                     hn::LoadU(floats, values + k * rows.columns() + w), sum);
  return sum;
}

void pass_one(const MarchedPhoton& photon, const Spectra& spectra, const Written& to) {
  const auto one = hn::Set(floats, 1.f);
  const float* filter = spectra.filter.row(photon.filter).data();
  for (std::size_t w = 0; w < spectra.filter.columns(); w += hn::Lanes(floats)) {
    const auto refractivity = hn::LoadU(floats, spectra.refractivity.values().data() + w);
    const auto b = hn::MulAdd(refractivity, hn::Set(floats, photon.excess_m),
                              hn::Set(floats, photon.radius_m));
    const auto db_dh = hn::MulAdd(refractivity, hn::Set(floats, photon.excess_slope), one);
    const auto depth = combined(photon.amounts.data(), spectra.extinction, w);
    const auto transmittance =
        hn::Mul(hn::LoadU(floats, filter + w), hn::Exp(floats, hn::Neg(depth)));
    const auto area = hn::Mul(hn::Mul(hn::Set(floats, photon.weight_m), b), db_dh);
    hn::StoreU(b, floats, to.impact_m + w);
    hn::StoreU(combined(photon.bending_rad.data(), spectra.shares, w), floats, to.bending_rad + w);
    hn::StoreU(hn::Mul(area, transmittance), floats, to.light + w);
  }
}

/// Tangent of a small angle: tan ε = ε + ε³/3 + 2ε⁵/15 + 17ε⁷/315.
HWY_INLINE Vector tangent(Vector angle) {
  const auto square = hn::Mul(angle, angle);
  const auto third = hn::MulAdd(hn::Set(floats, 17.f / 315), square, hn::Set(floats, 2.f / 15));
  const auto second = hn::MulAdd(third, square, hn::Set(floats, 1.f / 3));
  return hn::MulAdd(hn::Mul(second, square), angle, angle);
}

void land_one(std::span<const float> impact_m, std::span<const float> bending_rad,
              float sun_distance_m, float depth_m, std::span<float> landing_m) {
  const auto nearness = hn::Set(floats, 1 / sun_distance_m);
  for (std::size_t w = 0; w < impact_m.size(); w += hn::Lanes(floats)) {
    const auto b = hn::LoadU(floats, &impact_m[w]);
    const auto slope = tangent(hn::MulSub(b, nearness, hn::LoadU(floats, &bending_rad[w])));
    const auto length = hn::Sqrt(hn::MulAdd(slope, slope, hn::Set(floats, 1.f)));
    const auto r = hn::MulAdd(hn::Set(floats, depth_m), slope, hn::Mul(b, length));
    hn::StoreU(r, floats, &landing_m[w]);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace coppermoon::shadow
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace coppermoon::shadow {
namespace {

HWY_EXPORT(pass_one);
HWY_EXPORT(land_one);

/// Refractivities at which photons are marched: those of the wavelengths where these are few.
std::vector<double> nodes_of(const atmosphere::Column& column,
                             std::span<const atmosphere::Optics> optics) {
  if (!column.refraction || optics.size() > march_nodes)
    return photons::refractivity_nodes(column, optics, march_nodes);
  std::vector<double> nodes;
  for (const auto& o : optics) nodes.push_back(o.refractivity);
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

/// Absorbers whose spectrum is not 0 at some wavelength.
std::vector<std::size_t> absorbers_at_work(const atmosphere::Column& column,
                                           std::span<const atmosphere::Optics> optics) {
  std::vector<std::size_t> at_work;
  for (std::size_t a = 0; a < atmosphere::absorbers; ++a)
    if (std::ranges::any_of(optics,
                            [&](const auto& o) { return atmosphere::spectra(column, o)[a] > 0; }))
      at_work.push_back(a);
  return at_work;
}

}  // namespace

MarchedRows::MarchedRows(std::size_t photons, std::size_t waves)
    : impact_m(photons, padded(waves)), bending_rad(impact_m), light(impact_m) {}

MarchedPhotons::MarchedPhotons(std::span<const photons::WholeLimb::Part> parts,
                               std::span<const atmosphere::Optics> optics,
                               const photons::Marching& marching) {
  for (const auto& part : parts) parts_.push_back(part_of(part, optics, marching));
}

MarchedPhotons::Part MarchedPhotons::part_of(const photons::WholeLimb::Part& limb,
                                             std::span<const atmosphere::Optics> optics,
                                             const photons::Marching& marching) {
  const auto nodes = nodes_of(limb.column, optics);
  const auto at_work = absorbers_at_work(limb.column, optics);
  const std::size_t width = padded(optics.size());
  Part part{limb.radius_m,
            limb.curvature_radius_m,
            limb.column,
            nodes,
            at_work,
            algebra::Grid<float>(1, width),
            algebra::Grid<float>(nodes.size(), width),
            algebra::Grid<float>(nodes.size() * at_work.size(), width),
            algebra::Grid<float>(2, width),
            photons::Marcher(limb.column, limb.curvature_radius_m, marching)};
  for (std::size_t w = 0; w < width; ++w) {
    // padding lands where the last wavelength does, without light
    const auto wave = photons::blend(limb.column, optics[std::min(w, optics.size() - 1)], nodes);
    part.refractivity(0, w) = static_cast<float>(wave.refractivity);
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      part.shares(k, w) = static_cast<float>(wave.shares[k]);
      for (std::size_t a = 0; a < at_work.size(); ++a)
        part.extinction(k * at_work.size() + a, w) =
            static_cast<float>(wave.extinction[k][at_work[a]]);
    }
    if (w >= optics.size()) continue;
    part.filter(0, w) = static_cast<float>(wave.cloudy);
    part.filter(1, w) = static_cast<float>(wave.clear);
  }
  return part;
}

void MarchedPhotons::follow(const Part& part, std::span<const Aim> aims,
                            std::vector<MarchedPhoton>& photons) {
  const double top_m = atmosphere::top_m(part.column);  // other columns may end higher
  std::vector<double> heights_m;
  const std::size_t first = photons.size();
  for (const auto& aim : aims) {
    const double h = aim.tangent_height_m;
    const auto excess = photons::optical_excess_m(part.column, part.curvature_radius_m, h);
    heights_m.push_back(std::min(h, top_m));
    photons.push_back({aim.part,
                       static_cast<float>(part.radius_m + h),
                       static_cast<float>(excess.value),
                       static_cast<float>(excess.slope_per_m),
                       static_cast<float>(2 * std::numbers::pi * aim.weight_m),
                       h < part.column.cloud_top_m ? 0U : 1U,
                       {},
                       {}});
  }
  std::vector<photons::LimbPath> paths(aims.size());
  for (std::size_t k = 0; k < part.nodes.size(); ++k) {
    part.marcher.follow(heights_m, part.nodes[k], paths);
    for (std::size_t i = 0; i < paths.size(); ++i) {
      auto& photon = photons[first + i];
      photon.bending_rad[k] = static_cast<float>(paths[i].bending_rad);
      for (std::size_t a = 0; a < part.absorbers.size(); ++a)
        photon.amounts[k * part.absorbers.size() + a] =
            static_cast<float>(paths[i].amounts[part.absorbers[a]]);
    }
  }
}

std::vector<MarchedPhoton> MarchedPhotons::followed(std::span<const Aim> aims) const {
  std::vector<MarchedPhoton> photons;
  photons.reserve(aims.size());
  while (!aims.empty()) {
    const std::size_t part = aims.front().part;
    const auto next = std::ranges::find_if(aims, [&](const Aim& a) { return a.part != part; });
    const auto count = static_cast<std::size_t>(next - aims.begin());
    follow(parts_[part], aims.first(count), photons);
    aims = aims.subspan(count);
  }
  return photons;
}

void MarchedPhotons::pass(std::span<const MarchedPhoton> photons, MarchedRows& rows) const {
  for (std::size_t i = 0; i < photons.size(); ++i) {
    const auto& part = parts_[photons[i].part];
    const Spectra spectra{part.refractivity, part.shares, part.extinction, part.filter};
    const Written to{rows.impact_m.row(i).data(), rows.bending_rad.row(i).data(),
                     rows.light.row(i).data()};
    HWY_DYNAMIC_DISPATCH(pass_one)(photons[i], spectra, to);
  }
}

void land(const MarchedRows& rows, std::size_t photons, double sun_distance_m, double depth_m,
          algebra::Grid<float>& landing_m) {
  for (std::size_t i = 0; i < photons; ++i) HWY_DYNAMIC_DISPATCH(land_one)
  (rows.impact_m.row(i), rows.bending_rad.row(i), static_cast<float>(sun_distance_m),
   static_cast<float>(depth_m), landing_m.row(i));
}

}  // namespace coppermoon::shadow
#endif  // HWY_ONCE
