// SPDX-License-Identifier: MIT
#include "uses/light/planning.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <thread>

#include "algebra/error.h"
#include "almanac/lunar_orientation.h"
#include "atmosphere/presets.h"
#include "colour/cie_observer.h"
#include "photons/earth_limb.h"
#include "shadow/twilight.h"
#include "uses/light/spectral_bands.h"

namespace coppermoon::uses {
namespace {

using std::numbers::pi;

const double lunar_radius_m = algebra::in_metres(almanac::lunar_radius);

/// Places of the Moon's centre: all those on its path, or the only one if there is no path.
std::span<const eclipse::ShadowPlace> centres(const ShadowedMoon& moon) {
  return moon.path.empty() ? std::span(&moon.centre, 1) : std::span(moon.path);
}

/// Depth of the plane midway through the half of the Moon that faces the Sun.
double mean_depth_m(const ShadowedMoon& moon) {
  return algebra::in_metres(moon.centre.depth) - lunar_radius_m / 2;
}

struct Range {
  double from_m, to_m;
};

/// Axis distance beyond which nothing blocks sunlight.
constexpr double farthest_m = 1.2e7;

/// Range of axis distances that the Moon's disc covers, along the whole path if there is one.
Range disc_of(const ShadowedMoon& moon) {
  Range disc{farthest_m, 0};
  for (const auto& place : centres(moon)) {
    const double centre = algebra::in_metres(place.axis_distance);
    disc.from_m = std::min(disc.from_m, std::max(0., centre - lunar_radius_m));
    disc.to_m = std::max(disc.to_m, centre + lunar_radius_m);
  }
  if (!moon.path.empty()) disc.to_m = std::clamp(disc.to_m, disc.from_m + 1, farthest_m);
  return disc;
}

/// Number of sample places across a range: `a_diameter` for each lunar diameter, and at least that many.
int places_over(Range disc, int a_diameter) {
  const double diameters = (disc.to_m - disc.from_m) / (2 * lunar_radius_m);
  return static_cast<int>(std::ceil(a_diameter * std::max(1., diameters) - 1e-9));
}

std::vector<double> evenly(Range range, int intervals) {
  std::vector<double> all;
  for (int i = 0; i <= intervals; ++i)
    all.push_back(range.from_m + (range.to_m - range.from_m) * i / intervals);
  return all;
}

constexpr std::size_t sectors_of_a_trial = 24;

/// Sectors around the shadow's axis that the Moon's disc covers when its centre is at the given place.
shadow::Sectors sectors_of(const eclipse::ShadowPlace& place, std::size_t around) {
  const double centre = algebra::in_metres(place.axis_distance);
  if (centre <= lunar_radius_m) return {around};
  const double half = std::asin(lunar_radius_m / centre),
               middle = algebra::in_radians(place.position_angle);
  return shadow::between_angles(around, middle - half, middle + half);
}

/// Sectors around the shadow's axis that the disc covers along its whole path: all except those in the widest gap.
shadow::Sectors sectors_of(const ShadowedMoon& moon, std::size_t around) {
  std::vector<shadow::Sectors> taken;
  for (const auto& place : centres(moon)) taken.push_back(sectors_of(place, around));
  const shadow::Sectors all{around};
  shadow::Sectors widest{around, 0, 0};  // widest gap so far
  for (std::size_t first = 0; first < around; ++first) {
    const auto is_taken = [&](std::size_t i) {
      return std::ranges::any_of(taken,
                                 [&](const auto& some) { return some.hold(all[first + i]); });
    };
    std::size_t gap = 0;
    while (gap < around && !is_taken(gap)) ++gap;
    if (gap > widest.count) widest = {around, first, gap};
  }
  return {around, widest[widest.count], around - widest.count};
}

/// Makes the air uniform around the limb. If it has belts, the column at the Moon's position angle is used everywhere.
atmosphere::Atmosphere of_one_column(const atmosphere::Atmosphere& air,
                                     const eclipse::ShadowPlace& moon) {
  auto one = air;
  one.regions.clear();
  if (air.belts.empty()) return one;
  const auto share = one.shares_at(algebra::in_radians(moon.position_angle))[0];
  one.column = one.belts[share.column].column;
  one.belts.clear();
  return one;
}

/// Luminance relative to that in unshadowed sunlight, in each sector that the disc covers.
struct CoarseLight {
  std::vector<std::vector<double>> refracted, direct;  ///< [sector][place]
};

/// A rough estimate of the light on the disc, with few rays and bands.
CoarseLight tried(const ShadowedMoon& moon, const atmosphere::Atmosphere& whole,
                  std::span<const double> places_m) {
  const auto air = with_fewer_belts(whole);
  constexpr int bands = 10;
  const auto waves = wavelengths_nm(bands);
  const auto weights = at_wavelengths(luminance_weights(), bands);
  double sunlight = 0;
  for (const double w : weights.row(0)) sunlight += w;
  const auto luminance = [&](std::span<const double> ratio) {
    double sum = 0;
    for (std::size_t w = 0; w < ratio.size(); ++w) sum += weights(0, w) * ratio[w];
    return std::max(sum, 0.) / sunlight;
  };
  const auto arrangement = arrangement_of(moon, {mean_depth_m(moon)});
  const auto sectors = sectors_of(moon, sectors_of_a_trial);
  const auto light = shadow::by_quadrature(air, arrangement, waves, places_m,
                                           {.rays = 100, .sun_terms = 2, .sectors = sectors});
  const shadow::DirectLight clear(air, arrangement, waves);
  CoarseLight coarse;
  std::vector<double> ratios(waves.size());
  const auto computed = sectors.in(light.sectors);
  for (std::size_t i = 0; i < computed.count; ++i) {
    const std::size_t s = computed[i];
    const double angle = computed.angle_rad(s);
    auto &refracted = coarse.refracted.emplace_back(), &direct = coarse.direct.emplace_back();
    for (std::size_t d = 0; d < places_m.size(); ++d) {
      refracted.push_back(luminance(light.ratio[s].row(d)));
      clear.ratios(places_m[d], angle, arrangement.depths_m[0], ratios);
      direct.push_back(luminance(ratios));
    }
  }
  return coarse;
}

/// Largest relative change in luminance on the disc if a term is left out.
double largest_change(const CoarseLight& all, const CoarseLight& without) {
  double worst = 0;
  for (std::size_t s = 0; s < all.refracted.size(); ++s)
    for (std::size_t d = 0; d < all.direct[s].size(); ++d) {
      const std::size_t k = s % without.refracted.size();
      const double there = all.refracted[s][d] + all.direct[s][d],
                   left = without.refracted[k][d] + without.direct[k][d];
      if (there > 0)
        worst = std::max(worst, std::abs(there - left) / there);
      else if (left > 0)
        worst = std::max(worst, 1.);
    }
  return worst;
}

/// Share of the total light that is scattered light, where the disc is darkest. If an upper bound on the share is
/// negligible, the bound is returned, and no scattered light is computed.
double scattered_share(const ShadowedMoon& moon, const CoarseLight& coarse,
                       std::span<const double> places_m) {
  constexpr double most = 1.2e-6, counts = 1e-5;
  double darkest = std::numeric_limits<double>::max();
  std::size_t where = 0;
  for (std::size_t d = 0; d < places_m.size(); ++d)
    for (std::size_t s = 0; s < coarse.refracted.size(); ++s)
      if (const double here = coarse.refracted[s][d] + coarse.direct[s][d]; here < darkest)
        darkest = here, where = d;
  if (moon.air.top_m() <= 0) return 0;
  if (most / darkest < counts) return most / darkest;
  const std::array wavelengths{560.};
  const auto scattered = shadow::twilight(moon.air, arrangement_of(moon, {mean_depth_m(moon)}),
                                          wavelengths, places_m.subspan(where, 1));
  double share = 0;
  for (const auto& grid : scattered.ratio) share = std::max(share, grid(0, 0));
  return share > 0 ? share / (darkest + share) : 0;
}

/// Ratio of scattered light to unshadowed sunlight at 560 nm, at the brightest position angle for each axis distance.
std::vector<double> scattered_at(std::span<const double> places_m,
                                 const atmosphere::Atmosphere& air,
                                 const shadow::Arrangement& arrangement) {
  const std::array wavelengths{560.};
  const std::size_t sectors = air.one_column() ? 1 : shadow::sectors_around;
  auto light = shadow::darkness(arrangement, wavelengths, places_m, sectors);
  shadow::add_twilight(light, air);
  std::vector<double> most(places_m.size());
  for (const auto& grid : light.ratio)
    for (std::size_t d = 0; d < most.size(); ++d) most[d] = std::max(most[d], grid(d, 0));
  return most;
}

/// Adds axis distances where light is least smooth: between the umbra's edges for the Earth's polar and equatorial
/// radii, where direct light begins, and just inside the penumbra's edge, where it changes fastest.
void add_edges_of_the_shadow(const ShadowedMoon& moon, const shadow::Arrangement& arrangement,
                             Range disc, std::vector<double>& places_m) {
  constexpr double a_node_m = 10e3, within_penumbra_m = 150e3;
  constexpr int umbral_intervals = 7, penumbral_intervals = 3;
  const double depth = arrangement.depths_m[0], spread = 1 + depth / moon.sun_distance_m,
               solar_m = projected_solar_radius_m(arrangement, depth);
  const auto shadow_m = [&](double position_angle_rad) {
    const double limb = atmosphere::limb_at(moon.air.earth, position_angle_rad).radius_m;
    return (limb + moon.air.top_m()) * spread;
  };
  const double pole_m = shadow_m(0), equator_m = shadow_m(pi / 2);
  const auto add = [&](Range edge, int intervals) {
    for (const double place : evenly(edge, intervals))
      if (place > disc.from_m && place < disc.to_m) places_m.push_back(place);
  };
  add({pole_m - solar_m, equator_m - solar_m + a_node_m}, umbral_intervals);
  add({pole_m + solar_m - within_penumbra_m, equator_m + solar_m}, penumbral_intervals);
  std::ranges::sort(places_m);
  places_m.erase(std::unique(places_m.begin(), places_m.end()), places_m.end());
}

/// Safety factor on the effect of a term, because light computed with coarse settings underestimates the effect.
constexpr double margin = 2;

}  // namespace

void require_knobs(const plan::ByHand& by_hand) {
  const auto within = [](const char* what, const auto& value, double low, double high) {
    if (value) algebra::require_within(what, static_cast<double>(*value), low, high);
  };
  within("bands", by_hand.bands, 1, 400);
  within("rays", by_hand.rays, 2, 1e7);
  within("sun terms", by_hand.sun_terms, 1, 6);
  within("planes", by_hand.planes, 1, 9);
  within("place error", by_hand.place_error, 1e-5, 1);
}

shadow::Arrangement arrangement_of(const ShadowedMoon& moon, std::vector<double> depths_m) {
  return {moon.sun_distance_m, std::move(depths_m), moon.limb_darkening};
}

std::vector<double> depths_of(const ShadowedMoon& moon, int planes) {
  if (planes == 1) return {mean_depth_m(moon)};
  const auto [nearest, farthest] = std::ranges::minmax(
      centres(moon), {}, [](const auto& place) { return algebra::in_metres(place.depth); });
  const double from = algebra::in_metres(nearest.depth) - lunar_radius_m,
               to = algebra::in_metres(farthest.depth), spacing = lunar_radius_m / (planes - 1);
  const int intervals = static_cast<int>(std::ceil((to - from) / spacing - 1e-9));
  std::vector<double> depths;
  for (int i = 0; i <= intervals; ++i)
    depths.push_back(to - (to - from) * (intervals - i) / intervals);
  return depths;
}

std::vector<double> distances_over_the_disc(const ShadowedMoon& moon) {
  constexpr double spacing_m = 200e3, beyond_m = 50e3;
  auto range = disc_of(moon);
  range.from_m = std::max(0., range.from_m - beyond_m);
  range.to_m += beyond_m;
  return evenly(range, static_cast<int>(std::ceil((range.to_m - range.from_m) / spacing_m)));
}

atmosphere::Atmosphere air_for(const plan::Work& work, const ShadowedMoon& moon) {
  auto air = moon.air;
  if (!work.ellipsoid && !air.earth.sphere()) {
    const double radius =
        atmosphere::limb_at(air.earth, algebra::in_radians(moon.centre.position_angle)).radius_m;
    air.earth = {radius, radius, air.earth.sun_declination_rad};
  }
  if (!work.regions && !air.one_column()) air = of_one_column(air, moon.centre);
  return air;
}

shadow::QuadratureSettings quadrature_for(const plan::Work& work, const ShadowedMoon& moon,
                                          std::size_t around) {
  return {.rays = work.rays,
          .sun_terms = work.sun_terms,
          .sectors = sectors_of(moon, around).widened(),  // interpolation needs neighbours
          .place_error = work.place_error};
}

plan::Scene scene_of(const ShadowedMoon& moon, const Purpose& purpose) {
  const auto disc = disc_of(moon);
  plan::Scene scene{.nearest_m = disc.from_m,
                    .farthest_m = disc.to_m,
                    .limb_darkening = moon.limb_darkening,
                    .ellipsoid = !moon.air.earth.sphere(),
                    .columns = moon.air.columns().size(),
                    .parts = photons::parts_of_limb(moon.air),
                    .borders = !moon.air.regions.empty(),
                    .texels = purpose.texels,
                    .map_file = purpose.map_file};
  const auto places = evenly(disc, places_over(disc, 12));
  const auto coarse = tried(moon, moon.air, places);
  CoarseLight direct_alone = coarse;
  for (auto& row : direct_alone.refracted) std::ranges::fill(row, 0);
  scene.without_refracted = largest_change(coarse, direct_alone);
  const bool air_by_place = scene.without_refracted > 0 && scene.columns > 1;
  if (scene.ellipsoid || air_by_place) {
    plan::Work one_column;
    one_column.regions = false;
    const auto alike = tried(moon, air_for(one_column, moon), places);
    if (air_by_place) scene.without_regions = margin * largest_change(coarse, alike);
    if (scene.ellipsoid) {  // its effect is the same in uniform air, computed four times faster
      auto sphere = one_column;
      sphere.ellipsoid = false;
      scene.without_ellipsoid =
          margin * largest_change(alike, tried(moon, air_for(sphere, moon), places));
    }
  }
  scene.without_refracted = std::min(1., margin * scene.without_refracted);
  scene.without_scattered = margin * scattered_share(moon, coarse, places);
  return scene;
}

plan::Machine this_machine() {
  constexpr double seconds_elsewhere = 0.95e-3;
  const std::vector<double> waves{400, 450, 500, 550, 600, 650, 700, 750};
  std::vector<double> places;
  for (double d = 1e6; d < 5e6; d += 2e5) places.push_back(d);
  double least = std::numeric_limits<double>::max();
  for (int i = 0; i < 3; ++i) {
    const auto start = std::chrono::steady_clock::now();
    shadow::by_quadrature({}, {1.479e11, {3.83e8}}, waves, places, {.rays = 60});
    least = std::min(
        least, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return {seconds_elsewhere / least,
          std::max(1, static_cast<int>(std::thread::hardware_concurrency()))};
}

shadow::ChannelWeights luminance_weights() {
  const auto xyz = colour::xyz_weights(band_edges_nm());
  shadow::ChannelWeights luminance(1, xyz.columns());
  std::ranges::copy(xyz.row(1), luminance.row(0).begin());
  return moonlight_weights(luminance);
}

namespace {

/// The depth that is farthest from all planes, where interpolation between planes errs most.
double depth_between_planes(const ShadowedMoon& moon, int planes) {
  if (planes == 1) return mean_depth_m(moon) + lunar_radius_m / 2;
  const auto depths = depths_of(moon, planes);
  return std::midpoint(depths[depths.size() - 2], depths.back());
}

/// Settings for the light against which errors are measured. Its number of sectors has no divisor in common with a
/// plan's, so that the middles of sectors do not coincide. With regions there are fewer, because each takes more time.
shadow::QuadratureSettings settings_of_check(const plan::Work& finer, const ShadowedMoon& moon) {
  const std::size_t around = moon.air.regions.empty() ? 29 : 13;
  auto settings = quadrature_for(finer, moon, around);
  const auto taken_in = sectors_of(moon, sectors_of_a_plan);
  if (taken_in.all()) return settings;
  const std::size_t first = (taken_in.first * around + sectors_of_a_plan - 1) / sectors_of_a_plan,
                    end = (taken_in.first + taken_in.count - 1) * around / sectors_of_a_plan + 1;
  settings.sectors = {around, first % around, end > first ? end - first : 1};
  return settings;
}

/// Reference light with which a look-up is compared to find its error.
class ExactLight {
 public:
  ExactLight(const ShadowedMoon& moon, const plan::Work& work, double depth_m,
             const ScatteredInCheck& scattered)
      : depth_m_(depth_m),
        settings_(settings_of_check(finer(work), moon)),
        weights_(at_wavelengths(luminance_weights(), finer(work).bands)) {
    constexpr double off_nodes = 0.07;  // [lunar radii]; away from places where light was computed
    const auto disc = disc_of(moon);
    auto places =
        evenly({disc.from_m + off_nodes * lunar_radius_m, disc.to_m}, places_over(disc, 15));
    // If the disc does not reach the axis, its darkest place is added, where the relative error of direct light peaks.
    if (disc.from_m > 0) places.insert(places.begin(), disc.from_m);
    const auto arrangement = arrangement_of(moon, {depth_m});
    add_edges_of_the_shadow(moon, arrangement, disc, places);
    const auto waves = wavelengths_nm(finer(work).bands);
    light_ = shadow::by_quadrature(moon.air, arrangement, waves, places, settings_);
    left_out_.resize(light_.axis_distances_m.size());
    if (scattered.computed)
      shadow::add_between(*scattered.computed, light_);
    else if (scattered.counts)
      left_out_ = scattered_at(light_.axis_distances_m, moon.air, arrangement);
    clear_.emplace(moon.air, arrangement, waves);
    for (const double weight : weights_.row(0)) sunlight_ += weight;
    middle_rad_ = algebra::in_radians(moon.centre.position_angle);
  }

  std::size_t sectors() const { return computed().count; }
  std::span<const double> places_m() const { return light_.axis_distances_m; }
  double sunlight() const { return sunlight_; }

  double angle_rad(std::size_t i) const {
    return light_.sectors == 1 ? middle_rad_ : computed().angle_rad(computed()[i]);
  }

  double luminance(std::size_t i, std::size_t place) const {
    double sum = direct(i, places_m()[place]);
    const auto ratio = light_.ratio[computed()[i]].row(place);
    for (std::size_t w = 0; w < ratio.size(); ++w)
      sum += weights_(0, w) * (ratio[w] + left_out_[place]);
    return sum;
  }

  double direct(std::size_t i, double place_m) const {
    std::vector<double> ratios(weights_.columns());
    clear_->ratios(place_m, angle_rad(i), depth_m_, ratios);
    double sum = 0;
    for (std::size_t w = 0; w < ratios.size(); ++w) sum += weights_(0, w) * ratios[w];
    return sum;
  }

 private:
  shadow::Sectors computed() const { return settings_.sectors.in(light_.sectors); }

  double depth_m_;
  shadow::QuadratureSettings settings_;
  shadow::ChannelWeights weights_;
  shadow::RefractedLight light_;
  std::vector<double> left_out_;
  std::optional<shadow::DirectLight> clear_;
  double sunlight_ = 0, middle_rad_;
};

}  // namespace

double error_found(const ShadowedMoon& moon, const plan::Work& work,
                   const shadow::Lookup& luminance, const ScatteredInCheck& scattered) {
  constexpr double a_node_m = 1e3;
  const double depth = depth_between_planes(moon, work.planes);
  const ExactLight light(moon, work, depth, scattered);
  const double dark = shadow::darkness_ratio * light.sunlight();
  std::array<double, 1> found;
  double worst = 0;
  for (std::size_t i = 0; i < light.sectors(); ++i)
    for (std::size_t d = 0; d < light.places_m().size(); ++d) {
      const double place = light.places_m()[d], exact = light.luminance(i, d);
      luminance.read({.axis_distance = algebra::metres(place),
                      .position_angle = algebra::radians(light.angle_rad(i)),
                      .depth = algebra::metres(depth)},
                     found);
      const double lit = exact > dark ? exact : std::max(found[0], dark),
                   error = std::abs(found[0] - exact) / lit;
      if (error <= worst) continue;
      const bool from_nothing = exact - light.direct(i, place) <= dark;
      const auto begins_at = [&](double m) { return light.direct(i, std::max(0., m)) <= dark; };
      if (from_nothing && begins_at(place - a_node_m) && !begins_at(place + a_node_m)) continue;
      worst = error;
    }
  return worst;
}

}  // namespace coppermoon::uses
