// SPDX-License-Identifier: MIT
#include "uses/explore/limb_rays.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "algebra/interpolation.h"
#include "atmosphere/ozone.h"
#include "photons/bending.h"
#include "photons/earth_limb.h"
#include "shadow/twilight.h"

namespace coppermoon::uses {
namespace {

using atmosphere::Column;
using nlohmann::ordered_json;

constexpr int refractivities = 3;

/// Number of harmonics in the series that describe the limb by position angle. For air with latitude belts, they give
/// the light to within 0.2 %. Borders of regions are smoothed over about ten degrees.
constexpr int most_harmonics = 24;

std::vector<double> tangent_heights_m(const atmosphere::Atmosphere& air) {
  std::vector<double> heights;
  for (const auto& [to, step] : {std::pair{30e3, 200.}, {60e3, 500.}, {86e3, 2e3}})
    for (double h = heights.empty() ? 0 : heights.back() + step; h <= to && h <= air.top_m();
         h += step)
      heights.push_back(h);
  for (const auto* column : air.columns()) {  // adds heights at the edges of dust and cloud layers
    if (column->dust_extinction_per_m > 0)
      heights.insert(heights.end(), {column->dust_bottom_m, column->dust_top_m});
    if (column->cloud_cover > 0) heights.push_back(column->cloud_top_m);
  }
  heights.push_back(air.top_m());
  std::sort(heights.begin(), heights.end());
  const auto same = [](double a, double b) { return b - a < 1; };
  heights.erase(std::unique(heights.begin(), heights.end(), same), heights.end());
  return heights;
}

/// Whether ozone is treated as a filter that has the same optical depth for every ray.
bool ozone_filters(const Column& column) {
  return column.ozone_du > 0 && column.ozone_path == atmosphere::OzonePath::filter;
}

void set_aerosol(Column& column, double depth) {
  column.stratosphere = atmosphere::StratosphericAerosol::none;
  column.stratospheric_layer =
      std::make_shared<atmosphere::StratosphericLayer>(depth, column.tropopause_m);
}

/// Data on the rays past one part of the limb, in the order of the page's arrays.
struct PartRays {
  std::vector<double> bending, excess_km, amounts, spectra, aerosol;
};

/// Concatenates one of the arrays in PartRays for all parts of the limb.
std::vector<double> joined(const std::vector<PartRays>& parts,
                           std::vector<double> PartRays::*rows) {
  std::vector<double> all;
  for (const auto& part : parts) all.insert(all.end(), (part.*rows).begin(), (part.*rows).end());
  return all;
}

/// Traces the rays past one part of the limb.
struct Follower {
  std::vector<double> heights_m, nodes;
  std::vector<atmosphere::Optics> optics;

  PartRays rays(const photons::WholeLimb::Part& part) const {
    PartRays rays;
    const auto& column = part.column;
    const photons::ProfileTable table(column);
    std::vector<std::vector<photons::LimbPath>> paths;  // [height][refractivity]
    for (const double height : heights_m)
      paths.push_back(photons::limb_paths(height, part.curvature_radius_m, column, nodes, &table));
    for (std::size_t node = 0; node < nodes.size(); ++node)
      for (auto& of_height : paths) {
        auto& [h, impact, bending, amounts] = of_height[node];
        if (ozone_filters(column)) amounts[atmosphere::ozone] = 1;
        rays.bending.push_back(bending);
        rays.amounts.insert(rays.amounts.end(), amounts.begin(), amounts.end());
      }
    for (const double height : heights_m)
      rays.excess_km.push_back(
          photons::optical_excess_m(column, part.curvature_radius_m, height).value / 1e3);
    add_spectra(column, rays);
    add_aerosol(part, rays);
    return rays;
  }

  void add_spectra(const Column& column, PartRays& rays) const {
    for (const auto& o : optics) {
      auto spectra = atmosphere::spectra(column, o);
      if (ozone_filters(column))
        spectra[atmosphere::ozone] = -std::log(atmosphere::ozone_filter_yapo_cutler(
            algebra::nanometres(o.wavelength_nm), column.ozone_du));
      rays.spectra.insert(rays.spectra.end(), spectra.begin(), spectra.end());
    }
  }

  /// Adds the optical depths of stratospheric aerosol along rays that are traced at the middle refractivity.
  void add_aerosol(const photons::WholeLimb::Part& part, PartRays& rays) const {
    const double middle = nodes[(nodes.size() - 1) / 2];  // without the last node, which is 0
    for (const double depth : aerosol_steps) {
      Column hazy = part.column;
      set_aerosol(hazy, depth);
      const photons::ProfileTable table(hazy);
      for (const double height : heights_m)
        rays.aerosol.push_back(
            photons::limb_path(height, part.curvature_radius_m, hazy, middle, &table)
                .amounts[atmosphere::stratosphere]);
    }
  }
};

double stratospheric_depth(const Column& column) {
  if (column.stratospheric_layer) return column.stratospheric_layer->optical_depth();
  constexpr std::array depths{0., 0.008, 0.028, 0.086, 0.262};  // one for each StratosphericAerosol
  return depths[static_cast<std::size_t>(column.stratosphere)];
}

ordered_json facts_of(const photons::WholeLimb::Part& part) {
  const auto& column = part.column;
  return {{"radiusKm", part.radius_m / 1e3},
          {"ozoneDu", column.ozone_du},
          {"aerosolDepth", stratospheric_depth(column)},
          {"aerosolRecorded",
           column.stratospheric_layer != nullptr && column.stratospheric_layer->recorded()},
          {"cloudTopKm", column.cloud_top_m / 1e3},
          {"cloudCover", column.cloud_cover}};
}

void add_series(PageArrays& arrays, const photons::WholeLimb& limb) {
  const auto series = limb.series(most_harmonics);
  algebra::Grid<double> numbers(2 * series.size(), series[0].cosine.size());
  for (std::size_t p = 0; p < series.size(); ++p) {
    std::ranges::copy(series[p].cosine, numbers.row(2 * p).begin());
    std::ranges::copy(series[p].sine, numbers.row(2 * p + 1).begin());
  }
  arrays.add("limb.series", {series.size(), 2, numbers.columns()}, numbers.values());
}

void add_spectra_of_aerosol(PageArrays& arrays, std::span<const double> wavelengths_nm) {
  constexpr double any_tropopause_m = 11e3;
  algebra::Grid<double> spectra(std::size(aerosol_steps), wavelengths_nm.size());
  for (std::size_t s = 0; s < spectra.rows(); ++s) {
    const atmosphere::StratosphericLayer layer(aerosol_steps[s], any_tropopause_m);
    std::ranges::transform(wavelengths_nm, spectra.row(s).begin(),
                           [&](double nm) { return layer.spectrum(algebra::nanometres(nm)); });
  }
  arrays.add("limb.aerosolSpectra", spectra);
}

/// Adds the spectrum of the month's recorded stratospheric aerosol for each of aerosol_steps; 0 if there is no record.
void add_recorded_spectra(PageArrays& arrays, const photons::WholeLimb& limb,
                          std::span<const double> wavelengths_nm) {
  std::vector<double> numbers;
  for (const auto& part : limb.parts()) {
    const auto& layer = part.column.stratospheric_layer;
    const bool recorded = layer && layer->recorded() && layer->optical_depth() > 0;
    for (const double depth : aerosol_steps)
      for (const double nm : wavelengths_nm)
        numbers.push_back(
            recorded ? layer->spectrum(algebra::nanometres(nm), depth / layer->optical_depth())
                     : 0);
  }
  arrays.add("limb.recordedSpectra",
             {limb.parts().size(), std::size(aerosol_steps), wavelengths_nm.size()}, numbers);
}

/// Returns the air with its stratospheric aerosol replaced by a layer of the same optical depth everywhere.
atmosphere::Atmosphere with_aerosol(atmosphere::Atmosphere air, double depth) {
  const auto set = [&](Column& column, atmosphere::Belts& belts) {
    set_aerosol(column, depth);
    for (auto& belt : belts) set_aerosol(belt.column, depth);
  };
  set(air.column, air.belts);
  for (auto& region : air.regions) set(region.column, region.belts);
  return air;
}

}  // namespace

ordered_json add_limb_rays(PageArrays& arrays, const atmosphere::Atmosphere& atmosphere,
                           std::span<const double> wavelengths_nm) {
  Follower follower{
      tangent_heights_m(atmosphere), {}, shadow::optics_of(atmosphere, wavelengths_nm)};
  // one wavelength and two rays are enough, because only the limb's division into parts is needed
  const photons::WholeLimb limb(atmosphere, std::span(follower.optics).first(1), 2);
  const auto& first = limb.parts()[0].column;
  follower.nodes = photons::refractivity_nodes(first, follower.optics, refractivities);
  const std::size_t bent = follower.nodes.size(), parts = limb.parts().size(),
                    rays = follower.heights_m.size(), waves = wavelengths_nm.size();
  algebra::Grid<double> blends(waves, bent);
  for (std::size_t w = 0; w < waves; ++w)
    std::ranges::copy(photons::blend(first, follower.optics[w], follower.nodes).shares,
                      blends.row(w).begin());
  follower.nodes.push_back(0);
  std::vector<PartRays> all(parts);
  tbb::parallel_for(std::size_t{0}, parts,
                    [&](std::size_t p) { all[p] = follower.rays(limb.parts()[p]); });
  ordered_json facts{{"absorbers", atmosphere::absorber_groups()},
                     {"aerosolSteps", aerosol_steps},
                     {"topKm", atmosphere.top_m() / 1e3},
                     {"refractivities", ordered_json::array()},
                     {"parts", ordered_json::array()}};
  for (const auto& part : limb.parts()) facts["parts"].push_back(facts_of(part));
  for (const auto& o : follower.optics) facts["refractivities"].push_back(o.refractivity);
  std::vector<double> heights_km;
  for (const double h : follower.heights_m) heights_km.push_back(h / 1e3);
  arrays.add("limb.heights", {rays}, heights_km);
  arrays.add("limb.bending", {parts, bent + 1, rays}, joined(all, &PartRays::bending));
  arrays.add("limb.excess", {parts, rays}, joined(all, &PartRays::excess_km));
  arrays.add("limb.amounts", {parts, bent + 1, rays, atmosphere::absorbers},
             joined(all, &PartRays::amounts));
  arrays.add("limb.spectra", {parts, waves, atmosphere::absorbers},
             joined(all, &PartRays::spectra));
  arrays.add("limb.aerosol", {parts, std::size(aerosol_steps), rays},
             joined(all, &PartRays::aerosol));
  arrays.add("limb.blend", blends);
  add_series(arrays, limb);
  add_spectra_of_aerosol(arrays, wavelengths_nm);
  add_recorded_spectra(arrays, limb, wavelengths_nm);
  return facts;
}

void add_scattered_light(PageArrays& arrays, const atmosphere::Atmosphere& atmosphere,
                         const shadow::Arrangement& arrangement,
                         std::span<const double> wavelengths_nm) {
  constexpr double step_m = 2000e3;
  std::vector<double> distances, waves;
  for (std::size_t w = 0; w < wavelengths_nm.size(); w += 2) waves.push_back(wavelengths_nm[w]);
  if (wavelengths_nm.size() % 2 == 0) waves.push_back(wavelengths_nm.back());
  const double end = shadow::refracted_reach_m(arrangement, atmosphere, arrangement.depths_m[0]);
  for (double d = 0; d < end + step_m; d += step_m) distances.push_back(d);
  std::vector<atmosphere::Atmosphere> airs{atmosphere, with_aerosol(atmosphere, 0)};
  for (const double depth : aerosol_steps) airs.push_back(with_aerosol(atmosphere, depth));
  std::vector<algebra::Grid<double>> all(airs.size());
  tbb::parallel_for(std::size_t{0}, airs.size(), [&](std::size_t i) {
    all[i] = shadow::mean_ratio(shadow::twilight(airs[i], arrangement, waves, distances));
  });
  std::vector<double> numbers;
  for (const auto& light : all)
    for (std::size_t d = 0; d < light.rows(); ++d)
      for (const double nm : wavelengths_nm)
        numbers.push_back(algebra::interpolated(waves, light.row(d), nm));
  arrays.add("scattered", {airs.size(), distances.size(), wavelengths_nm.size()}, numbers);
}

}  // namespace coppermoon::uses
